// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H

#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Mesh_quality_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Puts the statistics of the mesh into the report.
template <class Cdt, class NamedParameters, class Sizing, class Report>
void evaluate(const Cdt& cdt, const NamedParameters& np, const Sizing& sizing, Report& report)
{
  using Point_2 = typename Cdt::Geom_traits::Point_2;
  const Phase_timer timer(report.seconds.evaluation);
  const Domain_marks_2<Cdt> is_inside(cdt, np);
  Mesh_quality_accumulator_2 accumulator;
  add_domain(cdt, is_inside, accumulator);
  add_lengths(cdt, is_inside,
              [&](const Point_2& p) {
                return sizing(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
              },
              accumulator);
  report.quality = decltype(report.quality)(accumulator.statistics());
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H
