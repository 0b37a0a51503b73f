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
#include <CGAL/Bubble_relaxation_2/internal/order_independent.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <array>
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

/// How much d changes along edges, in whatever order they come.
class Size_gradient_2
{
public:
  /// `steep`: edges with a larger gradient are counted
  explicit Size_gradient_2(double steep) : m_steep(steep) {}

  /// adds an edge with d at its ends
  void add(const Point& p, double d_p, const Point& q, double d_q)
  {
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon(); // of the user's formula
    const double dx = q.x() - p.x(), dy = q.y() - p.y();
    const double change = std::abs(d_q - d_p), length = std::sqrt(dx * dx + dy * dy), gradient = change / length;
    ++m_number;
    if (change > m_steep * length + rounding * (d_p + d_q))
      ++m_number_of_steep;
    if (!(gradient > 0) || gradient < m_largest)
      return;
    // from the end that comes first: what rounds must not depend on the triangle from which the edge is seen
    const Point& first = CGAL::lexicographically_xy_smaller(q, p) ? q : p;
    const double sign = &first == &q ? -1 : 1;
    const Point middle(first.x() + sign * dx / 2, first.y() + sign * dy / 2);
    if (gradient > m_largest || CGAL::lexicographically_xy_smaller(middle, m_steepest))
      m_steepest = middle;
    m_largest = gradient;
  }

  /// Puts it into the report. Of edges with the same gradient it tells that with the lexicographically smallest
  /// midpoint. `all` may know of what others have, see `All_values_here`.
  template <class Report, class All = All_values_here>
  void tell(Report& report, const All& all = All()) const
  {
    using FT = typename Report::FT;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double largest = all.largest(m_largest);
    const bool is_here = m_largest == largest;
    const double x = all.smallest(is_here ? m_steepest.x() : infinity);
    const double y = all.smallest(is_here && m_steepest.x() == x ? m_steepest.y() : infinity);
    const auto counts = all.sums(std::array<std::size_t, 2>{m_number_of_steep, m_number});
    report.largest_size_gradient = FT(largest);
    report.steepest_x = FT(x);
    report.steepest_y = FT(y);
    report.steep_share = FT(counts[1] == 0 ? 0. : static_cast<double>(counts[0]) / static_cast<double>(counts[1]));
  }

private:
  double m_steep, m_largest = 0;
  Point m_steepest = Point(0, 0);
  std::size_t m_number_of_steep = 0, m_number = 0;
};

/// Tells how much d changes from one vertex of a mesh to the next, which is what the mesh can see of its
/// gradient, kinks and jumps included.
template <class Concurrency_tag, class Sizing, class Report>
void evaluate_size_gradient(const Marked_triangulation_2& mesh, const Sizing& sizing, Report& report)
{
  const std::vector<double> sizes = sizes_at_vertices<Concurrency_tag>(mesh, sizing);
  const Flat_triangulation_2& tr = mesh.tr;
  Size_gradient_2 gradient(Report::steep_size_gradient);
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (int i = 0; i < 3 && mesh.inside[t]; ++i) {
      const Index n = tr.neighbors[t][i], a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
      if (n != no_index && mesh.inside[n] && static_cast<std::size_t>(n) < t)
        continue; // seen from the other side
      gradient.add(tr.points[a], sizes[a], tr.points[b], sizes[b]);
    }
  gradient.tell(report);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_EVALUATE_SIZE_GRADIENT_H
