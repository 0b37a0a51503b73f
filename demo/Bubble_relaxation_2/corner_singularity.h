// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_CORNER_SINGULARITY_H
#define BUBBLE_RELAXATION_2_DEMO_CORNER_SINGULARITY_H

#include <cmath>
#include <vector>

/// Laplace's equation on the L-shaped domain [-1, 1]^2 without [0, 1] x [-1, 0], with the solution
/// u = r^(2/3) sin(2 theta / 3): it is 0 on the two sides that meet in the inner corner at the origin, and its
/// gradient is infinite there.
template <class Kernel>
struct Corner_singularity
{
  using Point_2 = typename Kernel::Point_2;
  using Vector_2 = typename Kernel::Vector_2;

  static constexpr double pi = 3.14159265358979323846;

  static std::vector<Point_2> outline()
  {
    return {{0, 0}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}, {0, -1}};
  }

  static Point_2 corner() { return Point_2(0, 0); }

  /// counterclockwise from the side y = 0, on which rounding may be on the wrong side
  static double angle(const Point_2& p)
  {
    const double theta = std::atan2(p.y(), p.x());
    return theta < -pi / 4 ? theta + 2 * pi : theta;
  }

  static double value(const Point_2& p)
  {
    const double r2 = p.x() * p.x() + p.y() * p.y();
    return std::cbrt(r2) * std::sin(2 * angle(p) / 3);
  }

  /// \pre p is not the corner
  static Vector_2 gradient(const Point_2& p)
  {
    const double r2 = p.x() * p.x() + p.y() * p.y();
    const double length = 2. / 3 / std::sqrt(std::cbrt(r2)), direction = angle(p) / 3;
    return Vector_2(-length * std::sin(direction), length * std::cos(direction));
  }
};

#endif // BUBBLE_RELAXATION_2_DEMO_CORNER_SINGULARITY_H
