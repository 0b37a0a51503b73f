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

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The indices of points along the Hilbert curve, where neighbours in space are near each other.
inline std::vector<Index> hilbert_order(const std::vector<Point>& points)
{
  std::vector<std::size_t> order(points.size()); // the index type of the map
  std::iota(order.begin(), order.end(), 0);
  using Map = Pointer_property_map<Point>::const_type;
  hilbert_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_2<Kernel, Map>(make_property_map(points.data())));
  return std::vector<Index>(order.begin(), order.end());
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_ORDER_H
