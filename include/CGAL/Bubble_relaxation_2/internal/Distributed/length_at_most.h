// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_LENGTH_AT_MOST_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_LENGTH_AT_MOST_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The length of a vector or up to 9 % more, without a square root and for coordinates of any order.
inline double length_at_most(double x, double y)
{
  x = std::abs(x);
  y = std::abs(y);
  return (std::max)(x, y) + 0.4143 * (std::min)(x, y); // an octagon in the unit circle: sqrt(2) - 1, rounded up
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_LENGTH_AT_MOST_H
