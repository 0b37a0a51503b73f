// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The domain as the simulation sees it: corners, straight edges between them, and the constrained
/// triangulation of both, in which exact walks decide whether a bubble stays inside.
class Domain_2
{
public:
  /// tells whether a side of a triangle is an edge
  auto is_wall() const { return [this](Index t, int i) { return edge(t, i) != no_index; }; }

  /// \pre the edges meet in corners only
  Marking_error build(std::vector<Point> corners, std::vector<Domain_edge_2> edges)
  {
    m_corners = std::move(corners);
    m_edges = std::move(edges);
    m_bbox = bbox_2(m_corners.begin(), m_corners.end());
    m_lengths.clear();
    m_directions.clear();
    for (const Domain_edge_2& e : m_edges) {
      const Kernel::Vector_2 u = m_corners[e.target] - m_corners[e.source];
      m_lengths.push_back(length_of(u.x(), u.y()));
      m_directions.push_back({u.x() / m_lengths.back(), u.y() / m_lengths.back()});
    }
    m_by_corners.clear();
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      m_by_corners.push_back({(std::min)(m_edges[e].source, m_edges[e].target),
                              (std::max)(m_edges[e].source, m_edges[e].target), static_cast<Index>(e)});
    std::sort(m_by_corners.begin(), m_by_corners.end());
    const Marking_error error = mark_triangulation(m_corners, m_edges, m_marked);
    if (error == Marking_error::NONE)
      find_sides();
    return error;
  }

  const std::vector<Point>& corners() const { return m_corners; }
  const std::vector<Domain_edge_2>& edges() const { return m_edges; }
  const Flat_triangulation_2& triangulation() const { return m_marked; }
  const Bbox_2& bbox() const { return m_bbox; }

  bool is_inside(Index triangle) const { return m_marked.inside[triangle] != 0; }

  /// index of the domain's edge on the side `i` of a triangle, `no_index` if there is none
  Index edge(Index triangle, int i) const { return m_marked.edges[triangle][i]; }

  const Point& source(Index e) const { return m_corners[m_edges[e].source]; }
  const Point& target(Index e) const { return m_corners[m_edges[e].target]; }

  double length(Index e) const { return m_lengths[e]; }

  /// the triangle on the left of an edge, or on its right; `no_index` if there is none
  Index left(Index e) const { return m_left[e].triangle; }
  Index right(Index e) const { return m_right[e].triangle; }

  /// the edge between two corners, or `no_index`
  Index edge_between(Index u, Index v) const
  {
    const std::array<Index, 3> first{(std::min)(u, v), (std::max)(u, v), 0};
    const auto found = std::lower_bound(m_by_corners.begin(), m_by_corners.end(), first);
    return found != m_by_corners.end() && (*found)[0] == first[0] && (*found)[1] == first[1] ? (*found)[2] : no_index;
  }

  /// from the source to the target
  const Direction& direction(Index e) const { return m_directions[e]; }

  /// the point that divides the edge at `s` in [0,1]; always from the nearer end, so that a reversed
  /// edge gives the same points
  Point point_on_edge(Index e, double s) const
  {
    const Point& a = source(e);
    const Point& b = target(e);
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    return s <= 0.5 ? Point(a.x() + s * dx, a.y() + s * dy)
                    : Point(b.x() - (1 - s) * dx, b.y() - (1 - s) * dy);
  }

  /// walks from `p` in `triangle` towards `q` and stops at edges of the domain
  Walk_end walk(Index triangle, const Point& p, const Point& q) const
  {
    return walk_straight(m_marked, triangle, p, q, is_wall());
  }

  /// the triangle of `q` if it can be seen from `p` on the edge `e` through the domain, else `no_index`
  Index walk_from_edge(Index e, const Point& p, const Point& q) const
  {
    const Orientation turn = CGAL::orientation(source(e), target(e), q);
    if (turn == COLLINEAR || !(turn == LEFT_TURN ? m_edges[e].inside_left : m_edges[e].inside_right))
      return no_index;
    const Side& side = turn == LEFT_TURN ? m_left[e] : m_right[e];
    const Walk_end end = walk_straight(m_marked, side.triangle, p, q, is_wall(), side.index);
    return end.is_blocked() ? no_index : end.triangle;
  }

  /// the triangle that contains `q`, in or out of the domain, searched from `hint`; `no_index` if `q`
  /// lies outside of the convex hull
  Index locate(const Point& q, Index hint) const { return internal::locate(m_marked, hint, q); }

  /// the triangle of the domain that contains `q`, or `no_index`; `hint` becomes where the search ended
  Index locate_inside(const Point& q, Index& hint) const
  {
    const Index triangle = locate(q, hint);
    if (triangle == no_index)
      return no_index;
    hint = triangle;
    return is_inside(triangle) ? triangle : no_index;
  }

  /// The same; of two triangles on whose common side `q` lies the first, wherever the search began.
  Index host_of(const Point& q, Index& hint) const
  {
    const Index found = locate(q, hint);
    if (found == no_index)
      return no_index;
    hint = found;
    Index first = is_inside(found) ? found : no_index;
    for (int i = 0; i < 3; ++i) {
      const Index t = m_marked.neighbors[found][i];
      if (t != no_index && is_inside(t) && (first == no_index || t < first) && is_on_side(found, i, q))
        first = t;
    }
    return first;
  }

  /// whether a point lies on the line of the side `i` of a triangle
  bool is_on_side(Index t, int i, const Point& q) const
  {
    return CGAL::orientation(m_marked.point(t, ccw(i)), m_marked.point(t, cw(i)), q) == COLLINEAR;
  }

  /// Whether a point of a triangle lies on an edge of the domain. It is no place for a bubble of a face, though where
  /// sizes jump there may be none of the edge for many d.
  bool is_on_edge(Index t, const Point& q) const
  {
    for (int i = 0; i < 3; ++i)
      if (edge(t, i) != no_index && is_on_side(t, i, q))
        return true;
    return false;
  }

private:
  struct Side
  {
    Index triangle = no_index;
    int index = -1;
  };

  void find_sides()
  {
    m_left.assign(m_edges.size(), Side());
    m_right.assign(m_edges.size(), Side());
    for (std::size_t t = 0; t < m_marked.edges.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Index e = m_marked.edges[t][i];
        if (e == no_index)
          continue;
        const bool is_left = m_marked.vertices[t][ccw(i)] == m_edges[e].source;
        (is_left ? m_left : m_right)[e] = Side{static_cast<Index>(t), i};
      }
  }

  std::vector<Point> m_corners;
  std::vector<Domain_edge_2> m_edges;
  std::vector<double> m_lengths;        // of the edges
  std::vector<Direction> m_directions;  // of the edges
  std::vector<std::array<Index, 3>> m_by_corners; // the edges between two, in order
  Marked_triangulation_2 m_marked;
  std::vector<Side> m_left, m_right; // the triangles beside each edge
  Bbox_2 m_bbox;
};

/// The longest of the domain's edges; of several that only rounding tells apart, the first.
inline Index longest_edge(const Domain_2& domain)
{
  constexpr double rounding = 1e-9;
  Index longest = 0;
  for (std::size_t e = 1; e < domain.edges().size(); ++e)
    if (domain.length(static_cast<Index>(e)) > (1 + rounding) * domain.length(longest))
      longest = static_cast<Index>(e);
  return longest;
}

/// The curve in whose order the bubbles of a domain are, one rank after the other. A single crystal grows from the
/// longest edge row by row, so the halves of the curve lie side by side there, and ranks have parts of the same row.
inline Hilbert_curve_2 hilbert_curve(const Domain_2& domain)
{
  const Index e = longest_edge(domain);
  const Kernel::Vector_2 along = domain.target(e) - domain.source(e);
  return Hilbert_curve_2(domain.bbox(), std::abs(along.y()) > std::abs(along.x()));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_2_H
