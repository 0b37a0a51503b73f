// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_STAR_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_STAR_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>

#include <boost/container/small_vector.hpp>

#include <limits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The neighbours of a bubble in the Delaunay triangulation of some bubbles around it, by wrapping: from the
/// nearest one, which is a neighbour, to the one whose triangle has an empty circle, and so on. Computed with
/// doubles: where four bubbles lie on a circle two stars may disagree about which of them are neighbours.
class Delaunay_star_2
{
public:
  using Indices = boost::container::small_vector<Index, 24>;

  Delaunay_star_2(const Bubbles_2& bubbles, Index center) : m_bubbles(bubbles), m_center(center) {}

  /// `candidates`: the bubbles around. The neighbours come counterclockwise; if the star is open, which it is
  /// where the candidates leave an angle of 180 degrees, from one end to the other.
  void wrap(const Indices& candidates)
  {
    m_ring.clear();
    m_is_closed = false;
    m_largest_circle = 0;
    const Index first = nearest(candidates);
    if (first == no_index)
      return;
    m_ring.push_back(first);
    for (;;) {
      const Index next = beside(m_ring.back(), candidates, 1);
      if (next == no_index)
        break;
      m_is_closed = next == first;
      if (m_is_closed || m_ring.size() > candidates.size())
        return;
      m_ring.push_back(next);
    }
    for (;;) { // the other way from the first
      const Index next = beside(m_ring.front(), candidates, -1);
      if (next == no_index || m_ring.size() > candidates.size())
        return;
      m_ring.insert(m_ring.begin(), next);
    }
  }

  const Indices& ring() const { return m_ring; }
  bool is_closed() const { return m_is_closed; }
  /// the largest square radius of its triangles' circles over the square size of the bubble
  double largest_circle() const { return m_largest_circle; }

private:
  Index nearest(const Indices& candidates) const
  {
    Index best = no_index;
    double least = std::numeric_limits<double>::infinity();
    for (Index j : candidates) {
      const double dx = m_bubbles.x[j] - m_bubbles.x[m_center], dy = m_bubbles.y[j] - m_bubbles.y[m_center];
      const double squared = dx * dx + dy * dy;
      if (squared > 0 && squared < least) {
        least = squared;
        best = j;
      }
    }
    return best;
  }

  /// the candidate on the left (`side` 1) or right of the ray to neighbour `j` that sees the bubble and `j` in
  /// the largest angle: no other lies in their circle on this side
  Index beside(Index j, const Indices& candidates, int side)
  {
    const double x = m_bubbles.x[m_center], y = m_bubbles.y[m_center], unit = 1 / m_bubbles.d[m_center];
    const double ux = (m_bubbles.x[j] - x) * unit, uy = (m_bubbles.y[j] - y) * unit;
    Index best = no_index;
    double least = std::numeric_limits<double>::infinity(); // cotangent of the angle
    for (Index k : candidates) {
      const double vx = (m_bubbles.x[k] - x) * unit, vy = (m_bubbles.y[k] - y) * unit;
      const double area = side * (ux * vy - uy * vx);
      if (k == j || !(area > flat))
        continue;
      const double cotangent = (vx * (vx - ux) + vy * (vy - uy)) / area;
      if (cotangent < least) {
        least = cotangent;
        best = k;
      }
    }
    if (best != no_index) {
      const double circle = 0.25 * (ux * ux + uy * uy) * (1 + least * least); // (a / (2 sin))^2
      m_largest_circle = circle > m_largest_circle ? circle : m_largest_circle;
    }
    return best;
  }

  /// twice the area, in square sizes, of triangles that count as none
  static constexpr double flat = 1e-9;

  const Bubbles_2& m_bubbles;
  Index m_center;
  Indices m_ring;
  bool m_is_closed = false;
  double m_largest_circle = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_STAR_2_H
