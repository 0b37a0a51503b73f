// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/evaluate_size_gradient.h>
#include <CGAL/Mesh_quality_2.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// adds all triangles and vertices of a domain, as `add_domain()` of a user's triangulation does
inline void add_domain(const Marked_triangulation_2& mesh, Mesh_quality_accumulator_2& accumulator)
{
  const Flat_triangulation_2& tr = mesh.tr;
  std::vector<char> is_in_domain(tr.points.size(), 0), is_interior(tr.points.size(), 1);
  std::vector<std::size_t> degrees(tr.points.size(), 0);
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
    const auto& v = tr.vertices[t];
    if (mesh.inside[t])
      accumulator.add_triangle(tr.points[v[0]], tr.points[v[1]], tr.points[v[2]]);
    for (int i = 0; i < 3; ++i) {
      ++degrees[v[i]];
      if (mesh.inside[t])
        is_in_domain[v[i]] = 1;
      if (mesh.edges[t][i] != no_index) // all ways out of the domain lead across edges
        is_interior[v[ccw(i)]] = is_interior[v[cw(i)]] = 0;
    }
  }
  for (std::size_t v = 0; v < tr.points.size(); ++v)
    if (is_in_domain[v])
      accumulator.add_vertex(is_interior[v] != 0, degrees[v]);
}

/// adds the lengths of all edges of a domain over d in their midpoints
template <class Sizing>
void add_lengths(const Marked_triangulation_2& mesh, const Sizing& sizing,
                 Mesh_quality_accumulator_2& accumulator)
{
  const Flat_triangulation_2& tr = mesh.tr;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
    if (!mesh.inside[t])
      continue;
    for (int i = 0; i < 3; ++i) {
      const Index n = tr.neighbors[t][i];
      if (n != no_index && mesh.inside[n] && static_cast<std::size_t>(n) < t)
        continue; // seen from the other side
      const Point &p = tr.point(static_cast<Index>(t), ccw(i)), &q = tr.point(static_cast<Index>(t), cw(i));
      const double dx = q.x() - p.x(), dy = q.y() - p.y();
      accumulator.add_length(std::hypot(dx, dy) / sizing(p.x() + dx / 2, p.y() + dy / 2));
    }
  }
}

/// Puts the statistics of the bubbles' mesh into the report. The mesh is made in arrays: the user's d
/// may throw, and then the user's triangulation must not have been changed yet.
template <class Sizing, class Report>
void evaluate(const Domain_2& domain, const Bubbles_2& bubbles, const Sizing& sizing, Report& report)
{
  const Phase_timer timer(report.seconds.evaluation);
  const Marked_triangulation_2 mesh = triangulate(domain, bubbles);
  Mesh_quality_accumulator_2 accumulator;
  add_domain(mesh, accumulator);
  add_lengths(mesh, sizing, accumulator);
  evaluate_size_gradient(mesh, sizing, report);
  report.quality = decltype(report.quality)(accumulator.statistics());
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_H
