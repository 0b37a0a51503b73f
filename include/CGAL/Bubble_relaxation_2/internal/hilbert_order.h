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
#include <CGAL/Bubble_relaxation_2/internal/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The indices of points along a Hilbert curve. Points in one of its cells are in lexicographic order, those
/// in one place in that of their indices.
template <class Concurrency_tag = Sequential_tag>
std::vector<Index> hilbert_order(const Hilbert_curve_2& curve, const std::vector<Point>& points)
{
  struct Numbered_key
  {
    Hilbert_curve_2::Key key;
    Index index;
  };
  std::vector<Numbered_key> keys(points.size());
  parallel_for<Concurrency_tag>(points.size(), [&](std::size_t i) {
    keys[i] = Numbered_key{curve.key(points[i].x(), points[i].y()), static_cast<Index>(i)};
  });
  parallel_sort<Concurrency_tag>(keys, [&points](const Numbered_key& a, const Numbered_key& b) {
    if (a.key != b.key)
      return a.key < b.key;
    const Point &p = points[a.index], &q = points[b.index];
    return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : a.index < b.index;
  });
  std::vector<Index> result(points.size());
  parallel_for<Concurrency_tag>(keys.size(), [&](std::size_t k) { result[k] = keys[k].index; });
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_ORDER_H
