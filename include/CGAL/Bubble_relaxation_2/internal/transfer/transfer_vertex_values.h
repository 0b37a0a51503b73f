// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_VERTEX_VALUES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_VERTEX_VALUES_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Vertex_projection_2.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline void report_overlaps(const std::vector<double>& target_areas, const std::vector<Vertex_share_2>& shares,
                            Transfer_report_2& report)
{
  Compensated_sum overlap_area, uncovered_area, overlap_integral;
  for (std::size_t t = 0; t < shares.size(); ++t) {
    overlap_area += shares[t].overlap_area;
    uncovered_area += (std::max)(0., target_areas[t] - shares[t].overlap_area);
    overlap_integral += shares[t].overlap_integral;
    report.number_of_pairs += shares[t].pairs;
  }
  report.overlap_area = overlap_area.value();
  report.uncovered_area = uncovered_area.value();
  report.overlap_integral = overlap_integral.value();
}

/// Values at the points of the target from those at the points of the source.
inline Transferred_values_2 transfer_vertex_values(Transfer_problem_2 problem, Vertex_transfer method,
                                                   const Threads& threads)
{
  const Transfer_scale_2 scale(problem, method != Vertex_transfer::INTERPOLATION);
  const Source_search_2 search(problem.source);
  const Mass_matrix_2 source(problem.source), target(problem.target);
  Transferred_values_2 result;
  Transfer_report_2& report = result.report;
  result.values = interpolate(search, problem.values, problem.target.points, threads);
  report.source_area = sum_of(source.areas());
  report.target_area = sum_of(target.areas());
  report.source_integral = source.integral(problem.values);
  if (method == Vertex_transfer::INTERPOLATION) { // no triangles are intersected
    report.overlap_area = report.uncovered_area = report.overlap_integral = std::numeric_limits<double>::quiet_NaN();
  } else {
    const std::vector<Vertex_share_2> shares = vertex_shares(search, problem, result.values, threads);
    report_overlaps(target.areas(), shares, report);
    const Vertex_projection_2 projection(problem, target, result.values, shares, report.source_integral);
    result.values = method == Vertex_transfer::PROJECTION ? projection.consistent() : projection.monotone();
  }
  report.target_integral = target.integral(result.values);
  scale.undo(result);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_VERTEX_VALUES_H
