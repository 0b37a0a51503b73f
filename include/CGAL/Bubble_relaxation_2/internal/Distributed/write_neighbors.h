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
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own.
/// \pre `known` has all of them, in the order of their numbers
template <class Relaxation>
void write_neighbors(const Known_bubbles_2& known, int rank, double radius, Relaxation& relaxation)
{
  const Bubbles_2& b = known.bubbles;
  Neighbor_sets_2 sets(radius);
  sets.build(b);
  std::vector<char> is_ghost(b.size(), 0);
  relaxation.neighbor_radius = radius;
  std::size_t number = 0;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (known.owners[i] == rank)
      number += static_cast<std::size_t>(sets.end(i) - sets.begin(i));
  relaxation.neighbors.reserve(number);
  relaxation.neighbor_offsets.reserve(b.size() + 1);
  relaxation.neighbor_offsets.push_back(0);
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (known.owners[i] != rank)
      continue;
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j) {
      relaxation.neighbors.push_back(known.numbers[*j]);
      is_ghost[*j] = known.owners[*j] != rank;
    }
    relaxation.neighbor_offsets.push_back(relaxation.neighbors.size());
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!is_ghost[i])
      continue;
    relaxation.ghost_ids.push_back(known.numbers[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(b.x[i], b.y[i]));
    relaxation.ghost_sizes.push_back(b.d[i]);
    relaxation.ghost_owners.push_back(known.owners[i]);
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITE_NEIGHBORS_H
