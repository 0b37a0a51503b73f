// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_INSERT_ON_CONSTRAINT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_INSERT_ON_CONSTRAINT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/flood_faces.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/Constraint_search_2.h>

#include <CGAL/utility.h>

#include <stdexcept>
#include <unordered_set>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether nothing is on the segment between two vertices: no vertex, and no constraint that crosses it.
template <class Cdt>
bool sees(const Cdt& cdt, typename Cdt::Vertex_handle v, typename Cdt::Vertex_handle target)
{
  const auto side = [&](typename Cdt::Vertex_handle w) {
    return cdt.geom_traits().orientation_2_object()(v->point(), target->point(), w->point());
  };
  if (cdt.is_edge(v, target))
    return true;
  auto f = cdt.incident_faces(v), first = f;
  do
    if (const int i = f->index(v); !cdt.is_infinite(f) && side(f->vertex(Cdt::ccw(i))) == RIGHT_TURN &&
                                   side(f->vertex(Cdt::cw(i))) == LEFT_TURN) {
      typename Cdt::Face_handle at = f; // walks over its side `k`
      for (int k = i; !at->is_constrained(k);) {
        const typename Cdt::Face_handle next = at->neighbor(k);
        const int apex = cdt.mirror_index(at, k);
        if (next->vertex(apex) == target)
          return true;
        if (cdt.is_infinite(next) || side(next->vertex(apex)) == COLLINEAR)
          return false;
        // seen from here, the next vertex counterclockwise from the apex is on the left, that clockwise on the right
        k = side(next->vertex(apex)) == LEFT_TURN ? Cdt::ccw(apex) : Cdt::cw(apex);
        at = next;
      }
      return false;
    }
  while (++f != first);
  return false;
}

/// Leads a constrained edge over a point beside it.
template <class Cdt>
class Constraint_bend_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Cdt_point = typename Cdt::Point;

public:
  Constraint_bend_2(Cdt& cdt, const typename Cdt::Edge& e)
    : m_cdt(cdt), m_source(e.first->vertex(Cdt::ccw(e.second))), m_target(e.first->vertex(Cdt::cw(e.second)))
  {}

  /// \param v the vertex of the point, if it has one
  /// \throws std::invalid_argument if constraints, or a vertex, are in the way
  template <class NamedParameters>
  Vertex_handle operator()(const Cdt_point& p, Vertex_handle v, [[maybe_unused]] const NamedParameters& np)
  {
    using Maps = Tag_maps<NamedParameters>;
    const bool is_new = v == Vertex_handle();
    const Cdt_point place = is_new ? p : v->point();
    const bool is_beside =
      m_cdt.geom_traits().orientation_2_object()(m_source->point(), m_target->point(), place) != COLLINEAR;
    if (!is_beside)
      release(m_source, m_target);
    if (is_new)
      v = planar().insert(p);
    if (!bend(v, is_beside)) {
      if (is_new)
        planar().remove(v);
      if (!is_beside)
        planar().insert_constraint(m_source, m_target);
      const Point at = point_in_double<Cdt>(place);
      throw std::invalid_argument("Bubble_relaxation_2: a constraint, or a vertex, is in the way of the constraint "
                                  "that is to pass " + in_words(at.x(), at.y()));
    }
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      m_cdt.hierarchy_ref().split_constraint(m_source, m_target, v);
    if constexpr (Maps::has_markers) {
      const auto key = CGAL::make_sorted_pair(m_source, m_target);
      const auto marker = get(Maps(np).markers(), key);
      forget_if_possible(Maps(np).markers(), key);
      for (Vertex_handle end : {m_source, m_target})
        put(Maps(np).markers(), CGAL::make_sorted_pair(end, v), marker);
    }
    return v;
  }

private:
  auto& planar() { return without_hierarchy(m_cdt); }

  /// makes an edge no constraint
  void release(Vertex_handle u, Vertex_handle v)
  {
    typename Cdt::Face_handle f;
    int i = 0;
    planar().is_edge(u, v, f, i);
    planar().remove_constrained_edge(f, i);
  }

  /// \param is_beside whether `v` is not on the edge, which is a constraint yet then
  bool bend(Vertex_handle v, bool is_beside)
  {
    if (!sees(planar(), v, m_source) || !sees(planar(), v, m_target))
      return false;
    for (Vertex_handle end : {m_source, m_target})
      planar().insert_constraint(end, v);
    if (!is_beside)
      return true;
    if (is_clear(v)) {
      release(m_source, m_target);
      return true;
    }
    for (Vertex_handle end : {m_source, m_target})
      release(end, v);
    return false;
  }

  /// whether there are no constraints in the triangle of the edge and `v`, all of whose sides are some
  bool is_clear(Vertex_handle v)
  {
    typename Cdt::Face_handle f;
    int i = 0;
    planar().is_edge(m_source, m_target, f, i);
    const auto side = [&](Vertex_handle w) {
      return m_cdt.geom_traits().orientation_2_object()(m_source->point(), m_target->point(), w->point());
    };
    if (m_cdt.is_infinite(f->vertex(i)) || side(f->vertex(i)) != side(v))
      f = f->neighbor(i);
    bool result = true;
    std::unordered_set<const void*> reached;
    flood_faces(f, reached, [&](typename Cdt::Face_handle g) {
      for (int k = 0; k < 3; ++k)
        if (const Vertex_handle w = g->vertex(k); w != m_source && w != m_target && w != v)
          result = result && !m_cdt.are_there_incident_constraints(w);
    });
    return result;
  }

  Cdt& m_cdt;
  Vertex_handle m_source, m_target;
};

/// What is near to a point. `taken`: a vertex that is to stand for it, if there is one; `edge`: that of a constraint
/// which is to pass it, without a face if there is none
template <class Cdt>
struct Constraint_nearby_2
{
  typename Cdt::Vertex_handle taken;
  typename Cdt::Edge edge{typename Cdt::Face_handle(), 0};

  Constraint_nearby_2(const Cdt& cdt, const typename Cdt::Point& p, double tolerance, typename Cdt::Locate_type where,
                      typename Cdt::Face_handle face, int index)
  {
    const Constraint_search_2<Cdt> near_point(cdt, p, tolerance, face);
    taken = near_point.vertex();
    if (taken == typename Cdt::Vertex_handle())
      // exactly on one constraint, another may still be nearer by roundings
      edge = where == Cdt::EDGE && face->is_constrained(index) ? typename Cdt::Edge(face, index) : near_point.edge();
    else if (!cdt.are_there_incident_constraints(taken))
      edge = Constraint_search_2<Cdt>(cdt, taken->point(), tolerance, taken->face()).edge();
  }
};

/// Inserts a point into the constraint that it lies beside, if there is one, and which it leads over it.
template <class Cdt, class NamedParameters>
typename Cdt::Vertex_handle insert_on_constraint(Cdt& cdt, const typename Cdt::Point& p, double tolerance,
                                                 const NamedParameters& np)
{
  check_not_negative("tolerance", tolerance);
  const Point q = point_in_double<Cdt>(p);
  if (!is_coordinate(q.x()) || !is_coordinate(q.y()))
    throw std::invalid_argument("Bubble_relaxation_2: the coordinates of the point " + in_words(q.x(), q.y()) +
                                " must be " + required_of_coordinates(q.x(), q.y()));
  if (cdt.dimension() < 2)
    throw std::invalid_argument("Bubble_relaxation_2: a triangulation without faces has no sides of constraints");
  typename Cdt::Locate_type where{};
  int index = 0;
  const auto face = cdt.locate(p, where, index);
  const Constraint_nearby_2<Cdt> near(cdt, p, tolerance, where, face, index);
  if (near.edge.first != typename Cdt::Face_handle())
    return Constraint_bend_2<Cdt>(cdt, near.edge)(p, near.taken, np);
  return near.taken != typename Cdt::Vertex_handle() ? near.taken : cdt.insert(p, where, face, index);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_INSERT_ON_CONSTRAINT_H
