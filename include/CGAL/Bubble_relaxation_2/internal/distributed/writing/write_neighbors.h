// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. The bubbles of this rank, and after them those of others that are neighbours of one of them, and perhaps
/// some more: nearer than `radius` times the mean of both sizes, so nearer than that times the larger one.
/// \pre the numbers of `own` ascend
inline Bubbles_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius,
                                Communicator& comm)
{
  std::vector<Bubble_record_2> records;
  for (std::size_t i = 0; i < own.size(); ++i)
    records.push_back(record(own, i));
  const Shared_lists lists = share_around(comm, partition, radius, farthest_stray(comm, partition, own), records);
  Bubbles_2 known = with_owner(own, comm.rank());
  for (const auto& list : lists.received)
    for (Index i : list.second)
      add(known, records[i], list.first);
  return known;
}

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own, in the order of their numbers. `known`: see `with_neighbors()`
template <class Relaxation>
void write_neighbors(const Bubbles_2& known, double radius, Relaxation& relaxation)
{
  constexpr std::size_t usual_number = 7;
  const std::size_t n = static_cast<std::size_t>(std::count(known.owner.begin(), known.owner.end(), known.rank));
  relaxation.neighbor_radius = radius;
  relaxation.neighbors.reserve(usual_number * n);
  relaxation.neighbor_offsets.reserve(n + 1);
  relaxation.neighbor_offsets.push_back(0);
  Neighbor_sets_2 sets(radius);
  sets.build(known);
  std::vector<char> is_ghost(known.size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j) {
      relaxation.neighbors.push_back(known.id[*j]);
      is_ghost[*j] = !known.is_ours(*j);
    }
    relaxation.neighbor_offsets.push_back(relaxation.neighbors.size());
  }
  std::vector<Index> ghosts = marked(is_ghost);
  std::sort(ghosts.begin(), ghosts.end(), [&](Index i, Index j) { return known.id[i] < known.id[j]; });
  for (Index i : ghosts) {
    relaxation.ghost_ids.push_back(known.id[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(known.x[i], known.y[i]));
    relaxation.ghost_sizes.push_back(known.d[i]);
    relaxation.ghost_owners.push_back(known.owner[i]);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_WRITE_NEIGHBORS_H
