// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_assembly_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/find_spans.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/read_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/replace_spans.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/write_outline.h>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The stages of `CGAL::simplify_outline_2()`, without the user's types.
inline Simplified_outline_2 simplify_outline(const Simplification_problem_2& problem)
{
  Outline_2 outline = problem.outline;
  const Outline_demands_2 demands = demands_of(outline, problem.sizes, problem.options);
  const std::size_t number_of_corners = fix_corners(outline, demands, problem.options.corner_angle);
  const std::vector<Outline_span_2> spans = find_spans(outline);
  const std::vector<Fitted_path_2> paths = replace_spans(outline, spans, demands, problem.obstacles);
  Simplified_outline_2 result = Outline_assembly_2(outline, spans, paths)();
  result.report.number_of_old_segments = problem.outline.segments.size();
  result.report.number_of_corners = number_of_corners;
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H
