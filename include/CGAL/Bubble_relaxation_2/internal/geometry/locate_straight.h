// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LOCATE_STRAIGHT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LOCATE_STRAIGHT_H

#include <CGAL/enum.h>

#include <array>

namespace CGAL::Bubble_relaxation_2::internal {

/// whether a point lies in a finite face or on its boundary; tells where, as `locate()` does
template <class Triangulation>
bool is_in_face(const Triangulation& tr, const typename Triangulation::Point& p,
                typename Triangulation::Face_handle f, typename Triangulation::Locate_type& where, int& index)
{
  const auto orientation = tr.geom_traits().orientation_2_object();
  std::array<int, 3> sides{}; // that the point lies on
  int number = 0;
  for (int i = 0; i < 3; ++i) {
    const Orientation turn = orientation(f->vertex(tr.ccw(i))->point(), f->vertex(tr.cw(i))->point(), p);
    if (turn == RIGHT_TURN)
      return false;
    if (turn == COLLINEAR)
      sides[number++] = i;
  }
  where = number == 0 ? Triangulation::FACE : number == 1 ? Triangulation::EDGE : Triangulation::VERTEX;
  index = number < 2 ? sides[0] : 3 - sides[0] - sides[1];
  return number < 3;
}

/// What `locate()` of a triangulation tells, found on the straight way from a vertex. CGAL's own walk turns by coins that
/// repeat themselves after 2^18 tosses: in a fan of needles beside constraints it may go round for ever.
template <class Triangulation>
typename Triangulation::Face_handle locate_straight(const Triangulation& tr, const typename Triangulation::Point& p,
                                                    typename Triangulation::Vertex_handle from,
                                                    typename Triangulation::Locate_type& where, int& index)
{
  if (tr.dimension() == 2 && !tr.xy_equal(from->point(), p)) {
    auto f = tr.line_walk(from->point(), p, from->face());
    for (; f != nullptr && !tr.is_infinite(f); ++f)
      if (is_in_face(tr, p, f, where, index))
        return f;
  }
  return tr.locate(p, where, index, from->face()); // the vertex itself, or beyond the hull
}

/// Inserts a point, found on the straight way from a vertex; returns its vertex.
template <class Triangulation>
typename Triangulation::Vertex_handle insert_straight(Triangulation& tr, const typename Triangulation::Point& p,
                                                      typename Triangulation::Vertex_handle from)
{
  typename Triangulation::Locate_type where{};
  int index = 0;
  const auto f = locate_straight(tr, p, from, where, index);
  return tr.insert(p, where, f, index);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_LOCATE_STRAIGHT_H
