// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_DISC_OF_TRIANGLE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_DISC_OF_TRIANGLE_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <cmath>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

struct Disc_2
{
  double x, y, radius;
};

/// The circumscribed disc of a triangle, or a bit more; that of the domain's box if rounding hides it.
inline Disc_2 disc_of_triangle(const Bubble_mesh_2& mesh, Index t, const Bbox_2& box)
{
  constexpr double margin = 1e-6;
  const Point p = mesh.point(t, 0), q = mesh.point(t, 1), r = mesh.point(t, 2);
  const double ax = q.x() - p.x(), ay = q.y() - p.y(), bx = r.x() - p.x(), by = r.y() - p.y();
  const double a = ax * ax + ay * ay, b = bx * bx + by * by, area2 = ax * by - ay * bx;
  if (!(area2 > margin * (a + b))) {
    const double dx = box.x_span() / 2, dy = box.y_span() / 2;
    return Disc_2{box.xmin() + dx, box.ymin() + dy, (1 + margin) * length_of(dx, dy)};
  }
  const double x = (by * a - ay * b) / (2 * area2), y = (ax * b - bx * a) / (2 * area2);
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * (std::abs(p.x()) + std::abs(p.y()));
  return Disc_2{p.x() + x, p.y() + y, (1 + margin) * length_of(x, y) + rounding};
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_DISC_OF_TRIANGLE_H
