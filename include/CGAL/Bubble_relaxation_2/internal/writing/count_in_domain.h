// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_COUNT_IN_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_COUNT_IN_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/mark_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/Mesh_quality_accumulator_2.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <cstddef>

namespace CGAL::Bubble_relaxation_2::internal {

/// The statistics of the domain as it was written, but for lengths over d: the user's d must not be called any more.
template <class Cdt>
Mesh_statistics_2 statistics_of_domain(const Cdt& cdt, const Domain_faces_2<Cdt>& faces)
{
  const auto point = [](const auto v) {
    return Point(CGAL::to_double(Plane_2<Cdt>::x(v->point())), CGAL::to_double(Plane_2<Cdt>::y(v->point())));
  };
  Mesh_quality_accumulator_2 accumulator;
  std::size_t number = 0;
  for (const auto f : cdt.finite_face_handles()) {
    tick(number++);
    if (faces.contains(f))
      accumulator.add_triangle(point(f->vertex(0)), point(f->vertex(1)), point(f->vertex(2)));
  }
  for (const auto v : cdt.finite_vertex_handles()) {
    tick(number++);
    auto f = cdt.incident_faces(v), first = f;
    bool is_in_domain = false, is_interior = true;
    std::size_t degree = 0;
    do {
      is_in_domain = is_in_domain || faces.contains(f);
      is_interior = is_interior && !f->is_constrained(cdt.cw(f->index(v)));
      ++degree;
    } while (++f != first);
    if (is_in_domain)
      accumulator.add_vertex(is_interior, degree);
  }
  return accumulator.statistics();
}

/// Counts what is in the domain. Constraints that go through rounded points may meet vertices, or pass them on the
/// other side, that were outside of the domain by a rounding: then the statistics are those of the mesh with them.
template <class Cdt>
void count_in_domain(const Cdt& cdt, const Domain_faces_2<Cdt>& faces, Report& report)
{
  report.number_of_vertices = report.number_of_triangles = 0;
  std::size_t number = 0;
  for (const auto f : cdt.finite_face_handles()) {
    tick(number++);
    report.number_of_triangles += faces.contains(f);
  }
  for (const auto v : cdt.finite_vertex_handles()) {
    tick(number++);
    auto f = cdt.incident_faces(v), first = f;
    bool is_in_domain = false;
    do
      is_in_domain = is_in_domain || faces.contains(f);
    while (++f != first);
    report.number_of_vertices += is_in_domain;
  }
  if (report.number_of_vertices == report.quality.number_of_vertices() &&
      report.number_of_triangles == report.quality.number_of_triangles())
    return;
  Mesh_statistics_2 now = statistics_of_domain(cdt, faces);
  now.take_lengths(report.quality.statistics());
  report.quality = Mesh_quality_2<double>(now);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_COUNT_IN_DOMAIN_H
