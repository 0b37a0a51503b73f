// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREATMENT_ALONE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREATMENT_ALONE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Greedy_coloring_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the treatment of defects asks of other ranks, where there are none.
struct Treatment_alone
{
  /// whether any rank has vertices to treat, and all know enough to go on
  bool goes_on(bool here) const { return here; }
  /// makes the colours of candidates what they are if those of other ranks are coloured with them
  void share_colors(const Editable_triangulation_2&, const std::vector<Index>&, Greedy_coloring_2&) const {}
  /// the largest value of all ranks
  std::size_t largest(std::size_t here) const { return here; }
  /// tells other ranks of vertices that were moved, and moves theirs, which the log is told of
  void share_moves(Marked_triangulation_2&, Bubbles_2&, const std::vector<Index>&, Treatment_log_2&) const {}
  /// makes the mesh around the vertices of other ranks what it is after their moves
  void restore_border(Editable_triangulation_2&) const {}
  /// adds the neighbours of vertices that other ranks moved in this sweep
  void add_neighbors_of_others(const Editable_triangulation_2&, const Bubbles_2&, std::vector<Index>&) const {}
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_TREATMENT_ALONE_H
