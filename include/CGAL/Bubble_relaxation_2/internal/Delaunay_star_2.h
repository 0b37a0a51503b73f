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
#include <cstddef>
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
    take(candidates);
    const std::size_t first = nearest();
    if (first == none)
      return;
    Positions ring(1, first);
    m_is_closed = wrap_left(first, ring);
    if (!m_is_closed && ring.size() <= m_others.size())
      wrap_right(first, ring);
    for (std::size_t k : ring)
      m_ring.push_back(m_others[k].index);
  }

  const Indices& ring() const { return m_ring; }
  bool is_closed() const { return m_is_closed; }
  /// the largest square radius of its triangles' circles over the square size of the bubble
  double largest_circle() const { return m_largest_circle; }

private:
  using Positions = boost::container::small_vector<std::size_t, 24>;

  /// another bubble, in coordinates relative to the center and in units of its size
  struct Other
  {
    double x, y;
    Index index;
  };

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void take(const Indices& candidates)
  {
    const double x = m_bubbles.x[m_center], y = m_bubbles.y[m_center], unit = 1 / m_bubbles.d[m_center];
    m_others.clear();
    for (Index j : candidates)
      m_others.push_back(Other{(m_bubbles.x[j] - x) * unit, (m_bubbles.y[j] - y) * unit, j});
    m_cotangents.resize(m_others.size());
  }

  std::size_t nearest() const
  {
    std::size_t best = none;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < m_others.size(); ++k) {
      const double squared = m_others[k].x * m_others[k].x + m_others[k].y * m_others[k].y;
      if (squared > 0 && squared < least) {
        least = squared;
        best = k;
      }
    }
    return best;
  }

  /// goes around to the left; returns whether it comes back to the first
  bool wrap_left(std::size_t first, Positions& ring)
  {
    while (ring.size() <= m_others.size()) {
      const std::size_t next = beside(ring.back(), 1);
      if (next == none || next == first)
        return next == first;
      ring.push_back(next);
    }
    return false;
  }

  void wrap_right(std::size_t first, Positions& ring)
  {
    Positions right;
    for (std::size_t next = beside(first, -1); next != none && ring.size() + right.size() <= m_others.size();
         next = beside(next, -1))
      right.push_back(next);
    ring.insert(ring.begin(), right.rbegin(), right.rend());
  }

  /// The other bubble on the left (`side` 1) or right of the ray to the one at `j` that sees the center and `j`
  /// in the largest angle: no other lies in its circle on this side.
  std::size_t beside(std::size_t j, int side)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double ux = m_others[j].x, uy = m_others[j].y;
    double least = infinity;
    std::size_t best = none;
    for (std::size_t k = 0; k < m_others.size(); ++k) {
      const double vx = m_others[k].x, vy = m_others[k].y, area = side * (ux * vy - uy * vx);
      m_cotangents[k] = area > flat ? (vx * (vx - ux) + vy * (vy - uy)) / area : infinity;
      if (m_cotangents[k] < least) {
        least = m_cotangents[k];
        best = k;
      }
    }
    if (best == none)
      return none;
    // (side / (2 sin))^2
    m_largest_circle = (std::max)(m_largest_circle, 0.25 * (ux * ux + uy * uy) * (1 + least * least));
    m_equal.clear();
    const double limit = least + equal * (1 + std::abs(least));
    for (std::size_t k = 0; k < m_others.size(); ++k)
      if (m_cotangents[k] <= limit)
        m_equal.push_back(k);
    return m_equal.size() == 1 ? best : choice_on_circle(j, side);
  }

  /// Of several on one circle all are connected to the one with the smallest number. All stars agree on that.
  std::size_t choice_on_circle(std::size_t j, int side) const
  {
    const std::size_t smallest = *std::min_element(m_equal.begin(), m_equal.end(), [this](auto k, auto l) {
      return m_bubbles.is_before(m_others[k].index, m_others[l].index);
    });
    if (m_bubbles.is_before(m_others[smallest].index, m_center) &&
        m_bubbles.is_before(m_others[smallest].index, m_others[j].index))
      return smallest;
    // the next on the circle after j, or the last before the center
    const bool wants_next = m_bubbles.is_before(m_center, m_others[j].index);
    std::size_t best = m_equal.front();
    for (std::size_t k : m_equal) {
      const double turn = side * (m_others[best].x * m_others[k].y - m_others[best].y * m_others[k].x);
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
  Indices m_ring;
  boost::container::small_vector<Other, 24> m_others;
  boost::container::small_vector<double, 24> m_cotangents;
  Positions m_equal; // on one circle
  bool m_is_closed = false;
  double m_largest_circle = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DELAUNAY_STAR_2_H
