// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/fields/Gradient_limiter_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Side_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Triangle_quadtree_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/linear_values.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Values at the vertices of a triangulation, linear in the triangles of its domain. Outside it is the value in the
/// nearest point of the domain's boundary, and beyond the convex hull that in the nearest point of the hull. No query
/// takes time of all triangles, and queries change nothing.
class Interpolated_field_2
{
public:
  /// \pre some triangles belong to the domain
  Interpolated_field_2(Flat_triangulation_2 tr, std::vector<double> values)
    : m_tr(std::move(tr)), m_values(std::move(values)), m_quadtree(m_tr),
      m_on_hull(sides_where([this](Index t, int i) { return m_tr.neighbors[t][i] == no_index; })),
      m_hull(sides(m_on_hull)),
      m_rim(sides(sides_where([this](Index t, int i) {
        const Index n = m_tr.neighbors[t][i];
        return m_tr.inside[t] && n != no_index && !m_tr.inside[n];
      })))
  {}

  double operator()(double x, double y) const
  {
    if (!std::isfinite(x) || !std::isfinite(y))
      return std::numeric_limits<double>::quiet_NaN();
    const Point q(x, y);
    const Walk_end end = locate_or_exit(m_tr, m_quadtree.start(x, y), q);
    if (end.is_blocked())
      return value_beyond_hull(within_reach(q));
    return m_tr.inside[end.triangle] ? value_in_triangle({corner(end.triangle, 0), corner(end.triangle, 1),
                                                          corner(end.triangle, 2)}, q)
                                     : m_rim.value(q);
  }

  const Flat_triangulation_2& triangulation() const { return m_tr; }

private:
  Valued_corner_2 corner(Index t, int i) const
  {
    const Index v = m_tr.vertices[t][i];
    return {m_tr.points[v], m_values[v], v};
  }

  /// sides, each with the triangle that it belongs to
  template <class Is_wanted>
  std::vector<Walk_end> sides_where(const Is_wanted& is_wanted) const
  {
    std::vector<Walk_end> result;
    for (std::size_t k = 0; k < m_tr.number_of_triangles(); ++k)
      for (int i = 0; i < 3; ++i)
        if (is_wanted(static_cast<Index>(k), i))
          result.push_back(Walk_end{static_cast<Index>(k), i});
    return result;
  }

  std::vector<Side_search_2::Side> sides(const std::vector<Walk_end>& of) const
  {
    std::vector<Side_search_2::Side> result;
    for (const Walk_end& s : of)
      result.emplace_back(corner(s.triangle, ccw(s.edge)), corner(s.triangle, cw(s.edge)));
    return result;
  }

  /// that in the nearest point of the hull, which need not belong to the domain
  double value_beyond_hull(const Point& q) const
  {
    const Index side = m_hull.nearest(q);
    return m_tr.inside[m_on_hull[side].triangle] ? m_hull.value_on(side, q) : m_rim.value(m_hull.point_on(side, q));
  }

  Flat_triangulation_2 m_tr;
  std::vector<double> m_values;
  Triangle_quadtree_2 m_quadtree;
  std::vector<Walk_end> m_on_hull;
  Side_search_2 m_hull; // of the sides there
  Side_search_2 m_rim;  // of those between triangles of the domain and others
};

/// The size that a mesh with a domain has: at each vertex the mean length of its edges there, or less where that grows
/// by more than `growth` per unit of length, but no less than half of it: a needle does not ask for more of its kind.
inline Interpolated_field_2 mean_edge_length_field(const Triangulation_copy_2& mesh, double growth)
{
  Sorted_triangulation_2 sorted(mesh); // so that it does not matter how the mesh came about
  const Flat_triangulation_2& tr = sorted.tr;
  std::vector<std::pair<double, std::array<Index, 2>>> edges; // their lengths and ends
  for_each_edge(tr, 0, tr.number_of_triangles(), [&](Index t, int i) {
    const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
    edges.push_back({std::sqrt(CGAL::squared_distance(p, q)), {tr.vertices[t][ccw(i)], tr.vertices[t][cw(i)]}});
  });
  std::sort(edges.begin(), edges.end()); // so that sums are rounded the same way whatever the order of the faces is
  std::vector<double> sizes(tr.points.size(), 0), count(tr.points.size(), 0);
  double all = 0;
  for (const auto& [length, ends] : edges) {
    for (Index v : ends) {
      sizes[v] += length;
      ++count[v];
    }
    all += length;
  }
  for (std::size_t v = 0; v < sizes.size(); ++v)
    sizes[v] = count[v] > 0 ? sizes[v] / count[v] : all / static_cast<double>(edges.size());
  std::vector<double> limited = sizes;
  Gradient_limiter_2(tr, growth).spread(limited);
  for (std::size_t v = 0; v < sizes.size(); ++v)
    sizes[v] = (std::max)(limited[v], sizes[v] / 2);
  return Interpolated_field_2(std::move(sorted.tr), std::move(sizes));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H
