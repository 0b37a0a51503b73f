// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

/// Shares of the three corners of a triangle; none is negative, and their sum is 1.
using Weights_3 = std::array<double, 3>;

/// a value that is linear in the triangle; constants come out to the last bit
inline double linear_value(const Weights_3& w, const std::array<double, 3>& values)
{
  return values[0] + w[1] * (values[1] - values[0]) + w[2] * (values[2] - values[0]);
}

/// The point of a triangle, with the corners `c`, that is the nearest to `q`, on one of its sides.
struct Nearest_on_sides
{
  Weights_3 weights{{1, 0, 0}};
  double squared_distance = std::numeric_limits<double>::infinity();

  Nearest_on_sides(const std::array<Offset_2, 3>& c, const Offset_2& q)
  {
    for (int i = 0; i < 3; ++i) {
      const Offset_2 side = c[ccw(i)] - c[i], to_q = q - c[i];
      const double length = dot(side, side);
      const double s = length > 0 ? (std::min)(1., (std::max)(0., dot(side, to_q) / length)) : 0;
      const Offset_2 miss{to_q.x - s * side.x, to_q.y - s * side.y};
      if (dot(miss, miss) >= squared_distance)
        continue;
      squared_distance = dot(miss, miss);
      weights = {};
      weights[i] = 1 - s;
      weights[ccw(i)] = s;
    }
  }
};

/// The barycentric coordinates of a point that lies in the triangle, or beside it by a rounding. In a needle that may be
/// by much in units of its width: negative ones become 0, so that the value is one that the field has near by.
inline Weights_3 barycentric_weights(const std::array<Offset_2, 3>& c, const Offset_2& q)
{
  const Offset_2 a = c[0] - q, b = c[1] - q, d = c[2] - q;
  Weights_3 w{(std::max)(0., cross(b, d)), (std::max)(0., cross(d, a)), (std::max)(0., cross(a, b))};
  const double sum = w[0] + w[1] + w[2];
  if (!(sum > 0))
    return Nearest_on_sides(c, q).weights; // a triangle without area
  for (double& weight : w)
    weight /= sum;
  return w;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H
