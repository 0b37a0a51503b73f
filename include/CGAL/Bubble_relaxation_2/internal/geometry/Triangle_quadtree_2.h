// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_TRIANGLE_QUADTREE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_TRIANGLE_QUADTREE_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Where to start the search for the triangle that contains a point: a quadtree whose leaves hold few
/// vertices, so that the walk from there is short whatever the grading. Queries change nothing: they are the
/// same in any order and from any thread, and threads do not wait for each other.
class Triangle_quadtree_2
{
public:
  explicit Triangle_quadtree_2(const Flat_triangulation_2& tr)
  {
    Bbox_2 box;
    for (const Point& p : tr.points)
      box += p.bbox();
    m_x = box.xmin() + (box.xmax() - box.xmin()) / 2;
    m_y = box.ymin() + (box.ymax() - box.ymin()) / 2;
    m_half_side = 0.5 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    std::vector<Index> vertices(tr.points.size());
    std::iota(vertices.begin(), vertices.end(), 0);
    m_cells.emplace_back();
    build(tr, 0, m_x, m_y, 0.5 * m_half_side, vertices.begin(), vertices.end(), 0);
  }

  /// a triangle near to the place
  Index start(double x, double y) const
  {
    std::size_t cell = 0;
    double cx = m_x, cy = m_y;
    for (double half = 0.5 * m_half_side; m_cells[cell].first_child != no_index; half *= 0.5) {
      const bool is_right = x >= cx, is_upper = y >= cy;
      cell = static_cast<std::size_t>(m_cells[cell].first_child) + is_right + 2 * is_upper;
      cx += is_right ? half : -half;
      cy += is_upper ? half : -half;
    }
    return m_cells[cell].triangle;
  }

private:
  static constexpr std::ptrdiff_t most_vertices = 4; // in a leaf
  static constexpr int deepest = 50;

  struct Cell
  {
    Index first_child = no_index; // the others follow; none in a leaf
    Index triangle = 0;           // of a leaf
  };

  using Iterator = std::vector<Index>::iterator;

  /// \param half half of the side of the children
  void build(const Flat_triangulation_2& tr, std::size_t cell, double x, double y, double half,
             Iterator first, Iterator last, int depth)
  {
    if (last - first <= most_vertices || depth == deepest) {
      // neighbouring leaves follow each other, so the last one's triangle is near
      m_last = locate_or_exit(tr, m_last, Point(x, y)).triangle;
      m_cells[cell].triangle = m_last;
      return;
    }
    const Iterator upper =
      std::partition(first, last, [&](Index v) { return !(tr.points[v].y() >= y); });
    const auto is_left = [&](Index v) { return !(tr.points[v].x() >= x); };
    const Iterator ends[5] = {first, std::partition(first, upper, is_left), upper,
                              std::partition(upper, last, is_left), last};
    const std::size_t child = m_cells.size();
    m_cells[cell].first_child = static_cast<Index>(child);
    m_cells.resize(child + 4);
    for (int k = 0; k < 4; ++k)
      build(tr, child + k, x + ((k & 1) != 0 ? half : -half), y + ((k & 2) != 0 ? half : -half),
            0.5 * half, ends[k], ends[k + 1], depth + 1);
  }

  double m_x = 0, m_y = 0, m_half_side = 0; // of the root
  std::vector<Cell> m_cells;
  Index m_last = 0; // while it is built
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_TRIANGLE_QUADTREE_2_H
