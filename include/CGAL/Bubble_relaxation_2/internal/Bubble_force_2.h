// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_FORCE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_FORCE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

struct Force { double x, y; };

/// The interbubble force, eq. 2 of the paper: repulsion for w < 1, attraction for 1 < w < 1.5, nothing
/// beyond, where w is the distance over the wanted distance.
struct Bubble_force_2
{
  static constexpr double cut_off = 1.5;

  double coefficient = 1; ///< k0

  double operator()(double w) const
  {
    return w <= cut_off ? coefficient * (w * w * (1.25 * w - 2.375) + 1.125) : 0.;
  }
};

/// The resultant force on bubble `i` at the positions `x`, `y`: the sum over its neighbour set in the
/// order of indices. Each bubble gathers its own sum, so that threads and ranks do not change a bit.
inline Force resultant_force(const Bubble_force_2& force, const Neighbor_sets_2& neighbors,
                             const double* x, const double* y, const double* d, std::size_t i)
{
  Force sum{0, 0};
  for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j) {
    const double dx = x[i] - x[*j], dy = y[i] - y[*j];
    const double wanted = 0.5 * (d[i] + d[*j]);
    const double squared = dx * dx + dy * dy;
    const double reach = Bubble_force_2::cut_off * wanted;
    if (squared > reach * reach)
      continue;
    const double distance = std::sqrt(squared);
    if (distance > 0) {
      const double scale = force(distance / wanted) / distance;
      sum.x += scale * dx;
      sum.y += scale * dy;
    } else { // two bubbles in one place part along the x axis, by their order
      sum.x += (neighbors.is_before(static_cast<Index>(i), *j) ? -1 : 1) * force(0);
    }
  }
  return sum;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_BUBBLE_FORCE_2_H
