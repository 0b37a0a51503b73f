// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_BOUNDARY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_BOUNDARY_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bubble_relaxation_2::internal {

struct Force { double x, y; };

/// The treatment of the boundary after section 2.1.3 of the paper: bubbles on vertices are fixed,
/// bubbles on edges slide and cannot pass the ends, bubbles that would leave a face are put back at a
/// distance from the edge they crossed.
class Boundary_2
{
public:
  /// How near to its edge a bubble is put back, in units of its size. In a hexagonal packing the row
  /// beside an edge lies at 0.87.
  static constexpr double return_distance = 0.5;

  /// No bubble goes farther in one step, in units of its size: an unstable time step must not throw
  /// bubbles through each other.
  static constexpr double longest_step = 0.3;

  explicit Boundary_2(const Domain_2& domain) : m_domain(domain) {}

  /// the part of a vector that a bubble can follow
  Force project(const Bubbles_2& bubbles, std::size_t i, Force f) const
  {
    if (bubbles.is_in_face(i))
      return f;
    if (bubbles.is_corner(i))
      return Force{0, 0};
    const Direction& u = m_domain.direction(bubbles.host[i]);
    const double along = f.x * u.x + f.y * u.y;
    return Force{along * u.x, along * u.y};
  }

  /// moves bubble `i` by (dx, dy) as far as the boundary lets it; returns true if it was put back
  bool move(Bubbles_2& bubbles, std::size_t i, double dx, double dy) const
  {
    if (bubbles.is_corner(i))
      return false;
    const double length = std::sqrt(dx * dx + dy * dy), longest = longest_step * bubbles.d[i];
    if (!(length <= longest)) {
      const double shrink = std::isfinite(length) ? longest / length : 0.;
      dx = std::isfinite(length) ? dx * shrink : 0.;
      dy = std::isfinite(length) ? dy * shrink : 0.;
      bubbles.vx[i] = std::isfinite(bubbles.vx[i]) ? bubbles.vx[i] * shrink : 0.;
      bubbles.vy[i] = std::isfinite(bubbles.vy[i]) ? bubbles.vy[i] * shrink : 0.;
    }
    if (bubbles.is_on_edge(i)) {
      slide(bubbles, i, dx, dy);
      return false;
    }
    return move_in_face(bubbles, i, Point(bubbles.x[i] + dx, bubbles.y[i] + dy));
  }

private:
  void slide(Bubbles_2& bubbles, std::size_t i, double dx, double dy) const
  {
    const Direction& u = m_domain.direction(bubbles.host[i]);
    const double length = m_domain.length(bubbles.host[i]);
    const double wanted = bubbles.s[i] + (dx * u.x + dy * u.y) / length;
    // half a bubble from the ends, but never more than a third of the edge
    const double margin = (std::min)(0.5 * bubbles.d[i] / length, 1. / 3);
    const double s = (std::max)(margin, (std::min)(1 - margin, wanted));
    if (s != wanted)
      bubbles.vx[i] = bubbles.vy[i] = 0;
    bubbles.s[i] = s;
    const Point p = m_domain.point_on_edge(bubbles.host[i], s);
    bubbles.x[i] = p.x();
    bubbles.y[i] = p.y();
  }

  bool move_in_face(Bubbles_2& bubbles, std::size_t i, const Point& target) const
  {
    const Point from = bubbles.point(i);
    Walk_end end = m_domain.walk(bubbles.host[i], from, target);
    if (!end.is_blocked()) {
      settle(bubbles, i, target, end.triangle);
      return false;
    }
    const Index e = m_domain.edge(end.triangle, end.edge);
    const Direction& u = m_domain.direction(e);
    const Point& a = m_domain.source(e);
    const double along = (target.x() - a.x()) * u.x + (target.y() - a.y()) * u.y;
    const double side =
      (from.y() - a.y()) * u.x - (from.x() - a.x()) * u.y >= 0 ? return_distance : -return_distance;
    const Point back(a.x() + along * u.x - side * bubbles.d[i] * u.y,
                     a.y() + along * u.y + side * bubbles.d[i] * u.x);
    const double v = bubbles.vx[i] * u.x + bubbles.vy[i] * u.y;
    bubbles.vx[i] = v * u.x;
    bubbles.vy[i] = v * u.y;
    end = m_domain.walk(bubbles.host[i], from, back);
    if (!end.is_blocked()) // else there is no room, and the bubble stays where it was
      settle(bubbles, i, back, end.triangle);
    return true;
  }

  static void settle(Bubbles_2& bubbles, std::size_t i, const Point& p, Index triangle)
  {
    bubbles.x[i] = p.x();
    bubbles.y[i] = p.y();
    bubbles.host[i] = triangle;
  }

  const Domain_2& m_domain;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_BOUNDARY_2_H
