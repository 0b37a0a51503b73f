// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ADDRESS_MAP_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ADDRESS_MAP_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

namespace CGAL::Bubble_relaxation_2::internal {

/// Values by addresses, of vertices or faces. Handles are no keys for what may outlive them: CGAL compares some, and
/// hashes them, by what they point to. Copies share the values.
template <std::size_t n, class Value>
class Address_map
{
public:
  using Addresses = std::array<const void*, n>;

  explicit Address_map(const Value& by_default) : m_default(by_default) {}

  const Value& operator()(const Addresses& key) const
  {
    const auto found = m_values->find(key);
    return found == m_values->end() ? m_default : found->second;
  }

  void set(const Addresses& key, const Value& value) const { (*m_values)[key] = value; }
  void forget(const Addresses& key) const { m_values->erase(key); }
  void clear() const { m_values->clear(); }

private:
  struct Hash
  {
    std::size_t operator()(const Addresses& key) const
    {
      std::uint64_t hash = 0;
      for (const void* address : key)
        hash = hash_of_two(hash, reinterpret_cast<std::uintptr_t>(address));
      return static_cast<std::size_t>(hash);
    }
  };

  using Values = std::unordered_map<Addresses, Value, Hash>;

  Value m_default;
  std::shared_ptr<Values> m_values = std::make_shared<Values>();
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ADDRESS_MAP_H
