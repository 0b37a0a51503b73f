// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Hilbert's curve through a square that contains a box, in cells of 2^-32 of its side. The key of a point
/// tells how far along the curve its cell lies. Unlike the order of `hilbert_sort()` it depends on no other
/// point, so parts of a set can be ordered apart from each other.
class Hilbert_curve_2
{
public:
  using Key = std::uint64_t;

  static constexpr int levels = 32;

  /// The first half of the curve lies left of the second one; or, if `is_upright`, below it.
  explicit Hilbert_curve_2(const Bbox_2& box, bool is_upright = false)
    : m_x0(box.xmin()), m_y0(box.ymin()), m_is_upright(is_upright)
  {
    const double side = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    m_side = side > 0 ? side : 1.;
    m_scale = cells / m_side;
  }

  double side() const { return m_side; } ///< of the square

  Key key(double x, double y) const { return key_of_cell(column(x), row(y), levels); }

  std::uint32_t column(double x) const { return coordinate(x - m_x0); } ///< of a point; beside, the nearest
  std::uint32_t row(double y) const { return coordinate(y - m_y0); }

  /// The key of the cell in a column and a row of 2^`depth` of them, among cells of its size: quarter by quarter. In a
  /// quarter the curve lies as in the whole, or with columns and rows exchanged, and then perhaps both mirrored.
  Key key_of_cell(std::uint32_t x, std::uint32_t y, int depth) const
  {
    std::uint32_t are_exchanged = m_is_upright, are_mirrored = 0;
    Key key = 0;
    for (int level = depth - 1; level >= 0; --level) {
      const std::uint32_t column = x >> level & 1, row = y >> level & 1;
      // without a branch, which nobody could foresee
      const std::uint32_t change = ((column ^ row) & are_exchanged) ^ are_mirrored;
      const std::uint32_t right = column ^ change, up = row ^ change, is_lower = up ^ 1;
      key = key << 2 | ((3 * right) ^ up);
      are_exchanged ^= is_lower; // the curve in the lower quarters is mirrored at a diagonal
      are_mirrored ^= is_lower & right;
    }
    return key;
  }

private:
  static constexpr double cells = 4294967296.; // in a row

  std::uint32_t coordinate(double offset) const
  {
    const double c = offset * m_scale;
    return c >= cells ? ~std::uint32_t(0) : c > 0 ? static_cast<std::uint32_t>(c) : 0u;
  }

  double m_x0, m_y0, m_side, m_scale;
  bool m_is_upright;
};

/// The indices of points along a Hilbert curve. Points in one of its cells are in lexicographic order, those
/// in one place in that of their indices.
inline std::vector<Index> hilbert_order(const Hilbert_curve_2& curve, const std::vector<Point>& points,
                                        const Threads& threads = Threads())
{
  struct Numbered_key
  {
    Hilbert_curve_2::Key key;
    Index index;
  };
  std::vector<Numbered_key> keys(points.size());
  parallel_for(threads, points.size(), [&](std::size_t i) {
    keys[i] = Numbered_key{curve.key(points[i].x(), points[i].y()), static_cast<Index>(i)};
  });
  parallel_sort(threads, keys, [&points](const Numbered_key& a, const Numbered_key& b) {
    if (a.key != b.key)
      return a.key < b.key;
    const Point &p = points[a.index], &q = points[b.index];
    return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : a.index < b.index;
  });
  std::vector<Index> result(points.size());
  parallel_for(threads, keys.size(), [&](std::size_t k) { result[k] = keys[k].index; });
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H
