// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PLACE_ON_EDGES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PLACE_ON_EDGES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The integral of ds/d along an edge as a piecewise linear function of s in [0,1].
struct Edge_integral
{
  std::vector<double> s;
  std::vector<double> sum;

  double total() const { return sum.back(); }

  /// Into how many of about 1 it is cut. Nothing changes that later, so the parts are to be longer than 1 by no larger
  /// factor than they would be shorter with one more.
  double parts() const
  {
    const double less = (std::max)(1., std::floor(total()));
    return total() * total() > less * (less + 1) ? less + 1 : less;
  }

  /// where the integral reaches `value`
  double invert(double value) const
  {
    const std::size_t k =
      std::lower_bound(sum.begin() + 1, sum.end() - 1, value) - sum.begin();
    return s[k - 1] + (value - sum[k - 1]) / (sum[k] - sum[k - 1]) * (s[k] - s[k - 1]);
  }
};

/// The integral of ds/d over a piece of the given length on which d is linear.
inline double integrate_piece(double length, double d, double next_d)
{
  return std::abs(next_d - d) < 1e-4 * d ? 2 * length / (d + next_d)
                                         : length / (next_d - d) * logarithm_of(next_d / d);
}

/// Integrates ds/d with steps that follow d, as if d were linear in each.
inline Edge_integral integrate_edge(const Domain_2& domain, Index e, const Sizes_2& sizing)
{
  constexpr double step_in_sizes = 0.25;
  constexpr int least_steps = 4;
  const double length = domain.length(e);
  Edge_integral integral{{0}, {0}};
  double s = 0, d = sizing(domain.source(e));
  while (s < 1) {
    // s must grow even where d is less than the rounding of s
    double step = (std::max)(1e-15, (std::min)(step_in_sizes * d / length, 1. / least_steps));
    double next = 0, next_d = 0;
    for (;; step /= 2) { // a steep fall of d asks for smaller steps
      next = s + step > 1 - step / 2 ? 1 : s + step;
      next_d = sizing(domain.point_on_edge(e, next));
      if (next_d >= 0.5 * d || (next - s) * length < 0.01 * next_d || step < 2e-15)
        break;
    }
    integral.s.push_back(next);
    integral.sum.push_back(integral.sum.back() + integrate_piece((next - s) * length, d, next_d));
    s = next;
    d = next_d;
  }
  return integral;
}

/// where on an edge, between 0 and 1, a point of it lies
inline double position_on_edge(const Domain_2& domain, Index e, const Point& p)
{
  const Point &a = domain.source(e), &b = domain.target(e);
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  return ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / (dx * dx + dy * dy);
}

/// Places bubbles on an edge so that they cut it in equal parts of the integral of ds/d.
inline void place_on_edge(const Domain_2& domain, Index e, const Sizes_2& sizing, Bubbles_2& bubbles)
{
  if (!domain.edges()[e].takes_bubbles())
    return;
  const Edge_integral integral = integrate_edge(domain, e, sizing);
  const double parts = integral.parts();
  for (double k = 1; k < parts; ++k) {
    const double s = integral.invert(k / parts * integral.total());
    const Point p = domain.point_on_edge(e, s);
    bubbles.add(p, sizing(p), Bubbles_2::EDGE, e, s);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PLACE_ON_EDGES_H
