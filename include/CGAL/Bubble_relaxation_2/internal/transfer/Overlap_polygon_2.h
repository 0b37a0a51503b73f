// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>

#include <algorithm>
#include <array>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether the interiors of two triangles meet: unless a side of one of them has the other on its outer side. Decided by
/// exact orientations, so triangles that only share a side or a vertex never count as a pair.
inline bool have_common_interior(const Face_set_2& a, Index s, const Face_set_2& b, Index t)
{
  const auto separates = [](const Face_set_2& faces, Index f, const Face_set_2& others, Index other) {
    for (int i = 0; i < 3; ++i) {
      const Point &p = faces.point(f, i), &q = faces.point(f, ccw(i));
      int k = 0;
      while (k < 3 && CGAL::orientation(p, q, others.point(other, k)) != LEFT_TURN)
        ++k;
      if (k == 3)
        return true;
    }
    return false;
  };
  return !separates(a, s, b, t) && !separates(b, t, a, s);
}

/// The polygon that two triangles have in common: one is cut along the sides of the other (Sutherland and Hodgman,
/// Comm. ACM 17 (1974)). No tolerance decides anything. Where sides are nearly parallel a corner of the polygon may be
/// off along both, but not by more than roundings across them, so the error of the area is that of roundings too.
class Overlap_polygon_2
{
public:
  using Corners = std::array<Offset_2, 3>;

  /// the most corners: three become four, then, if roundings made them not convex, six and nine
  static constexpr int most = 9;

  Overlap_polygon_2(const Corners& a, const Corners& b) : m_size(3)
  {
    std::copy(a.begin(), a.end(), m_points.begin());
    for (int i = 0; i < 3; ++i)
      keep_left_of(b[i], b[ccw(i)]);
    for (int i = 2; i < m_size; ++i)
      m_area += cross(m_points[i - 1] - m_points[0], m_points[i] - m_points[0]) / 2;
  }

  int size() const { return m_size; }
  const Offset_2& operator[](int i) const { return m_points[i]; }
  double area() const { return m_area; } ///< 0 or less for what is nothing but roundings

  /// calls `visit(i, j, k, area)` for the triangles of the polygon, by the numbers of their corners
  template <class Visitor>
  void for_each_triangle(const Visitor& visit) const
  {
    for (int i = 2; i < m_size; ++i)
      visit(0, i - 1, i, cross(m_points[i - 1] - m_points[0], m_points[i] - m_points[0]) / 2);
  }

  /// the integral of the place, as an offset from `origin`
  Offset_2 first_moment(const Offset_2& origin) const
  {
    Offset_2 sum{0, 0};
    for_each_triangle([&](int i, int j, int k, double area) {
      const Offset_2 a = m_points[i] - origin, b = m_points[j] - origin, c = m_points[k] - origin;
      sum.x += area * (a.x + b.x + c.x) / 3;
      sum.y += area * (a.y + b.y + c.y) / 3;
    });
    return sum;
  }

private:
  void keep_left_of(const Offset_2& a, const Offset_2& b)
  {
    std::array<double, most> side;
    for (int i = 0; i < m_size; ++i)
      side[i] = cross(b - a, m_points[i] - a);
    std::array<Offset_2, most> kept;
    int n = 0;
    for (int i = 0; i < m_size; ++i) {
      const int j = i + 1 == m_size ? 0 : i + 1;
      if (side[i] >= 0)
        kept[n++] = m_points[i];
      if (side[i] > 0 && side[j] < 0)
        kept[n++] = crossing(i, j, side[i] / (side[i] - side[j]));
      else if (side[i] < 0 && side[j] > 0)
        kept[n++] = crossing(j, i, side[j] / (side[j] - side[i]));
    }
    m_points = kept;
    m_size = n;
  }

  Offset_2 crossing(int i, int j, double s) const
  {
    const Offset_2 d = m_points[j] - m_points[i];
    return {m_points[i].x + s * d.x, m_points[i].y + s * d.y};
  }

  std::array<Offset_2, most> m_points;
  int m_size;
  double m_area = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H
