// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_INDEX_SETS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_INDEX_SETS_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Small sorted sets of indices, many of them in one array. A set that is appended has room for one more index; one
/// that grows larger than its room is moved to the end of the array, and leaves a gap.
class Index_sets
{
public:
  std::size_t size() const { return m_sets.size(); }

  const Index* begin(std::size_t i) const { return m_pool.data() + m_sets[i].first; }
  const Index* end(std::size_t i) const { return begin(i) + m_sets[i].size; }
  std::size_t size_of(std::size_t i) const { return m_sets[i].size; }

  /// starts without sets; makes room for `n`
  void start(std::size_t n)
  {
    m_sets.clear();
    m_pool.clear();
    m_sets.reserve(n);
    m_pool.reserve(usual_number * n);
  }

  /// makes room for `n` more sets
  void make_room_for(std::size_t n)
  {
    internal::make_room_for(n, m_sets);
    internal::make_room_for(usual_number * n, m_pool);
  }

  /// adds a set, of `n` indices that are sorted
  void append(const Index* set, std::size_t n)
  {
    const std::uint32_t size = static_cast<std::uint32_t>(n);
    const std::uint32_t capacity = size + 1; // few sets get more than one more
    internal::make_room_for(capacity, m_pool);
    m_sets.push_back(Set{m_pool.size(), size, capacity});
    m_pool.insert(m_pool.end(), set, set + n);
    m_pool.resize(m_pool.size() + capacity - size);
  }

  /// replaces a set by indices that are sorted
  void assign(std::size_t i, const std::vector<Index>& set)
  {
    make_room(i, set.size());
    std::copy(set.begin(), set.end(), m_pool.begin() + static_cast<std::ptrdiff_t>(m_sets[i].first));
    m_sets[i].size = static_cast<std::uint32_t>(set.size());
  }

  void clear(std::size_t i) { m_sets[i].size = 0; }

  /// adds an index to a set that has not got it; `before`: the order of the set
  template <class Before>
  void insert(std::size_t i, Index index, const Before& before)
  {
    make_room(i, m_sets[i].size + std::size_t(1));
    Set& s = m_sets[i];
    Index *first = m_pool.data() + s.first, *last = first + s.size;
    Index* position = std::lower_bound(first, last, index, before);
    std::copy_backward(position, last, last + 1);
    *position = index;
    ++s.size;
  }

  /// takes an index out of a set that has it
  template <class Before>
  void erase(std::size_t i, Index index, const Before& before)
  {
    Set& s = m_sets[i];
    Index *first = m_pool.data() + s.first, *last = first + s.size;
    Index* position = std::lower_bound(first, last, index, before);
    std::copy(position + 1, last, position);
    --s.size;
  }

private:
  /// so many indices are expected in a set, with its room
  static constexpr std::size_t usual_number = 12;

  /// `size` numbers in the pool from `first`, room for `capacity`
  struct Set
  {
    std::size_t first;
    std::uint32_t size, capacity;
  };

  /// moves a set that grows too large to the end of the pool
  void make_room(std::size_t i, std::size_t size)
  {
    Set& s = m_sets[i];
    if (size <= s.capacity)
      return;
    const std::size_t first = m_pool.size(), capacity = size + size / 2 + 1;
    internal::make_room_for(capacity, m_pool);
    m_pool.resize(first + capacity);
    s.capacity = static_cast<std::uint32_t>(capacity);
    std::copy_n(m_pool.begin() + static_cast<std::ptrdiff_t>(s.first), s.size,
                m_pool.begin() + static_cast<std::ptrdiff_t>(first));
    s.first = first;
  }

  std::vector<Set> m_sets;
  std::vector<Index> m_pool;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_INDEX_SETS_H
