// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIGNED_AREA_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIGNED_AREA_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <cmath>

namespace CGAL::Bubble_relaxation_2::internal {

/// A difference of two numbers: rounded, and what the rounding took away (Knuth's exact sum).
struct Exact_difference
{
  double rounded, rest;

  Exact_difference(double a, double b) : rounded(a - b)
  {
    const double b_there = a - rounded, a_there = rounded + b_there;
    rest = (a - a_there) + (b_there - b);
  }
};

/// Twice the area of a triangle, negative if it is clockwise, with almost all digits also where it is thin: the
/// products of differences, which cancel there, are computed with twice the digits (after Dekker, Numer. Math. 18
/// (1971), with a fused multiplication). In meshes of needles areas with an error of roundings of the needle's length
/// squared would not do.
inline double twice_signed_area(const Point& p, const Point& q, const Point& r)
{
  const Exact_difference ax(q.x(), p.x()), ay(q.y(), p.y()), bx(r.x(), p.x()), by(r.y(), p.y());
  const double one = ax.rounded * by.rounded, other = ay.rounded * bx.rounded;
  const double rest_of_one = std::fma(ax.rounded, by.rounded, -one),
               rest_of_other = std::fma(ay.rounded, bx.rounded, -other);
  const double mixed = (ax.rounded * by.rest + ax.rest * by.rounded) - (ay.rounded * bx.rest + ay.rest * bx.rounded);
  const Exact_difference products(one, other);
  return products.rounded + (products.rest + ((rest_of_one - rest_of_other) + mixed));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SIGNED_AREA_H
