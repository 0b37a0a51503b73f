// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_RADIUS_RATIO_2_H
#define CGAL_RADIUS_RATIO_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

template <class Point_2>
double radius_ratio_from_first(const Point_2& p, const Point_2& q, const Point_2& r)
{
  // With the area A and the sides a, b, c:  r_in = 2 A / (a+b+c),  r_out = a b c / (4 A). The area comes
  // from a cross product: the product of differences in eq. 11 loses all digits of a flat triangle.
  double ux = CGAL::to_double(q.x() - p.x()), uy = CGAL::to_double(q.y() - p.y());
  double vx = CGAL::to_double(r.x() - p.x()), vy = CGAL::to_double(r.y() - p.y());
  const double scale =
    (std::max)({std::abs(ux), std::abs(uy), std::abs(vx), std::abs(vy)});
  if (!(scale > 0))
    return 0;
  ux /= scale;
  uy /= scale;
  vx /= scale;
  vy /= scale;
  const double a = std::sqrt((vx - ux) * (vx - ux) + (vy - uy) * (vy - uy));
  const double b = std::sqrt(vx * vx + vy * vy), c = std::sqrt(ux * ux + uy * uy);
  const double twice_area = ux * vy - uy * vx, sides = a * b * c * (a + b + c);
  return sides > 0 ? (std::min)(1., 4 * twice_area * twice_area / sides) : 0.;
}

/// What rounds depends on the vertex to begin with, so the points decide which that is.
template <class Point_2>
double radius_ratio(const Point_2& p, const Point_2& q, const Point_2& r)
{
  if (CGAL::lexicographically_xy_smaller(q, p) && CGAL::lexicographically_xy_smaller(q, r))
    return radius_ratio_from_first(q, r, p);
  if (CGAL::lexicographically_xy_smaller(r, p))
    return radius_ratio_from_first(r, p, q);
  return radius_ratio_from_first(p, q, r);
}

} // namespace internal
} // namespace Bubble_relaxation_2

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief returns q = 2 r_in / r_out of the triangle `pqr`, twice the radius of its inscribed circle over the
radius of its circumscribed circle (eq. 11 of the paper): 1 if it is equilateral, 0 if it is degenerate.

The value does not depend on the orientation, on the vertex that comes first, nor on the scale: coordinates may
be as large or small as their differences can be represented.

\tparam Point_2 the point type of a model of `Kernel`; the value is of its type `FT`, with the digits of
`double` also if that is exact
*/
template <class Point_2>
typename Kernel_traits<Point_2>::Kernel::FT radius_ratio_2(const Point_2& p, const Point_2& q,
                                                           const Point_2& r)
{
  using FT = typename Kernel_traits<Point_2>::Kernel::FT;
  return FT(Bubble_relaxation_2::internal::radius_ratio(p, q, r));
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_RADIUS_RATIO_2_H
