// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLE_QUESTION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLE_QUESTION_2_H

#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The question whether any point that a rank does not know lies where it would change one of its triangles:
/// in the circumscribed disc, and not beyond a side that is a constraint. What lies beyond such a side is
/// hidden by it, since all of the disc there is cut off by that side.
struct Triangle_question_2
{
  std::array<double, 3> x, y; ///< the vertices, counterclockwise
  double xmin, ymin, xmax, ymax; ///< all that matters lies in this box
  std::array<std::int32_t, 3> is_hidden; ///< for each vertex, what lies beyond the opposite side
  std::int32_t vertex; ///< points near to this one matter first
  std::int32_t number; ///< of the question, among those of its rank

  Point point(int i) const { return Point(x[i], y[i]); }
  Bbox_2 box() const { return Bbox_2(xmin, ymin, xmax, ymax); }

  /// exact
  bool concerns(const Point& q) const
  {
    const Point a = point(0), b = point(1), c = point(2);
    if (CGAL::side_of_bounded_circle(a, b, c, q) == ON_UNBOUNDED_SIDE)
      return false;
    for (int i = 0; i < 3; ++i)
      if (is_hidden[i] && CGAL::orientation(point(ccw(i)), point(cw(i)), q) == RIGHT_TURN)
        return false;
    return true;
  }
};

/// Distance from the midpoint of the side `pq` of the triangle `pqr` to the farthest point of the part of
/// its circumscribed disc that lies beyond that side, or a bit more; infinite if rounding hides it.
inline double reach_beyond_side(const Point& p, const Point& q, const Point& r)
{
  constexpr double margin = 1 + 1e-9, rounding = 8 * std::numeric_limits<double>::epsilon();
  const double ax = p.x() - r.x(), ay = p.y() - r.y(), bx = q.x() - r.x(), by = q.y() - r.y();
  const double half = 0.5 * std::hypot(q.x() - p.x(), q.y() - p.y()) * margin;
  const double dot = ax * bx + ay * by;
  if (dot >= 0) // less than half of the disc
    return half;
  // the angle at r is obtuse: that part is as high as half the side times the tangent of half the angle
  const double cross = std::abs(ax * by - ay * bx) - rounding * (std::abs(ax * by) + std::abs(ay * bx));
  if (!(cross > 0))
    return std::numeric_limits<double>::infinity();
  return half * (std::max)(1., margin * (std::hypot(ax, ay) * std::hypot(bx, by) - dot) / cross);
}

/// The part of the plane that matters for the triangle `t`, in a box.
inline Bbox_2 box_that_matters(const Marked_triangulation_2& mesh, Index t, const Bbox_2& domain_box)
{
  const Flat_triangulation_2& tr = mesh.tr;
  Bbox_2 box = tr.point(t, 0).bbox() + tr.point(t, 1).bbox() + tr.point(t, 2).bbox();
  const double largest = (std::max)((std::max)(std::abs(box.xmin()), std::abs(box.xmax())),
                                    (std::max)(std::abs(box.ymin()), std::abs(box.ymax())));
  for (int i = 0; i < 3; ++i) {
    if (mesh.edges[t][i] != no_index)
      continue;
    const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
    const double radius = reach_beyond_side(p, q, tr.point(t, i)) +
                          4 * std::numeric_limits<double>::epsilon() * largest;
    if (!std::isfinite(radius))
      return domain_box;
    const double x = p.x() + (q.x() - p.x()) / 2, y = p.y() + (q.y() - p.y()) / 2;
    box += Bbox_2(x - radius, y - radius, x + radius, y + radius);
  }
  return Bbox_2((std::max)(box.xmin(), domain_box.xmin()), (std::max)(box.ymin(), domain_box.ymin()),
                (std::min)(box.xmax(), domain_box.xmax()), (std::min)(box.ymax(), domain_box.ymax()));
}

inline Triangle_question_2 make_question(const Marked_triangulation_2& mesh, Index t, const Bbox_2& box,
                                         int vertex, std::int32_t number)
{
  Triangle_question_2 question{};
  for (int i = 0; i < 3; ++i) {
    question.x[i] = mesh.tr.point(t, i).x();
    question.y[i] = mesh.tr.point(t, i).y();
    question.is_hidden[i] = mesh.edges[t][i] != no_index;
  }
  question.xmin = box.xmin();
  question.ymin = box.ymin();
  question.xmax = box.xmax();
  question.ymax = box.ymax();
  question.vertex = vertex;
  question.number = number;
  return question;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLE_QUESTION_2_H
