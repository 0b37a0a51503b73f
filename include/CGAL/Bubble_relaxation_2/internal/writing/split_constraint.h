// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_SPLIT_CONSTRAINT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_SPLIT_CONSTRAINT_H

#include <CGAL/Constrained_triangulation_2.h>

#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether a side of a face, split at `p`, leaves triangles in it that are counterclockwise.
template <class Cdt>
bool sees_side(const Cdt& cdt, const typename Cdt::Point& p, typename Cdt::Face_handle f, int i)
{
  if (cdt.is_infinite(f))
    return true;
  const auto orientation = cdt.geom_traits().orientation_2_object();
  const typename Cdt::Point& c = f->vertex(i)->point();
  return orientation(c, f->vertex(Cdt::ccw(i))->point(), p) == LEFT_TURN &&
         orientation(c, p, f->vertex(Cdt::cw(i))->point()) == LEFT_TURN;
}

/// The same on both sides of an edge.
template <class Cdt>
bool splits_validly(const Cdt& cdt, const typename Cdt::Point& p, typename Cdt::Face_handle f, int i)
{
  return sees_side(cdt, p, f, i) && sees_side(cdt, p, f->neighbor(i), cdt.mirror_index(f, i));
}

template <class Cdt>
void set_constraint(Cdt& cdt, typename Cdt::Face_handle f, int i, bool is_constrained)
{
  f->neighbor(i)->set_constraint(cdt.mirror_index(f, i), is_constrained);
  f->set_constraint(i, is_constrained);
}

/// Splits a constrained edge at a point on it, or beside it. \pre it splits validly
template <class Cdt>
typename Cdt::Vertex_handle split_constraint(Cdt& cdt, const typename Cdt::Point& p, typename Cdt::Face_handle f, int i)
{
  if constexpr (!std::is_same<typename Cdt::Intersection_tag, No_constraint_intersection_tag>::value) {
    return cdt.insert(p, Cdt::EDGE, f, i);
  } else { // CGAL does not split constraints with this tag: that would be an intersection
    const typename Cdt::Vertex_handle ends[] = {f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i))};
    set_constraint(cdt, f, i, false);
    const typename Cdt::Vertex_handle v = cdt.insert(p, Cdt::EDGE, f, i);
    if constexpr (Cdt::Constraint_hierarchy_tag::value)
      cdt.hierarchy_ref().split_constraint(ends[0], ends[1], v);
    for (typename Cdt::Vertex_handle end : ends) {
      cdt.is_edge(v, end, f, i);
      set_constraint(cdt, f, i, true);
    }
    return v;
  }
}

/// An insertion never flips edges at the new vertex, which is right for a point on the edge that it splits. Beside it
/// by a rounding, in a needle, it may see another vertex across the edge that was split.
template <class Cdt>
void restore_delaunay_around(Cdt& cdt, typename Cdt::Vertex_handle v)
{
  typename Cdt::List_edges edges;
  auto e = cdt.incident_edges(v), first = e;
  do
    if (cdt.is_flipable(e->first, e->second, false))
      edges.push_back(*e);
  while (++e != first);
  if (!edges.empty())
    cdt.propagating_flip(edges);
}

/// makes two edges of a vertex locally Delaunay that an edge was flipped between
template <class Cdt>
void restore_delaunay(Cdt& cdt, typename Cdt::Vertex_handle v, typename Cdt::Vertex_handle u,
                      typename Cdt::Vertex_handle w)
{
  typename Cdt::List_edges edges;
  for (typename Cdt::Vertex_handle other : {u, w}) {
    typename Cdt::Face_handle f;
    int i;
    if (cdt.is_edge(v, other, f, i) && cdt.is_flipable(f, i, false))
      edges.push_back(typename Cdt::Edge(f, i));
  }
  if (!edges.empty())
    cdt.propagating_flip(edges);
}

/// The infinite face after a vertex of the hull that lies in a dent of it, if there is one. While others hang on the
/// vertex there may be several: the one with the first vertex after it, in lexicographic order.
template <class Cdt>
typename Cdt::Face_handle dent_at(const Cdt& cdt, typename Cdt::Vertex_handle v)
{
  typename Cdt::Face_handle result;
  typename Cdt::Vertex_handle next;
  auto f = cdt.incident_faces(v), first = f;
  do {
    const int i = f->index(v);
    if (!cdt.is_infinite(f->vertex(cdt.cw(i))))
      continue;
    // counterclockwise in this face: v, the next vertex w of the hull, infinite. Seen from there the hull runs
    // u, v, w clockwise, and a left turn is a dent.
    const typename Cdt::Vertex_handle u = cdt.mirror_vertex(f, cdt.ccw(i)), w = f->vertex(cdt.ccw(i));
    if (cdt.geom_traits().orientation_2_object()(u->point(), v->point(), w->point()) == LEFT_TURN &&
        (result == typename Cdt::Face_handle() || cdt.compare_xy(w->point(), next->point()) == SMALLER)) {
      result = f;
      next = w;
    }
  } while (++f != first);
  return result;
}

/// A vertex on an edge of the convex hull may lie inside of the edge by a rounding, or outside, and then its
/// neighbors may. The triangles between them and the hull are real, though outside of the domain.
/// \param doubtful such vertices and their neighbors
template <class Cdt>
void make_hull_convex(Cdt& cdt, std::vector<typename Cdt::Vertex_handle> doubtful)
{
  while (!doubtful.empty()) {
    const typename Cdt::Vertex_handle v = doubtful.back();
    typename Cdt::Face_handle after = dent_at(cdt, v);
    if (after == typename Cdt::Face_handle()) {
      doubtful.pop_back();
      continue;
    }
    const int i = cdt.ccw(after->index(v));
    const typename Cdt::Vertex_handle w = after->vertex(i), u = cdt.mirror_vertex(after, i);
    cdt.flip(after, i);
    restore_delaunay(cdt, v, u, w);
    doubtful.insert(doubtful.end(), {u, w});
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_SPLIT_CONSTRAINT_H
