// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_DUAL_FACES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_DUAL_FACES_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/signed_area.h>

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The face of the dual that crosses an edge of the domain in its midpoint, at a right angle: from the circumcentre of
/// the triangle on its right to that on its left. Where there is no triangle it ends at the edge. Lengths on a side are
/// measured from the edge, and negative for a circumcentre beyond it.
struct Dual_face_2
{
  Index triangle; ///< on the left of the edge, which runs from the vertex `a` to `b`
  int side;
  Index a, b;
  bool has_right;  ///< whether there is a triangle on the right
  Point middle;    ///< of the edge
  Direction along; ///< the edge
  double distance; ///< of the vertices
  double left, right, length;
  Sign sign = ZERO; ///< of `length`, exact
};

inline Point circumcenter_of(const Flat_triangulation_2& tr, Index t)
{
  return CGAL::circumcenter(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2));
}

/// The signed distance of the circumcentre from a side of a triangle, over the length of the side: half the cotangent
/// of the angle opposite to it.
/// \throws std::invalid_argument if the triangle has no area in double
inline double height_of_circumcenter(const Flat_triangulation_2& tr, Index t, int i)
{
  const Point &p = tr.point(t, i), &q = tr.point(t, ccw(i)), &r = tr.point(t, cw(i));
  const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = r.x() - p.x(), vy = r.y() - p.y();
  const double cross = twice_signed_area(p, q, r);
  if (!(cross > 0))
    throw std::invalid_argument("Bubble_relaxation_2: the triangle at " + in_words(p.x(), p.y()) +
                                " is too flat to have a circumcentre in double");
  return 0.5 * (ux * vx + uy * vy) / cross;
}

/// The sign of the length of a face, exact: that of the cotangents' sum.
inline Sign sign_of_face(const Flat_triangulation_2& tr, Index t, int i)
{
  const Point &p = tr.point(t, i), &q = tr.point(t, ccw(i)), &r = tr.point(t, cw(i));
  const Index n = tr.neighbors[t][i];
  if (n == no_index || !tr.inside[n])
    return CGAL::enum_cast<Sign>(CGAL::angle(q, p, r));
  return -CGAL::side_of_oriented_circle(p, q, r, tr.point(n, tr.index_of_neighbor(n, t)));
}

inline Point middle_of_side(const Flat_triangulation_2& tr, Index t, int i)
{
  const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
  return Point(p.x() + (q.x() - p.x()) / 2, p.y() + (q.y() - p.y()) / 2);
}

inline Dual_face_2 dual_face(const Flat_triangulation_2& tr, Index t, int i)
{
  const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)], n = tr.neighbors[t][i];
  const Point &p = tr.points[a], &q = tr.points[b];
  const bool has_right = n != no_index && tr.inside[n];
  const double dx = q.x() - p.x(), dy = q.y() - p.y(), length = std::sqrt(dx * dx + dy * dy);
  const double left = length * height_of_circumcenter(tr, t, i);
  Dual_face_2 face{t, i, a, b, has_right, middle_of_side(tr, t, i), {dx / length, dy / length}, length, left, 0, left};
  if (has_right)
    face.length += length * height_of_circumcenter(tr, n, tr.index_of_neighbor(n, t));
  face.sign = sign_of_face(tr, t, i);
  if (CGAL::sign(face.length) != face.sign) // by roundings
    face.length = 0;
  (has_right ? face.right : face.left) = has_right ? face.length - left : face.length;
  return face;
}

/// one for each edge of the domain
inline std::vector<Dual_face_2> dual_faces(const Flat_triangulation_2& tr)
{
  std::vector<Dual_face_2> faces;
  for_each_edge(tr, 0, tr.number_of_triangles(), [&](Index t, int i) { faces.push_back(dual_face(tr, t, i)); });
  return faces;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_DUAL_FACES_H
