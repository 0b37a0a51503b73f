// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_FACE_VALUES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_FACE_VALUES_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_remap_2.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline void report_overlaps(const Transfer_problem_2& problem, const Face_remap_2& remap,
                            const std::vector<double>& target_areas, Transfer_report_2& report)
{
  Compensated_sum uncovered_area, overlap_integral;
  for (std::size_t t = 0; t < target_areas.size(); ++t) {
    uncovered_area += (std::max)(0., target_areas[t] - remap.overlap_areas()[t]);
    for (const Face_overlap_2& o : remap.overlaps()[t])
      overlap_integral += o.area * problem.values[o.source];
    report.number_of_pairs += remap.overlaps()[t].size();
  }
  report.overlap_area = sum_of(remap.overlap_areas());
  report.uncovered_area = uncovered_area.value();
  report.overlap_integral = overlap_integral.value();
}

/// Values in the triangles of the target from those in the triangles of the source.
inline Transferred_values_2 transfer_face_values(Transfer_problem_2 problem, Face_transfer method,
                                                 const Threads& threads)
{
  const Transfer_scale_2 scale(problem, true);
  Transferred_values_2 result;
  Transfer_report_2& report = result.report;
  const std::vector<double> source_areas = problem.source.areas(), target_areas = problem.target.areas();
  report.source_area = sum_of(source_areas);
  report.target_area = sum_of(target_areas);
  report.source_integral = sum_of_products(source_areas, problem.values);
  const Source_search_2 search(problem.source);
  Face_remap_2 remap(problem, search, threads);
  if (method != Face_transfer::MEAN)
    remap.add_slopes(method == Face_transfer::MONOTONE_RECONSTRUCTION);
  report_overlaps(problem, remap, target_areas, report);
  std::vector<double>& values = remap.values();
  for (int turn = 0; turn < 2 && problem.keeps_integral && report.target_area > 0; ++turn) {
    const double deficit = report.source_integral - sum_of_products(target_areas, values);
    if (method == Face_transfer::RECONSTRUCTION)
      for (double& v : values)
        v += deficit / report.target_area;
    else
      spread_within_bounds(deficit, target_areas, remap.bounds(), values);
  }
  report.target_integral = sum_of_products(target_areas, values);
  result.values = std::move(values);
  scale.undo(result);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_FACE_VALUES_H
