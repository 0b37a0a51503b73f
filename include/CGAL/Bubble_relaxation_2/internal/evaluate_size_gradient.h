// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_SIZE_GRADIENT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_SIZE_GRADIENT_H

#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// d at the vertices of a mesh that belong to its domain; others are not the business of d
template <class Concurrency_tag, class Sizing>
std::vector<double> sizes_at_vertices(const Marked_triangulation_2& mesh, const Sizing& sizing)
{
  std::vector<char> is_in_domain(mesh.tr.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tr.number_of_triangles(); ++t)
    for (Index v : mesh.tr.vertices[t])
      if (mesh.inside[t])
        is_in_domain[v] = 1;
  std::vector<double> sizes(mesh.tr.points.size(), 0);
  parallel_for<Concurrency_tag>(sizes.size(), [&](std::size_t v) {
    if (is_in_domain[v])
      sizes[v] = sizing(mesh.tr.points[v]);
  });
  return sizes;
}

/// Tells how much d changes from one vertex of a mesh to the next, which is what the mesh can see of its
/// gradient, kinks and jumps included.
template <class Concurrency_tag, class Sizing, class Report>
void evaluate_size_gradient(const Marked_triangulation_2& mesh, const Sizing& sizing, Report& report)
{
  using FT = typename Report::FT;
  const std::vector<double> sizes = sizes_at_vertices<Concurrency_tag>(mesh, sizing);
  const Flat_triangulation_2& tr = mesh.tr;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon(); // of the user's formula
  double largest = 0;
  std::size_t steep = 0, all = 0;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (int i = 0; i < 3 && mesh.inside[t]; ++i) {
      const Index n = tr.neighbors[t][i], a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
      if (n != no_index && mesh.inside[n] && static_cast<std::size_t>(n) < t)
        continue; // seen from the other side
      const Point &p = tr.points[a], &q = tr.points[b];
      const double dx = q.x() - p.x(), dy = q.y() - p.y();
      const double change = std::abs(sizes[b] - sizes[a]), length = std::sqrt(dx * dx + dy * dy),
                   gradient = change / length;
      ++all;
      if (change > Report::steep_size_gradient * length + rounding * (sizes[a] + sizes[b]))
        ++steep;
      if (gradient > largest) {
        largest = gradient;
        report.steepest_x = FT(p.x() + dx / 2);
        report.steepest_y = FT(p.y() + dy / 2);
      }
    }
  report.largest_size_gradient = FT(largest);
  report.steep_share = FT(all == 0 ? 0. : static_cast<double>(steep) / static_cast<double>(all));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_SIZE_GRADIENT_H
