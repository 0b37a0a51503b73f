// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFIED_OUTLINE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFIED_OUTLINE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>

#include <CGAL/Outline_simplification_report_2.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

struct Simplification_options
{
  double tolerance = (std::numeric_limits<double>::infinity)(); ///< a length
  double relative_tolerance = 0.1;                              ///< a share of d; the smaller one counts
  double minimum_island_area = 0, minimum_gap = 0;              ///< 0: these rules are off
  double corner_angle = 100;                                    ///< degrees
  std::size_t maximum_number_of_bubbles = 0; ///< of a mesh with d; 0: as many as it asks for

  bool has_rules() const { return minimum_island_area > 0 || minimum_gap > 0; }
};

/// What is read from the user's triangulation.
struct Simplification_problem_2
{
  Outline_2 outline;
  std::vector<char> is_end; ///< of each vertex whether constraints end there, so that it stays unless a rule takes it
  std::vector<Point> seeds; ///< as the user gave them
  bool seeds_are_in_domain = false;
  Sizes_2 sizes;
  Simplification_options options;
};

/// A line of the new outline, and the segments of the old outline that it stands for, in its direction.
struct Simplified_span_2
{
  std::vector<Index> vertices; ///< of the new outline; of a ring the first one at the end again
  std::vector<Index> origins;  ///< of the segments of the span, `no_index` of what a rule made
  std::vector<char> is_forward; ///< whether each origin goes from its smaller vertex to the larger one
};

/// What takes the place of the old outline. Vertices that it has in common with it know so.
struct Simplified_outline_2
{
  std::vector<Point> points;
  std::vector<Index> old_vertices; ///< of each point, `no_index` if it is new
  std::vector<Outline_segment_2> segments;
  std::vector<Simplified_span_2> spans;
  Outline_simplification_report_2 report;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFIED_OUTLINE_2_H
