// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DISTRIBUTED_RELAXATION_2_H
#define CGAL_DISTRIBUTED_RELAXATION_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Distributed {

/*!
\ingroup PkgBubbleRelaxation2Ref

What `CGAL::Distributed::npbs_relax()` tells a rank, beside its points: what was done, and which points are
neighbours, as meshless methods want to know. Points of other ranks that are neighbours of points of this one are
its ghosts.

\tparam Kernel_ the kernel of the points
*/
template <class Kernel_>
struct Relaxation_2
{
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;
  using FT = typename Bubble_relaxation_2::internal::Quality_number<Kernel>::type;
  /// what names a point on all ranks
  using Global_id = std::int64_t;

  /// What all ranks together did, and the mesh of all points: the same on all ranks, and that of
  /// `CGAL::npbs_relax()`. Phases took so many seconds on the slowest rank.
  Bubble_relaxation_report_2<FT> report;

  /// \name Neighbour Sets
  /// of the points of this rank, in their order: by their ids
  /// @{
  double neighbor_radius = 0; ///< the radius of the sets in units of the mean of both sizes

  /// the neighbours of the i-th point are `neighbors[neighbor_offsets[i]]` up to, without,
  /// `neighbors[neighbor_offsets[i + 1]]`
  std::vector<std::size_t> neighbor_offsets;
  /// ids of the points nearer than `neighbor_radius` times the mean of both sizes, in increasing order
  std::vector<Global_id> neighbors;
  /// @}

  /// \name Ghosts
  /// @{
  std::vector<Global_id> ghost_ids;  ///< in increasing order
  std::vector<Point_2> ghost_points; ///< positions
  std::vector<double> ghost_sizes;   ///< the wanted distance d at each ghost
  std::vector<int> ghost_owners;     ///< the ranks that have them among their points
  /// @}
};

} // namespace CGAL::Distributed

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DISTRIBUTED_RELAXATION_2_H
