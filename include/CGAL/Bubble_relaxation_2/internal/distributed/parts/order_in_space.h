// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_ORDER_IN_SPACE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_ORDER_IN_SPACE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Whether bubbles that follow each other are near to each other, as they are if they are numbered by the
/// package, but perhaps not by users.
inline bool follow_space(const Bubbles_2& b)
{
  constexpr double far = 30;
  double steps = 0, sizes = 0;
  for (std::size_t i = 1; i < b.size(); ++i) {
    steps += std::abs(b.x[i] - b.x[i - 1]) + std::abs(b.y[i] - b.y[i - 1]);
    sizes += b.d[i];
  }
  return steps <= far * sizes;
}

/// the indices of bubbles, so that those that follow each other are near to each other
inline std::vector<Index> order_in_space(const Hilbert_curve_2& curve, const Bubbles_2& b)
{
  if (follow_space(b)) {
    std::vector<Index> order(b.size());
    std::iota(order.begin(), order.end(), Index(0));
    return order;
  }
  std::vector<Point> points;
  points.reserve(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    points.push_back(b.point(i));
  return hilbert_order(curve, points);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_ORDER_IN_SPACE_H
