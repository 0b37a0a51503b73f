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

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The neighbours of a bubble in the Delaunay triangulation of some bubbles around it, by wrapping: from the
/// nearest one, which is a neighbour, to the one whose triangle has an empty circle, and so on. Computed with
/// doubles, up to roundings; of bubbles on one circle their numbers decide which are neighbours.
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

  /// the cotangent of the angle in which candidate `k` sees the bubble and its neighbour `j`, if it lies on the
  /// left (`side` 1) or right of the ray to `j`; else infinity
  double cotangent(Index j, Index k, int side) const
  {
    const double x = m_bubbles.x[m_center], y = m_bubbles.y[m_center], unit = 1 / m_bubbles.d[m_center];
    const double ux = (m_bubbles.x[j] - x) * unit, uy = (m_bubbles.y[j] - y) * unit;
    const double vx = (m_bubbles.x[k] - x) * unit, vy = (m_bubbles.y[k] - y) * unit;
    const double area = side * (ux * vy - uy * vx);
    return k != j && area > flat ? (vx * (vx - ux) + vy * (vy - uy)) / area
                                 : std::numeric_limits<double>::infinity();
  }

  /// the candidate beside the ray to `j` with the largest angle: no other lies in its circle on this side
  Index beside(Index j, const Indices& candidates, int side)
  {
    double least = std::numeric_limits<double>::infinity();
    for (Index k : candidates)
      least = (std::min)(least, cotangent(j, k, side));
    if (least == std::numeric_limits<double>::infinity())
      return no_index;
    const double ux = m_bubbles.x[j] - m_bubbles.x[m_center], uy = m_bubbles.y[j] - m_bubbles.y[m_center];
    const double d = m_bubbles.d[m_center];
    // (side / (2 sin))^2
    m_largest_circle = (std::max)(m_largest_circle, 0.25 * (ux * ux + uy * uy) / (d * d) * (1 + least * least));
    m_equal.clear();
    for (Index k : candidates)
      if (cotangent(j, k, side) <= least + equal * (1 + std::abs(least)))
        m_equal.push_back(k);
    return m_equal.size() == 1 ? m_equal.front() : choice_on_circle(j, side);
  }

  /// Of several on one circle all are connected to the one with the smallest number. All stars agree on that.
  Index choice_on_circle(Index j, int side) const
  {
    const Index smallest = *std::min_element(m_equal.begin(), m_equal.end());
    if (smallest < m_center && smallest < j)
      return smallest;
    const bool wants_next = m_center < j; // the next on the circle after j, or the last before the center
    Index best = m_equal.front();
    for (Index k : m_equal) {
      const double x = m_bubbles.x[m_center], y = m_bubbles.y[m_center];
      const double turn = side * ((m_bubbles.x[best] - x) * (m_bubbles.y[k] - y) -
                                  (m_bubbles.y[best] - y) * (m_bubbles.x[k] - x));
      if (wants_next ? turn < 0 : turn > 0)
        best = k;
    }
    return best;
  }

  /// twice the area, in square sizes, of triangles that count as none
  static constexpr double flat = 1e-9;
  /// differences of cotangents that count as none
  static constexpr double equal = 1e-7;

  const Bubbles_2& m_bubbles;
  Index m_center;
  Indices m_ring, m_equal;
  bool m_is_closed = false;
  double m_largest_circle = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_STAR_2_H
