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
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A quadtree that has something for each place: what is in the leaf there. Queries change nothing: they are the same
/// in any order and from any thread, and threads do not wait for each other.
template <class Leaf>
class Quadtree_2
{
public:
  struct Square
  {
    double x, y, half; ///< the centre, and half of the side
    int depth;

    Square quarter(int k) const
    {
      return Square{x + ((k & 1) != 0 ? 0.5 : -0.5) * half, y + ((k & 2) != 0 ? 0.5 : -0.5) * half, 0.5 * half,
                    depth + 1};
    }
  };

  /// one leaf
  explicit Quadtree_2(const Square& root) : m_root(root), m_cells(1) {}

  /// From the root on, `fill(square, things, leaf, divide)` puts something into the leaf, or leaves all as it is, or calls
  /// `divide(part)`, where `part(k)` are the things for the quarter `k` of the square. `leaf`: `nullptr` where a square was
  /// divided before
  template <class Things, class Fill>
  void put(const Things& things, Fill&& fill)
  {
    put(0, m_root, things, fill);
  }

  const Leaf& operator()(double x, double y) const
  {
    std::size_t cell = 0;
    double cx = m_root.x, cy = m_root.y;
    for (double half = 0.5 * m_root.half; m_cells[cell].first_child != 0; half *= 0.5) {
      const bool is_right = x >= cx, is_upper = y >= cy;
      cell = static_cast<std::size_t>(m_cells[cell].first_child) + is_right + 2 * is_upper;
      cx += is_right ? half : -half;
      cy += is_upper ? half : -half;
    }
    return m_cells[cell].leaf;
  }

private:
  struct Cell
  {
    Index first_child = 0; // the others follow; 0 in a leaf
    Leaf leaf{};
  };

  template <class Things, class Fill>
  void put(std::size_t cell, const Square& square, const Things& things, Fill& fill)
  {
    const bool is_divided = m_cells[cell].first_child != 0;
    fill(square, things, is_divided ? nullptr : &m_cells[cell].leaf, [&](const auto& part) {
      if (!is_divided) {
        m_cells[cell].first_child = static_cast<Index>(m_cells.size());
        m_cells.resize(m_cells.size() + 4);
      }
      const std::size_t first = static_cast<std::size_t>(m_cells[cell].first_child);
      for (int k = 0; k < 4; ++k)
        put(first + static_cast<std::size_t>(k), square.quarter(k), part(k), fill);
    });
  }

  Square m_root;
  std::vector<Cell> m_cells;
};

/// Where to start the search for the triangle that contains a point: leaves hold few vertices, so that the walk from
/// there is short whatever the grading.
class Triangle_quadtree_2
{
public:
  explicit Triangle_quadtree_2(const Flat_triangulation_2& tr) : m_triangles(make(tr)) {}

  /// a triangle near to the place
  Index start(double x, double y) const { return m_triangles(x, y); }

private:
  using Tree = Quadtree_2<Index>;

  static constexpr std::ptrdiff_t most_vertices = 4; // in a leaf
  static constexpr int deepest = 50;

  static Tree make(const Flat_triangulation_2& tr)
  {
    using Iterator = std::vector<Index>::iterator;
    using Range = std::pair<Iterator, Iterator>;
    const Bbox_2 box = bbox_2(tr.points.begin(), tr.points.end());
    const double width = box.x_span(), height = box.y_span();
    std::vector<Index> vertices = indices_below(tr.points.size());
    Index last = 0; // neighbouring leaves follow each other, so the last one's triangle is near
    const auto fill = [&](const Tree::Square& s, const Range& r, Index* triangle, const auto& divide) {
      if (r.second - r.first <= most_vertices || s.depth == deepest) {
        *triangle = last = locate_or_exit(tr, last, Point(s.x, s.y)).triangle;
        return;
      }
      const auto is_left = [&](Index v) { return !(tr.points[v].x() >= s.x); };
      const Iterator upper =
        std::partition(r.first, r.second, [&](Index v) { return !(tr.points[v].y() >= s.y); });
      const Iterator ends[5] = {r.first, std::partition(r.first, upper, is_left), upper,
                                std::partition(upper, r.second, is_left), r.second};
      divide([&ends](int k) { return Range(ends[k], ends[k + 1]); });
    };
    Tree result({box.xmin() + width / 2, box.ymin() + height / 2, 0.5 * (std::max)(width, height), 0});
    result.put(Range(vertices.begin(), vertices.end()), fill);
    return result;
  }

  Tree m_triangles;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_TRIANGLE_QUADTREE_2_H
