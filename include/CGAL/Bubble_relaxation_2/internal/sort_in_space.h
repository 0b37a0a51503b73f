// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SORT_IN_SPACE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SORT_IN_SPACE_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/hilbert_curve.h>
#include <CGAL/Bubble_relaxation_2/internal/hilbert_order.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Numbers the bubbles along the Hilbert curve: neighbours in space are near in memory.
template <class Concurrency_tag>
void sort_in_space(const Domain_2& domain, Bubbles_2& bubbles)
{
  std::vector<Point> points;
  points.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    points.push_back(bubbles.point(i));
  bubbles.select(hilbert_order<Concurrency_tag>(hilbert_curve(domain), points));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SORT_IN_SPACE_H
