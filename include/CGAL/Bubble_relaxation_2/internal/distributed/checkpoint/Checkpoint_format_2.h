// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FORMAT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FORMAT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/hash_of_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/same_options.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What stands at the beginning of a checkpoint. After it come the states of bubbles, along the curve.
struct Checkpoint_header_2
{
  static constexpr std::uint32_t own_byte_order = 0x01020304, own_version = 1;
  static constexpr std::array<char, 8> own_magic{{'N', 'P', 'B', 'S', '2', 'D', '\r', '\n'}};

  std::array<char, 8> magic;
  std::uint32_t byte_order, version;
  std::int64_t record_size, number_of_records;
  std::uint64_t hash_of_records, hash_of_domain;
  std::array<double, std::tuple_size<decltype(steering_parameters(Relaxation_options()))>::value> parameters;

  std::int64_t number_of_all; ///< that ever were, which is the number of the next
  std::int32_t is_coarse, is_roused;
  std::int64_t initial_bubbles, rounds, steps, force_evaluations, renewals;
  std::array<std::int64_t, 4> moves_returns_insertions_deletions;

  std::uint64_t hash_of_header; ///< of all before

  std::int64_t file_size() const
  {
    return static_cast<std::int64_t>(sizeof(Checkpoint_header_2)) + number_of_records * record_size;
  }

  std::uint64_t own_hash() const
  {
    Hash_of_numbers hash;
    const unsigned char* const first = reinterpret_cast<const unsigned char*>(this);
    std::for_each(first, reinterpret_cast<const unsigned char*>(&hash_of_header),
                  [&hash](unsigned char byte) { hash.add(byte); });
    return hash.value();
  }
};

static_assert(sizeof(Checkpoint_header_2) ==
                8 + 2 * 4 + 4 * 8 + sizeof(Checkpoint_header_2::parameters) + 8 + 2 * 4 + 9 * 8 + 8,
              "a header must not have gaps");

/// A record at its position among all. The sum over all records modulo 2^64 does not depend on who adds which.
inline std::uint64_t hash_of(const Bubble_state_2& record, std::int64_t position)
{
  Hash_of_numbers hash;
  hash.add(position);
  hash.add(record); // all its bytes
  return hash.value();
}

/// All that bubbles refer to by indices: the outline, its triangles, and pinned vertices.
inline std::uint64_t hash_of_places(const Domain_2& domain, const Given_mesh_2& given)
{
  Hash_of_numbers hash;
  hash.add(hash_of(domain));
  for (const auto& vertices : domain.triangulation().vertices)
    for (Index v : vertices)
      hash.add(v);
  for (const Point& p : given.pinned)
    hash.add(p);
  return hash.value();
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_CHECKPOINT_FORMAT_2_H
