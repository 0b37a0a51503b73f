// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Barycentric_weights.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/signed_area.h>

#include <algorithm>
#include <array>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether the interiors of two triangles meet: unless a side of one of them has the other on its outer side. Decided
/// by exact orientations, so triangles that only share a side or a vertex never count as a pair.
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

/// The polygon that a triangle of the source and one of the target have in common: the latter is cut along the sides of
/// the former (Sutherland and Hodgman, Comm. ACM 17 (1974)).
///
/// All is done in barycentric coordinates of both triangles, which are ratios of areas. So no tolerance decides
/// anything, errors are roundings of shares of the triangle's area, and nothing changes when both meshes are stretched,
/// sheared or moved: needles that overlap needles are as good as any other triangles.
class Overlap_polygon_2
{
public:
  /// the most corners: three become four, then, if roundings made them not convex, six and nine
  static constexpr int most = 9;

  struct Corner
  {
    std::array<double, 3> target, source; ///< barycentric, of the source not divided by its area
  };

  Overlap_polygon_2(const Face_set_2& source, Index s, const Face_set_2& target, Index t) : m_size(3)
  {
    for (int k = 0; k < 3; ++k) {
      m_corners[k].target = {};
      m_corners[k].target[k] = 1;
      for (int i = 0; i < 3; ++i)
        m_corners[k].source[i] =
          twice_signed_area(target.point(t, k), source.point(s, ccw(i)), source.point(s, cw(i)));
    }
    for (int i = 0; i < 3; ++i)
      keep_inside(i);
    const double target_area = target.area(t);
    for_each_triangle([&](int, int, int, double share) { m_area += share * target_area; });
  }

  int size() const { return m_size; }
  double area() const { return m_area; } ///< 0 or less for what is nothing but roundings

  /// of a corner in the target's triangle, and in the source's
  Weights_3 target_weights(int k) const { return m_corners[k].target; }
  Weights_3 source_weights(int k) const { return normalized(m_corners[k].source); }

  /// calls `visit(i, j, k, share)` for the triangles of the polygon, by the numbers of their corners, with their share
  /// of the area of the target's triangle
  template <class Visitor>
  void for_each_triangle(const Visitor& visit) const
  {
    for (int i = 2; i < m_size; ++i) {
      const Offset_2 a = in_target(i - 1) - in_target(0), b = in_target(i) - in_target(0);
      visit(0, i - 1, i, cross(a, b));
    }
  }

private:
  Offset_2 in_target(int k) const { return {m_corners[k].target[1], m_corners[k].target[2]}; }

  /// cuts off what lies beyond the side of the source's triangle opposite to its corner `i`
  void keep_inside(int i)
  {
    std::array<Corner, most> kept;
    int n = 0;
    for (int k = 0; k < m_size; ++k) {
      const Corner &c = m_corners[k], &next = m_corners[k + 1 == m_size ? 0 : k + 1];
      if (c.source[i] >= 0)
        kept[n++] = c;
      if (c.source[i] > 0 && next.source[i] < 0)
        kept[n++] = crossing(c, next, i);
      else if (c.source[i] < 0 && next.source[i] > 0)
        kept[n++] = crossing(next, c, i);
    }
    m_corners = kept;
    m_size = n;
  }

  static Corner crossing(const Corner& inner, const Corner& outer, int i)
  {
    const double s = inner.source[i] / (inner.source[i] - outer.source[i]);
    Corner c;
    for (int k = 0; k < 3; ++k) {
      c.target[k] = inner.target[k] + s * (outer.target[k] - inner.target[k]);
      c.source[k] = inner.source[k] + s * (outer.source[k] - inner.source[k]);
    }
    c.source[i] = 0;
    return c;
  }

  std::array<Corner, most> m_corners;
  int m_size;
  double m_area = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_OVERLAP_POLYGON_2_H
