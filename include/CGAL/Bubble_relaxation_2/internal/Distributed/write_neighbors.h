// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_NEIGHBORS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_NEIGHBORS_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Known_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/with_neighbors.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_search_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Writes what a rank has to know of the neighbours that others own, in the order of their numbers.
template <class Relaxation>
void write_ghosts(const Known_bubbles_2& known, const std::vector<char>& is_ghost, Relaxation& relaxation)
{
  std::vector<Index> ghosts;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (is_ghost[i])
      ghosts.push_back(static_cast<Index>(i));
  std::sort(ghosts.begin(), ghosts.end(), [&](Index i, Index j) { return known.numbers[i] < known.numbers[j]; });
  const Bubbles_2& b = known.bubbles;
  for (Index i : ghosts) {
    relaxation.ghost_ids.push_back(known.numbers[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(b.x[i], b.y[i]));
    relaxation.ghost_sizes.push_back(b.d[i]);
    relaxation.ghost_owners.push_back(known.owners[i]);
  }
}

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own.
template <class Relaxation>
void write_neighbors(const Surrounded_bubbles_2& bubbles, Relaxation& relaxation)
{
  constexpr std::size_t block_size = Neighbor_search_2::block_size, usual_number = 7;
  const Known_bubbles_2& known = bubbles.known;
  const std::size_t n = bubbles.number_of_own;
  const auto is_gone = [](std::size_t) { return false; };
  const auto is_before = [&known](Index i, Index j) { return known.numbers[i] < known.numbers[j]; };
  relaxation.neighbor_radius = bubbles.radius;
  relaxation.neighbors.reserve(usual_number * n);
  relaxation.neighbor_offsets.reserve(n + 1);
  relaxation.neighbor_offsets.push_back(0);
  if (n == 0)
    return;
  std::vector<char> is_neighbor(known.size(), 0);
  const Neighbor_search_2 find(*bubbles.buckets, known.bubbles.x, known.bubbles.y, known.bubbles.d, bubbles.radius);
  Neighbor_block block;
  for (std::size_t first = 0; first < n; first += block_size) {
    find(first, (std::min)(first + block_size, n), is_gone, is_before, block);
    for (Index j : block.found) {
      relaxation.neighbors.push_back(known.numbers[j]);
      is_neighbor[j] = 1;
    }
    for (std::size_t size : block.sizes)
      relaxation.neighbor_offsets.push_back(relaxation.neighbor_offsets.back() + size);
  }
  std::fill_n(is_neighbor.begin(), n, char(0)); // of others only
  write_ghosts(known, is_neighbor, relaxation);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_NEIGHBORS_H
