// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHT_FUNCTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHT_FUNCTIONS_H

#include <cmath>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// \file
/// Weights of moving least squares as functions of q, the distance from the node in units of its support
/// radius. All decrease from q = 0 to 0 at q = 1, as (1 - q)^3, so that two derivatives are continuous there.

/// A weight W and what its derivatives in the plane are made of: for a vector u of length q,
/// grad W = g u and the Hessian is g I + h u u^T.
struct Radial_weight
{
  double w;
  double g; ///< W'/q
  double h; ///< g'/q; where it grows without bounds for q -> 0, h u u^T still vanishes, and h is 0 at q = 0
};

/// 1 - 6 q^2 + 8 q^3 - 3 q^4
struct Quartic_spline_weight
{
  static Radial_weight at(double q)
  {
    const double r = 1 - q;
    return {r * r * r * (1 + 3 * q), -12 * r * r, q > 0 ? 24 * r / q : 0};
  }
};

/// 2/3 - 4 q^2 + 4 q^3 up to q = 1/2, and 4/3 (1 - q)^3 from there
struct Cubic_spline_weight
{
  static Radial_weight at(double q)
  {
    if (q <= 0.5)
      return {2. / 3 - 4 * q * q * (1 - q), 12 * q - 8, q > 0 ? 12 / q : 0};
    const double r = 1 - q;
    return {4. / 3 * r * r * r, -4 * r * r / q, 4 * r * (1 + q) / (q * q * q)};
  }
};

/// exp(-(q/c)^2) with c = 0.4, less its Taylor polynomial of second order in q^2 about q = 1: with
/// b = 1/c^2 and t = b (1 - q^2) that is exp(-b) (exp(t) - 1 - t - t^2/2), a positive number.
struct Gaussian_weight
{
  static Radial_weight at(double q)
  {
    constexpr double b = 6.25;
    static const double rim = std::exp(-b);
    const double t = b * (1 - q) * (1 + q);
    const double third = remainder(t);
    const double second = third + t * t / 2; // the remainder after one term less, the derivative of the above
    const double first = second + t;
    return {rim * third, -2 * b * rim * second, 4 * b * b * rim * first};
  }

private:
  /// exp(t) - 1 - t - t^2/2 for t >= 0 without the cancellation for small t
  static double remainder(double t)
  {
    if (t > 1)
      return std::exp(t) - 1 - t - t * t / 2;
    double sum = 1;
    for (int k = 17; k > 3; --k) // the first term left out is below 1e-16 of the sum
      sum = 1 + sum * t / k;
    return t * t * t / 6 * sum;
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHT_FUNCTIONS_H
