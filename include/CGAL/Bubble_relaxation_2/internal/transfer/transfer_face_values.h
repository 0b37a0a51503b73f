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

/// the areas of the triangles, whose sum is added
inline std::vector<double> face_areas(const Face_set_2& faces, double& sum)
{
  std::vector<double> areas;
  for (std::size_t t = 0; t < faces.number_of_triangles(); ++t)
    areas.push_back(faces.area(static_cast<Index>(t)));
  sum = sum_of(areas);
  return areas;
}

inline double face_integral(const std::vector<double>& areas, const std::vector<double>& values)
{
  Compensated_sum sum;
  for (std::size_t t = 0; t < areas.size(); ++t)
    sum += areas[t] * values[t];
  return sum.value();
}

inline void report_overlaps(const Transfer_problem_2& problem, const Face_remap_2& remap,
                            const std::vector<double>& target_areas, Transfer_report_2& report)
{
  Compensated_sum overlap_area, uncovered_area, overlap_integral;
  for (std::size_t t = 0; t < target_areas.size(); ++t) {
    overlap_area += remap.overlap_areas()[t];
    uncovered_area += (std::max)(0., target_areas[t] - remap.overlap_areas()[t]);
    for (const Face_overlap_2& o : remap.overlaps()[t])
      overlap_integral += o.area * problem.values[o.source];
  }
  report.overlap_area = overlap_area.value();
  report.uncovered_area = uncovered_area.value();
  report.overlap_integral = overlap_integral.value();
  report.number_of_pairs = remap.overlaps().size();
}

/// Values in the triangles of the target from those in the triangles of the source.
inline Transferred_values_2 transfer_face_values(Transfer_problem_2 problem, Face_transfer method,
                                                 const Threads& threads)
{
  const Transfer_scale_2 scale(problem);
  Transferred_values_2 result;
  Transfer_report_2& report = result.report;
  const std::vector<double> source_areas = face_areas(problem.source, report.source_area),
                            target_areas = face_areas(problem.target, report.target_area);
  report.source_integral = face_integral(source_areas, problem.values);
  const Source_search_2 search(problem.source);
  Face_remap_2 remap(problem, search, threads);
  if (method != Face_transfer::MEAN)
    remap.add_slopes(method == Face_transfer::MONOTONE_RECONSTRUCTION);
  report_overlaps(problem, remap, target_areas, report);
  std::vector<double>& values = remap.values();
  for (int turn = 0; turn < 2 && problem.keeps_integral && report.target_area > 0; ++turn) {
    const double deficit = report.source_integral - face_integral(target_areas, values);
    if (method == Face_transfer::RECONSTRUCTION)
      for (double& v : values)
        v += deficit / report.target_area;
    else
      spread_within_bounds(deficit, target_areas, remap.bounds(), values);
  }
  report.target_integral = face_integral(target_areas, values);
  result.values = std::move(values);
  scale.undo(result);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_TRANSFER_FACE_VALUES_H
