// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_RHOMBIC_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_RHOMBIC_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The initial bubbles of the faces after section 2.1.2 of the paper: a rhombus with angles of 60 and
/// 120 degrees around the domain is cut in four until a cell is as small as d asks, and gets a bubble
/// in its centre. Where d is constant this is the hexagonal lattice.
template <class Sizing>
class Rhombic_placement
{
public:
  Rhombic_placement(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles)
    : m_domain(domain), m_sizing(sizing), m_bubbles(bubbles),
      m_buckets(least_distance, bubbles.d[0], domain.bbox().xmin(), domain.bbox().ymin(),
                4 * bubbles.size())
  {}

  void operator()()
  {
    // the rhombus spanned by (1, 0) and (1/2, sqrt(3)/2) whose side is a power of two times d in some
    // place of the domain, so that a constant d is met exactly
    const Bbox_2& box = m_domain.bbox();
    const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin();
    const double needed = (std::max)(width + height / std::sqrt(3.), height * 2 / std::sqrt(3.));
    double side = *std::min_element(m_bubbles.d.begin(), m_bubbles.d.end());
    while (side < needed)
      side *= 2;
    m_x0 = box.xmin() - height / std::sqrt(3.);
    m_y0 = box.ymin();

    std::vector<Index> boundary(m_bubbles.size());
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      boundary[i] = static_cast<Index>(i);
      m_buckets.insert(boundary[i], m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
    }
    subdivide(0, 0, side, boundary, 0);
  }

private:
  /// bubbles of the faces start no nearer to others than this, in units of the mean size
  static constexpr double least_distance = 0.6;

  Point point(double u, double v) const
  {
    return Point(m_x0 + u + 0.5 * v, m_y0 + 0.5 * std::sqrt(3.) * v);
  }

  /// `boundary`: the bubbles of vertices and edges in the cell; `hint`: a triangle near by
  void subdivide(double u, double v, double side, const std::vector<Index>& boundary, Index hint)
  {
    const Point center = point(u + 0.5 * side, v + 0.5 * side);
    const Index triangle = m_domain.locate(center, hint);
    const bool is_inside = triangle != no_index && m_domain.is_inside(triangle);
    // the domain misses a cell with neither boundary nor centre in it, up to bits smaller than a cell
    if (!is_inside && boundary.empty())
      return;
    const double d = is_inside ? m_sizing(center) : 0;
    double smallest = is_inside ? d : m_bubbles.d[boundary.front()];
    if (side > 2 * smallest || !is_inside)
      for (Index i : boundary)
        smallest = (std::min)(smallest, m_bubbles.d[i]);
    if (side > std::sqrt(2.) * smallest) {
      std::vector<Index> part[4];
      for (Index i : boundary) {
        const double bv = (m_bubbles.y[i] - m_y0) / (0.5 * std::sqrt(3.));
        const double bu = m_bubbles.x[i] - m_x0 - 0.5 * bv;
        part[(bu >= u + 0.5 * side) + 2 * (bv >= v + 0.5 * side)].push_back(i);
      }
      for (int k = 0; k < 4; ++k)
        subdivide(u + 0.5 * side * (k & 1), v + 0.5 * side * (k >> 1), 0.5 * side, part[k],
                  triangle == no_index ? hint : triangle);
      return;
    }
    if (is_inside && m_buckets.for_each_near(center.x(), center.y(), d,
                                             [](Index, double, double) { return false; })) {
      m_buckets.insert(static_cast<Index>(m_bubbles.size()), center.x(), center.y(), d);
      m_bubbles.add(center, d, Bubbles_2::FACE, triangle);
    }
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
  Bubbles_2& m_bubbles;
  Bubble_buckets_2 m_buckets;
  double m_x0 = 0, m_y0 = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_RHOMBIC_H
