// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// How Hilbert's curve goes through the quarters of a square, and of these, several levels at once. The curve in a
/// square lies in one of four ways: with columns and rows exchanged (1), and then both mirrored (2), or not.
class Hilbert_steps
{
public:
  static constexpr int levels = 4; ///< at once

  /// the place of a small square along the curve in the large one, and how the curve lies in it
  struct Step
  {
    std::uint8_t key, orientation;
  };

  constexpr Hilbert_steps() : m_steps()
  {
    for (unsigned orientation = 0; orientation < 4; ++orientation)
      for (unsigned x = 0; x < side; ++x)
        for (unsigned y = 0; y < side; ++y)
          m_steps[orientation][x][y] = all_levels(orientation, x, y);
  }

  /// in column `x` and row `y`, of which the lowest bits count
  constexpr Step operator()(unsigned orientation, std::uint32_t x, std::uint32_t y) const
  {
    return m_steps[orientation][x % side][y % side];
  }

  static constexpr Step one_level(unsigned orientation, unsigned x, unsigned y)
  {
    const unsigned mirror = orientation >> 1;
    const unsigned right = (orientation & 1 ? y : x) ^ mirror, up = (orientation & 1 ? x : y) ^ mirror;
    // the curve in the lower quarters is mirrored at a diagonal
    const unsigned next = up == 0 ? orientation ^ (1 | right << 1) : orientation;
    return Step{static_cast<std::uint8_t>((3 * right) ^ up), static_cast<std::uint8_t>(next)};
  }

private:
  static constexpr unsigned side = 1u << levels;

  static constexpr Step all_levels(unsigned orientation, unsigned x, unsigned y)
  {
    Step result{0, static_cast<std::uint8_t>(orientation)};
    for (int level = levels - 1; level >= 0; --level) {
      const Step s = one_level(result.orientation, x >> level & 1, y >> level & 1);
      result = Step{static_cast<std::uint8_t>(result.key << 2 | s.key), s.orientation};
    }
    return result;
  }

  Step m_steps[4][side][side];
};

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
    const double side = (std::max)(box.x_span(), box.y_span());
    m_side = side > 0 ? side : 1.;
    m_scale = cells / m_side;
  }

  double side() const { return m_side; } ///< of the square

  Key key(double x, double y) const { return key_of_cell(column(x), row(y), levels); }

  std::uint32_t column(double x) const { return coordinate(x - m_x0); } ///< of a point; beside, the nearest
  std::uint32_t row(double y) const { return coordinate(y - m_y0); }

  /// the key of the cell in a column and a row of 2^`depth` of them, among cells of its size
  Key key_of_cell(std::uint32_t x, std::uint32_t y, int depth) const
  {
    constexpr int at_once = Hilbert_steps::levels;
    static constexpr Hilbert_steps steps;
    unsigned orientation = m_is_upright;
    Key key = 0;
    int level = depth;
    for (; level % at_once != 0; --level) {
      const Hilbert_steps::Step s = Hilbert_steps::one_level(orientation, x >> (level - 1) & 1, y >> (level - 1) & 1);
      key = key << 2 | s.key;
      orientation = s.orientation;
    }
    while (level > 0) {
      level -= at_once;
      const Hilbert_steps::Step s = steps(orientation, x >> level, y >> level);
      key = key << 2 * at_once | s.key;
      orientation = s.orientation;
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
  std::vector<Numbered_key> keys;
  resize_in_turn(keys, points.size());
  parallel_for(threads, points.size(), [&](std::size_t i) {
    keys[i] = Numbered_key{curve.key(points[i].x(), points[i].y()), static_cast<Index>(i)};
  });
  parallel_sort(threads, keys, [&points](const Numbered_key& a, const Numbered_key& b) {
    if (a.key != b.key)
      return a.key < b.key;
    const Point &p = points[a.index], &q = points[b.index];
    return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : a.index < b.index;
  });
  std::vector<Index> result;
  resize_in_turn(result, points.size());
  parallel_for(threads, keys.size(), [&](std::size_t k) { result[k] = keys[k].index; });
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HILBERT_CURVE_2_H
