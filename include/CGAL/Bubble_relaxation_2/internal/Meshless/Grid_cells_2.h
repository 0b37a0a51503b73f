// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GRID_CELLS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GRID_CELLS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Background_cell_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Integration_domain_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The rectangles of a regular grid over the bounding box of a domain, as far as they lie in it: those inside as
/// they are, the others as the triangles of their parts inside. So the cells fill the domain, up to rounding.
class Grid_cells_2
{
public:
  Grid_cells_2(const Integration_domain_2& domain, std::size_t nx, std::size_t ny)
    : m_bbox(domain.bbox), m_nx(nx), m_ny(ny), m_parts(nx * ny)
  {
    for (const auto& t : domain.triangles)
      clip(t);
  }

  std::vector<Background_cell_2> cells() const
  {
    std::vector<Background_cell_2> result;
    for (std::size_t j = 0; j < m_ny; ++j)
      for (std::size_t i = 0; i < m_nx; ++i) {
        const Background_cell_2 whole{x(i), y(j), x(i + 1) - x(i), 0, 0, y(j + 1) - y(j), false};
        const std::vector<Background_cell_2>& parts = m_parts[j * m_nx + i];
        double area = 0;
        for (const Background_cell_2& part : parts)
          area += part.area();
        if (area > (1 - 1e-10) * whole.area()) // the sum of what rounded cuts leave of a whole rectangle
          result.push_back(whole);
        else
          result.insert(result.end(), parts.begin(), parts.end());
      }
    return result;
  }

  /// appends the places in (0, 1) where the segment from `a` to `b` crosses lines of the grid, sorted
  void crossings(const Point& a, const Point& b, std::vector<double>& places) const
  {
    for (std::size_t i = 1; i < m_nx; ++i)
      add_crossing(a.x(), b.x(), x(i), places);
    for (std::size_t j = 1; j < m_ny; ++j)
      add_crossing(a.y(), b.y(), y(j), places);
    std::sort(places.begin(), places.end());
  }

private:
  using Polygon = std::vector<Point>;

  static double line(double min, double max, std::size_t i, std::size_t n)
  {
    return i == n ? max : min + (max - min) * (static_cast<double>(i) / static_cast<double>(n));
  }

  double x(std::size_t i) const { return line(m_bbox.xmin(), m_bbox.xmax(), i, m_nx); }
  double y(std::size_t j) const { return line(m_bbox.ymin(), m_bbox.ymax(), j, m_ny); }

  static void add_crossing(double from, double to, double line, std::vector<double>& places)
  {
    if ((from < line && line < to) || (to < line && line < from))
      places.push_back((line - from) / (to - from));
  }

  /// the first line of the grid below a coordinate, or at it
  static std::size_t cell(double min, double max, double value, std::size_t n)
  {
    const double place = std::floor((value - min) / (max - min) * static_cast<double>(n));
    return static_cast<std::size_t>((std::min)((std::max)(place, 0.), static_cast<double>(n - 1)));
  }

  /// adds a triangle's parts to all rectangles that its bounding box meets
  void clip(const std::array<Point, 3>& t)
  {
    const Bbox_2 box = t[0].bbox() + t[1].bbox() + t[2].bbox();
    const std::size_t right = cell(m_bbox.xmin(), m_bbox.xmax(), box.xmax(), m_nx);
    const std::size_t top = cell(m_bbox.ymin(), m_bbox.ymax(), box.ymax(), m_ny);
    for (std::size_t j = cell(m_bbox.ymin(), m_bbox.ymax(), box.ymin(), m_ny); j <= top; ++j) {
      const Polygon row = below(above({t.begin(), t.end()}, y(j), true), y(j + 1), true);
      for (std::size_t i = cell(m_bbox.xmin(), m_bbox.xmax(), box.xmin(), m_nx); i <= right; ++i)
        add(below(above(row, x(i), false), x(i + 1), false), m_parts[j * m_nx + i]);
    }
  }

  /// a convex polygon as triangles
  static void add(const Polygon& p, std::vector<Background_cell_2>& parts)
  {
    for (std::size_t k = 2; k < p.size(); ++k) {
      const Background_cell_2 part{p[0].x(), p[0].y(), p[k - 1].x() - p[0].x(), p[k - 1].y() - p[0].y(),
                                   p[k].x() - p[0].x(), p[k].y() - p[0].y(), true};
      if (part.area() > 0)
        parts.push_back(part);
    }
  }

  static Polygon above(const Polygon& p, double line, bool is_y) { return cut(p, line, is_y, 1); }
  static Polygon below(const Polygon& p, double line, bool is_y) { return cut(p, line, is_y, -1); }

  /// the part of a convex polygon on one side of a line (Sutherland and Hodgman)
  static Polygon cut(const Polygon& polygon, double line, bool is_y, double sign)
  {
    const auto height = [&](const Point& p) { return sign * ((is_y ? p.y() : p.x()) - line); };
    Polygon result;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      const double hp = height(p), hq = height(q);
      if (hp >= 0)
        result.push_back(p);
      if ((hp > 0 && hq < 0) || (hp < 0 && hq > 0)) {
        const double s = hp / (hp - hq);
        result.push_back(is_y ? Point(p.x() + s * (q.x() - p.x()), line)
                              : Point(line, p.y() + s * (q.y() - p.y())));
      }
    }
    return result;
  }

  Bbox_2 m_bbox;
  std::size_t m_nx, m_ny;
  std::vector<std::vector<Background_cell_2>> m_parts; // of each rectangle, row after row
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GRID_CELLS_2_H
