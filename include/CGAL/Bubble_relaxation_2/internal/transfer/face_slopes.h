// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SLOPES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SLOPES_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Transfer_problem_2.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the centroid of triangle `n`, from that of `t` on, in units of the two sides of `t` at its first corner
inline Offset_2 centroid_seen_from(const Face_set_2& faces, Index t, Index n)
{
  const Point &p = faces.point(t, 0), &q = faces.point(t, 1), &r = faces.point(t, 2);
  const double area = twice_signed_area(p, q, r);
  Offset_2 sum{0, 0};
  if (n == t || !(area > 0))
    return sum;
  for (int i = 0; i < 3; ++i) {
    sum.x += twice_signed_area(p, faces.point(n, i), r);
    sum.y += twice_signed_area(p, q, faces.point(n, i));
  }
  return {(sum.x / area - 1) / 3, (sum.y / area - 1) / 3};
}

/// The slopes of a linear function in each triangle: by how much it changes from its first corner to the second one and
/// to the third one. The values in the triangles around, which share a corner with it, are met in their centroids as
/// well as can be, by least squares: exactly if the values are those of a linear function. The squares are weighed by
/// the triangle's own shape, so that slopes are as good in meshes of needles. Of very many triangles around a corner
/// only some count, which depend on the order of points alone: else all of them would look at all.
inline std::vector<Offset_2> face_slopes(const Face_set_2& faces, const Triangles_around_2& around,
                                         const std::vector<double>& values)
{
  constexpr std::size_t many = 64; // triangles around a corner
  std::vector<Offset_2> slopes;
  for (std::size_t k = 0; k < faces.number_of_triangles(); ++k) {
    const Index t = static_cast<Index>(k);
    double xx = 0, xy = 0, yy = 0, xu = 0, yu = 0;
    for (Index v : faces.triangles[t]) {
      const auto fan = around[v];
      for (std::size_t m = 0; m < fan.size(); m += 1 + fan.size() / many) {
        const Index n = fan.begin()[m]; // one that shares a side comes twice: the nearer ones count more
        const Offset_2 d = centroid_seen_from(faces, t, n);
        const double du = values[n] - values[t];
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
        xu += d.x * du;
        yu += d.y * du;
      }
    }
    // where all centroids are on a line, as good as, there is no slope across: the triangle keeps its constant
    const double determinant = xx * yy - xy * xy;
    if (determinant > 1e-12 * xx * yy)
      slopes.push_back({(yy * xu - xy * yu) / determinant, (xx * yu - xy * xu) / determinant});
    else
      slopes.push_back({0, 0});
  }
  return slopes;
}

/// the least and the largest value in a triangle and those that share a corner with it
inline std::vector<Bounds> bounds_around(const Face_set_2& faces, const Triangles_around_2& around,
                                         const std::vector<double>& values)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Bounds> at_points(faces.points.size(), Bounds{infinity, -infinity}), bounds;
  for (std::size_t v = 0; v < faces.points.size(); ++v)
    for (Index n : around[v])
      at_points[v].include(values[n]);
  for (const auto& corners : faces.triangles) {
    bounds.push_back(at_points[corners[0]]);
    bounds.back().include(at_points[corners[1]]);
    bounds.back().include(at_points[corners[2]]);
  }
  return bounds;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SLOPES_H
