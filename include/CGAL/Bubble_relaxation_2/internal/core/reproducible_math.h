// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_REPRODUCIBLE_MATH_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_REPRODUCIBLE_MATH_H

#include <CGAL/Bubble_relaxation_2/internal/core/check_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

// Functions of which each library of C has its own last bits, here with the same ones everywhere: they are built of
// operations that IEEE 754 rounds in one way, + - * / and the square root, and of what is exact. The stages use these
// and no others. Errors are a few roundings.

namespace CGAL::Bubble_relaxation_2::internal {

/// The length of a vector. Squares of coordinates within bounds (`magnitudes.h`) do not overflow.
inline double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t n>
double polynomial(const double (&c)[n], double x)
{
  double sum = c[n - 1];
  for (std::size_t k = n - 1; k-- > 0;)
    sum = sum * x + c[k];
  return sum;
}

constexpr double half_pi = 1.57079632679489661923;

/// An angle less a number of right angles: what is left is half of one at most.
struct Reduced_angle
{
  double rest;
  unsigned right_angles; ///< modulo 4

  /// \pre some thousands of turns at most
  explicit Reduced_angle(double angle)
  {
    // pi / 2 in two parts, the first with so few digits that its multiples are exact
    constexpr double first_part = 0x1.921fb544p+0, second_part = 0x1.0b4611a626331p-34;
    const double n = std::floor(angle / half_pi + 0.5);
    rest = (angle - n * first_part) - n * second_part;
    right_angles = static_cast<unsigned>(static_cast<int>(n)) & 3;
  }
};

/// the sine of an angle of 45 degrees at most: Taylor's series, of which 0.8^19 / 19! is left
inline double sine_of_small(double a)
{
  constexpr double terms[] = {-1. / 6, 1. / 120, -1. / 5040, 1. / 362880, -1. / 39916800, 1. / 6227020800,
                              -1. / 1307674368000, 1. / 355687428096000};
  return a + a * (a * a * polynomial(terms, a * a));
}

/// its cosine: 0.8^18 / 18! is left
inline double cosine_of_small(double a)
{
  constexpr double terms[] = {-1. / 2, 1. / 24, -1. / 720, 1. / 40320, -1. / 3628800, 1. / 479001600,
                              -1. / 87178291200, 1. / 20922789888000};
  return 1 + a * a * polynomial(terms, a * a);
}

/// \pre as for `Reduced_angle`
inline double sine_of(double angle)
{
  const Reduced_angle r(angle);
  const double s = r.right_angles % 2 == 0 ? sine_of_small(r.rest) : cosine_of_small(r.rest);
  return r.right_angles < 2 ? s : -s;
}

/// \pre as for `Reduced_angle`
inline double cosine_of(double angle)
{
  const Reduced_angle r(angle);
  const double c = r.right_angles % 2 == 0 ? cosine_of_small(r.rest) : sine_of_small(r.rest);
  return r.right_angles == 0 || r.right_angles == 3 ? c : -c;
}

/// x + x^3/3 + x^5/5 + ... for x^2 = `square`, as a share of x beyond x: the inverse hyperbolic tangent of x; and that
/// of i x is i times the inverse tangent. \pre |x| is less than 0.18, then 1e-18 is left
inline double rest_of_inverse_tangent(double square)
{
  constexpr double terms[] = {1. / 3, 1. / 5, 1. / 7, 1. / 9, 1. / 11, 1. / 13, 1. / 15, 1. / 17, 1. / 19, 1. / 21};
  return square * polynomial(terms, square);
}

/// Whether an angle of more than 90 degrees has the direction (x, y), y >= 0. What roundings of their points make of right
/// angles is right.
inline bool is_obtuse(double x, double y) { return x < -1e-12 * y; }

/// The angle from the x-axis to a vector, between -pi and pi; 0 for no vector.
inline double angle_of(double x, double y)
{
  constexpr double known[] = {0, 0.244978663126864154172, 0.463647609000806116214, 0.643501108793284386803,
                              half_pi / 2}; // whose tangents are 0, 1/4, 1/2, 3/4, 1
  const double width = std::abs(x), height = std::abs(y), a = (std::max)(width, height),
               b = (std::min)(width, height);
  if (a == 0)
    return 0;
  const int k = (8 * b > a) + (8 * b > 3 * a) + (8 * b > 5 * a) + (8 * b > 7 * a); // the known angle next to it
  const double tangent = 0.25 * k, t = (b - tangent * a) / (a + tangent * b);      // the rest has the tangent t
  double angle = known[k] + (t + t * rest_of_inverse_tangent(-t * t));
  if (height > width)
    angle = half_pi - angle;
  if (x < 0)
    angle = 2 * half_pi - angle;
  return std::copysign(angle, y);
}

/// The natural logarithm of a finite number; that of 0 is minus infinity. \pre it is not negative
inline double logarithm_of(double x)
{
  if (x == 0)
    return -std::numeric_limits<double>::infinity();
  constexpr double root_of_half = 0.70710678118654752440;
  constexpr double first_part = 0x1.62e42feep-1, second_part = 0x1.a39ef35793c76p-33; // of log 2
  int exponent;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < root_of_half) {
    mantissa *= 2;
    --exponent;
  }
  const double t = (mantissa - 1) / (mantissa + 1); // the logarithm is 2 artanh(t)
  const double small = 2 * t * rest_of_inverse_tangent(t * t) + exponent * second_part;
  return exponent * first_part + (2 * t + small);
}

/// the cube root of a finite number \pre it is not negative
inline double cube_root_of(double x)
{
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  const int third = exponent / 3;
  const double reduced = std::ldexp(mantissa, exponent - 3 * third); // 0, or from 1/8 to 4
  double root = 1;
  for (int step = 0; step < 8; ++step) // Newton's
    root -= (root - reduced / (root * root)) / 3;
  return reduced == 0 ? 0 : std::ldexp(root, third);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_REPRODUCIBLE_MATH_H
