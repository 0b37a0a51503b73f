// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/linear_values.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

/// Shares of the three corners of a triangle; none is negative, and their sum is 1.
using Weights_3 = std::array<double, 3>;

/// a value that is linear in the triangle; constants come out to the last bit
inline double linear_value(const Weights_3& w, const std::array<double, 3>& values)
{
  return values[0] + w[1] * (values[1] - values[0]) + w[2] * (values[2] - values[0]);
}

/// The point of a triangle that is the nearest to `q`, on one of its sides.
struct Nearest_on_sides
{
  Weights_3 weights{{1, 0, 0}};
  double squared_distance = std::numeric_limits<double>::infinity();

  Nearest_on_sides(const Face_set_2& faces, Index t, const Point& q)
  {
    for (int i = 0; i < 3; ++i) {
      const Nearest_on_side_2 n(faces.point(t, i), faces.point(t, ccw(i)), q);
      if (n.squared_distance >= squared_distance)
        continue;
      squared_distance = n.squared_distance;
      weights = {};
      weights[i] = 1 - n.share;
      weights[ccw(i)] = n.share;
    }
  }
};

/// Weights from areas that are proportional to them. Those of a point that lies beside its triangle by a rounding are
/// those of one on its side. All are 0 if all areas are.
inline Weights_3 normalized(const std::array<double, 3>& areas)
{
  Weights_3 w{(std::max)(0., areas[0]), (std::max)(0., areas[1]), (std::max)(0., areas[2])};
  const double sum = w[0] + w[1] + w[2];
  for (double& weight : w)
    weight = sum > 0 ? weight / sum : 0;
  return w;
}

/// the weights in a point of a triangle
inline Weights_3 barycentric_weights(const Face_set_2& faces, Index t, const Point& q)
{
  const Weights_3 w = normalized({twice_signed_area(q, faces.point(t, 1), faces.point(t, 2)),
                                  twice_signed_area(q, faces.point(t, 2), faces.point(t, 0)),
                                  twice_signed_area(q, faces.point(t, 0), faces.point(t, 1))});
  // in a triangle without area only sides tell where a point is
  return w[0] + w[1] + w[2] > 0 ? w : Nearest_on_sides(faces, t, q).weights;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_BARYCENTRIC_WEIGHTS_H
