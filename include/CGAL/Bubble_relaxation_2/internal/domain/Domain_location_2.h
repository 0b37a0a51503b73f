// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_LOCATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_LOCATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace CGAL::Bubble_relaxation_2::internal {

/// where a point lies: in which corner, on which edge, or in which triangle of the domain
struct Location_2
{
  Bubbles_2::Dimension dimension;
  Index place;
  double s; ///< position on the edge
};

/// Finds what of the domain points lie on. A point lies on a corner if it has its coordinates, and on an edge up
/// to their rounding, since no point between two corners may be exactly there.
class Domain_location_2
{
public:
  explicit Domain_location_2(const Domain_2& domain) : m_domain(domain) {}

  /// \throws std::invalid_argument if the point is not finite or not in the domain
  Location_2 operator()(const Point& q)
  {
    if (!std::isfinite(q.x()) || !std::isfinite(q.y()))
      throw std::invalid_argument("Bubble_relaxation_2: a point has the coordinates " +
                                  in_words(q.x(), q.y()) + ", which must be finite");
    const Flat_triangulation_2& tr = m_domain.triangulation();
    const Walk_end end = locate_or_exit(tr, m_triangle, q);
    m_triangle = end.triangle;
    for (Index v : tr.vertices[end.triangle])
      if (tr.points[v] == q)
        return Location_2{Bubbles_2::CORNER, v, 0};
    const Location_2 on_edge = locate_on_edges(q);
    if (on_edge.place != no_index)
      return on_edge;
    if (end.is_blocked() || !m_domain.is_inside(end.triangle))
      throw std::invalid_argument("Bubble_relaxation_2: the point " + in_words(q.x(), q.y()) +
                                  " is not in the domain");
    return Location_2{Bubbles_2::FACE, end.triangle, 0};
  }

  /// how far from an edge, as far as its own coordinates and the edge's tell, a point may be that lies on it
  double rounding(Index e, const Point& q) const
  {
    const Point &a = m_domain.source(e), &b = m_domain.target(e);
    const double largest = (std::max)({std::abs(q.x()), std::abs(q.y()), std::abs(a.x()), std::abs(a.y()),
                                       std::abs(b.x()), std::abs(b.y())});
    return 16 * std::numeric_limits<double>::epsilon() * largest;
  }

private:
  /// looks at the triangle that was found and at its neighbours: the point may be beyond an edge by a rounding
  Location_2 locate_on_edges(const Point& q) const
  {
    Location_2 best{Bubbles_2::EDGE, no_index, 0};
    double least = std::numeric_limits<double>::infinity();
    const std::array<Index, 3>& n = m_domain.triangulation().neighbors[m_triangle];
    for (Index t : {m_triangle, n[0], n[1], n[2]})
      for (int i = 0; i < 3 && t != no_index; ++i) {
        const Index e = m_domain.edge(t, i);
        if (e == no_index)
          continue;
        const double off = distance_from_line(e, q), s = position(e, q);
        if (!(s > 0 && s < 1) || off > rounding(e, q) || !(off < least || (off == least && e < best.place)))
          continue;
        least = off;
        best.place = e;
        best.s = s;
      }
    return best;
  }

  double distance_from_line(Index e, const Point& q) const
  {
    const Point &a = m_domain.source(e), &b = m_domain.target(e);
    if (CGAL::collinear(a, b, q))
      return 0;
    const Direction u = m_domain.direction(e);
    return std::abs(u.x * (q.y() - a.y()) - u.y * (q.x() - a.x()));
  }

  double position(Index e, const Point& q) const
  {
    const Point& a = m_domain.source(e);
    const Direction u = m_domain.direction(e);
    return (u.x * (q.x() - a.x()) + u.y * (q.y() - a.y())) / m_domain.length(e);
  }

  const Domain_2& m_domain;
  Index m_triangle = 0; // where the last point was
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_LOCATION_2_H
