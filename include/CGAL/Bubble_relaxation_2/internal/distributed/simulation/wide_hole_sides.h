// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_WIDE_HOLE_SIDES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_WIDE_HOLE_SIDES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Local_triangulation_2.h>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// where a bubble is that asks for others around it, by its reference, and as how large
struct Wide_hole_side_2
{
  double x, y, d;
};

/// Those of our bubbles among `touched` that lie beside wide holes, by the other ranks that may own bubbles across: those
/// are farther away than others ever look.
inline Messages<Wide_hole_side_2> wide_hole_sides(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                                                  const std::vector<Index>& touched, const Halo_2& halo,
                                                  const Hilbert_partition_2& partition, int our_rank)
{
  using Triangulation = Local_triangulation_2;
  constexpr double largest_ratio = 4;
  Messages<Wide_hole_side_2> asked;
  for (Index i : touched) {
    // one that is asked for, and not known anyway, is not much larger; it may have left the part of its owner
    const double size = neighbors.reference_d(i);
    const double most = (0.5 * neighbors.radius() * (Triangulation::far + largest_ratio) +
                         largest_ratio * Halo_2::away_from_part) * size;
    if (!bubbles.is_ours(i) || bubbles.is_gone(i) || halo.is_ours_within(bubbles, i, most) ||
        !Triangulation::is_beside_wide_hole(bubbles, neighbors, i))
      continue;
    const Wide_hole_side_2 side{neighbors.reference_x(i), neighbors.reference_y(i), Triangulation::far * size};
    for (int rank : partition.owners_in_disc(side.x, side.y, most))
      if (rank != our_rank)
        asked[rank].push_back(side);
  }
  return asked;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_WIDE_HOLE_SIDES_H
