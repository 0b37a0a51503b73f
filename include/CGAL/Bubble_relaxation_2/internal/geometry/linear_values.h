// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LINEAR_VALUES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LINEAR_VALUES_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

/// The point of the side from `a` to `b` that is the nearest to `q`.
struct Nearest_on_side_2
{
  double share = 0;     ///< of the way from `a` to `b`
  bool is_foot = false; ///< of the perpendicular from `q`, not an end of the side beyond which that lies
  double squared_distance;

  Nearest_on_side_2(const Point& a, const Point& b, const Point& q)
  {
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), x = q.x() - a.x(), y = q.y() - a.y();
    const double squared_length = dx * dx + dy * dy;
    if (squared_length > 0) { // it may be none where points are rounded
      const double along = (x * dx + y * dy) / squared_length;
      share = (std::max)(0., (std::min)(1., along));
      is_foot = share == along;
    }
    const double rx = x - share * dx, ry = y - share * dy;
    squared_distance = rx * rx + ry * ry;
  }
};

/// A corner of triangles with a value. Bits of a sum depend on its order: on a side the corner with the smaller rank
/// comes first, whatever triangle asks.
struct Valued_corner_2
{
  Point point;
  double value;
  Index rank;
};

/// the value in the point of a side that is the nearest to `q`
inline double value_on_side(const Valued_corner_2& a, const Valued_corner_2& b, const Point& q)
{
  if (b.rank < a.rank)
    return value_on_side(b, a, q);
  const double s = Nearest_on_side_2(a.point, b.point, q).share;
  return (1 - s) * a.value + s * b.value;
}

/// The value in a point of a triangle; in one of a side only the side's ends count, so that both its triangles give the
/// same bits.
inline double value_in_triangle(const std::array<Valued_corner_2, 3>& c, const Point& q)
{
  double sum = 0, weights = 0;
  for (int i = 0; i < 3; ++i) {
    const Point &a = c[ccw(i)].point, &b = c[cw(i)].point;
    if (CGAL::orientation(a, b, q) == COLLINEAR)
      return value_on_side(c[ccw(i)], c[cw(i)], q);
    const double weight = std::abs((b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x()));
    sum += weight * c[i].value;
    weights += weight;
  }
  // in a triangle as thin as the rounding of its points all weights may be zero, or lose their bits
  constexpr double least = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
  if (weights > least)
    return sum / weights;
  const auto squared = [&](int i) { return CGAL::squared_distance(c[ccw(i)].point, c[cw(i)].point); };
  const int i = squared(0) >= squared(1) && squared(0) >= squared(2) ? 0 : squared(1) >= squared(2) ? 1 : 2;
  return value_on_side(c[ccw(i)], c[cw(i)], q); // the longest one
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LINEAR_VALUES_H
