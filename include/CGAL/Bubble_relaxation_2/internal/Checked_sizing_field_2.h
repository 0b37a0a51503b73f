// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CHECKED_SIZING_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CHECKED_SIZING_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The user's d(x, y) as the simulation calls it: in doubles, and with a clear exception where the
/// value is no length.
template <class User_point, class Sizing_function>
class Checked_sizing_field_2
{
public:
  explicit Checked_sizing_field_2(const Sizing_function& f) : m_f(f) {}

  double operator()(double x, double y) const
  {
    const double d = CGAL::to_double(m_f(User_point(x, y)));
    if (!(d > 0) || !std::isfinite(d))
      throw_invalid(x, y, d);
    return d;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  [[noreturn]] static void throw_invalid(double x, double y, double d)
  {
    std::ostringstream message;
    message.precision(17);
    message << "npbs_relax: parameter sizing_function: d(" << x << ", " << y << ") = " << d
            << " must be positive and finite";
    throw std::invalid_argument(message.str());
  }

  const Sizing_function& m_f;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CHECKED_SIZING_FIELD_2_H
