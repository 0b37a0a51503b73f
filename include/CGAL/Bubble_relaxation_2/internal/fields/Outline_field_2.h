// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A place on the outline of a domain and the size that is wanted there.
struct Size_source_2
{
  Point point;
  double d;
};

/// The size d(x) = min over all sources s of d_s + g |x - s|, which grows by no more than g per unit.
///
/// A quadtree holds in each leaf the few sources that are the least somewhere in it, so a query does not
/// look at all of them; where there would be many, d may be a little too large. The result depends neither
/// on the order of the sources nor on former queries.
class Outline_field_2
{
public:
  static constexpr double gradation = 0.2;

  Outline_field_2(const std::vector<Size_source_2>& sources, const Bbox_2& box)
    : m_x(0.5 * (box.xmin() + box.xmax())), m_y(0.5 * (box.ymin() + box.ymax())),
      m_half_side(0.5 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()))
  {
    m_cells.emplace_back();
    build(0, m_x, m_y, m_half_side, sources, 0);
  }

  double operator()(double x, double y) const
  {
    std::size_t cell = 0;
    double cx = m_x, cy = m_y;
    for (double half = 0.5 * m_half_side; m_cells[cell].first_child != 0; half *= 0.5) {
      const bool is_right = x >= cx, is_upper = y >= cy;
      cell = m_cells[cell].first_child + is_right + 2 * is_upper;
      cx += is_right ? half : -half;
      cy += is_upper ? half : -half;
    }
    const std::vector<Size_source_2>& sources = m_cells[cell].sources;
    double least = size_from(sources.front(), x, y);
    for (const Size_source_2& s : sources)
      least = (std::min)(least, size_from(s, x, y));
    return least;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  static constexpr std::size_t most_sources = 8; // in a leaf
  static constexpr int deepest = 40;

  struct Cell
  {
    std::size_t first_child = 0; // the others follow; 0 in a leaf
    std::vector<Size_source_2> sources;
  };

  static double size_from(const Size_source_2& s, double x, double y)
  {
    const double dx = x - s.point.x(), dy = y - s.point.y();
    return s.d + gradation * std::sqrt(dx * dx + dy * dy);
  }

  static const Size_source_2& nearest(const std::vector<Size_source_2>& sources, double x, double y)
  {
    const Size_source_2* best = &sources.front();
    for (const Size_source_2& s : sources) {
      const double d = size_from(s, x, y), least = size_from(*best, x, y);
      if (d < least || (d == least && s.point < best->point))
        best = &s;
    }
    return *best;
  }

  void build(std::size_t cell, double x, double y, double half,
             const std::vector<Size_source_2>& sources, int depth)
  {
    // within the cell two sources cannot change their order if they differ by more than this
    const double slack = 2 * gradation * std::sqrt(2.) * half;
    const double least = size_from(nearest(sources, x, y), x, y);
    std::vector<Size_source_2> kept;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(kept),
                 [&](const Size_source_2& s) { return size_from(s, x, y) <= least + slack; });
    if (kept.size() <= most_sources) {
      m_cells[cell].sources = std::move(kept);
      return;
    }
    // far from a finely divided outline many sources stay, but d hardly changes within the cell
    if (slack <= 0.5 * least || depth == deepest) {
      for (int k = 0; k < 9; ++k)
        m_cells[cell].sources.push_back(
          nearest(kept, x + (k % 3 - 1) * half, y + (k / 3 - 1) * half));
      return;
    }
    const std::size_t first = m_cells.size();
    m_cells[cell].first_child = first;
    m_cells.resize(first + 4);
    for (int k = 0; k < 4; ++k)
      build(first + k, x + ((k & 1) != 0 ? 0.5 : -0.5) * half, y + ((k & 2) != 0 ? 0.5 : -0.5) * half,
            0.5 * half, kept, depth + 1);
  }

  double m_x, m_y, m_half_side; // of the root
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H
