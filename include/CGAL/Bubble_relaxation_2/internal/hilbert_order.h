// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_ORDER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_ORDER_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The indices of points along the Hilbert curve, where neighbours in space are near each other.
template <class Concurrency_tag = Sequential_tag>
std::vector<Index> hilbert_order(const std::vector<Point>& points)
{
  using Numbered_point = std::pair<Point, Index>;
  std::vector<Numbered_point> order;
  order.reserve(points.size());
  for (const Point& p : points)
    order.emplace_back(p, static_cast<Index>(order.size()));
  hilbert_sort<Concurrency_tag>(
    order.begin(), order.end(),
    Spatial_sort_traits_adapter_2<Kernel, First_of_pair_property_map<Numbered_point>>());
  std::vector<Index> result;
  result.reserve(points.size());
  for (const Numbered_point& p : order)
    result.push_back(p.second);
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_ORDER_H
