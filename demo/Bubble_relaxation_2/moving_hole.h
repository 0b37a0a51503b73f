// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MOVING_HOLE_H
#define BUBBLE_RELAXATION_2_DEMO_MOVING_HOLE_H

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/squared_distance_2.h>

#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <vector>

/// The only hole of a convex domain, in a mesh: its constraints are taken out and put in elsewhere. What that makes of
/// the triangles is no mesh yet, so those around are to be meshed anew then.
template <class CDT>
class Moving_hole
{
public:
  using Vertex_handle = typename CDT::Vertex_handle;
  using Face_handle = typename CDT::Face_handle;
  using Outline = std::vector<typename CDT::Point>;

  /// \param outline of the hole; its points are vertices of `cdt`
  Moving_hole(CDT& cdt, const Outline& outline) : m_cdt(cdt), m_outline(outline)
  {
    m_corner = find(outline[0]);
  }

  /// told of each vertex that goes, before it does
  std::function<void(Vertex_handle)> on_removal = [](Vertex_handle) {};

  /// Moves it. Vertices nearer to the new place than `room` go, if they are not constrained or `stays(vertex)`.
  template <class Stays>
  void move(const Outline& to, double room, const Stays& stays)
  {
    remove_constraints(vertices());
    clear(to, room, stays);
    m_outline = to;
    std::vector<Vertex_handle> corners;
    for (const auto& p : to)
      corners.push_back(m_cdt.insert(p, corners.empty() ? Face_handle() : corners.back()->face()));
    for (std::size_t k = 0; k < corners.size(); ++k)
      m_cdt.insert_constraint(corners[k], corners[(k + 1) % corners.size()]);
    m_corner = corners[0];
    mark();
  }

  void move(const Outline& to, double room)
  {
    move(to, room, [](Vertex_handle) { return false; });
  }

  /// on its border, in their order, with those that split its constraints
  std::vector<Vertex_handle> vertices() const
  {
    std::vector<Vertex_handle> result{m_corner};
    Vertex_handle last;
    for (;;) {
      const Vertex_handle next = neighbor(result.back(), last);
      if (next == m_corner)
        return result;
      last = result.back();
      result.push_back(next);
    }
  }

private:
  Vertex_handle find(const typename CDT::Point& p) const
  {
    typename CDT::Locate_type type;
    int i = 0;
    const Face_handle f = m_cdt.locate(p, type, i);
    if (type != CDT::VERTEX)
      throw std::invalid_argument("a point of the hole is no vertex");
    return f->vertex(i);
  }

  /// the other end of a constraint at `v` that does not lead to `last`
  Vertex_handle neighbor(Vertex_handle v, Vertex_handle last) const
  {
    auto e = m_cdt.incident_edges(v), first = e;
    do {
      const Vertex_handle a = e->first->vertex(CDT::ccw(e->second)), b = e->first->vertex(CDT::cw(e->second)),
                          other = a == v ? b : a;
      if (m_cdt.is_constrained(*e) && other != last)
        return other;
    } while (++e != first);
    throw std::logic_error("the hole is open");
  }

  void remove_constraints(const std::vector<Vertex_handle>& loop)
  {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      Face_handle f;
      int i = 0;
      if (m_cdt.is_edge(loop[k], loop[(k + 1) % loop.size()], f, i))
        m_cdt.remove_constrained_edge(f, i);
    }
  }

  template <class Stays>
  void clear(const Outline& to, double room, const Stays& stays)
  {
    const auto is_in_the_way = [&](Vertex_handle v) {
      if (CGAL::bounded_side_2(to.begin(), to.end(), v->point()) != CGAL::ON_UNBOUNDED_SIDE)
        return true;
      for (std::size_t k = 0; k < to.size(); ++k)
        if (CGAL::squared_distance(typename CDT::Segment(to[k], to[(k + 1) % to.size()]), v->point()) < room * room)
          return true;
      return false;
    };
    std::set<Vertex_handle> seen;
    std::vector<Vertex_handle> found;
    const auto look_at = [&](Vertex_handle v) {
      if (!m_cdt.is_infinite(v) && seen.insert(v).second && is_in_the_way(v))
        found.push_back(v);
    };
    for (const auto& p : to) {
      const Face_handle f = m_cdt.locate(p, m_corner->face());
      for (int i = 0; i < 3; ++i)
        look_at(f->vertex(i));
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      auto v = m_cdt.incident_vertices(found[k]), first = v;
      do
        look_at(v);
      while (++v != first);
    }
    for (Vertex_handle v : found)
      if (!m_cdt.are_there_incident_constraints(v) && !stays(v)) {
        on_removal(v);
        m_cdt.remove(v);
      }
  }

  /// All is in the domain but what the constraints of the hole enclose. Faces that are made by insertions do not know.
  void mark()
  {
    for (Face_handle f : m_cdt.finite_face_handles())
      f->set_in_domain(true);
    m_cdt.infinite_face()->set_in_domain(false);
    Face_handle f;
    int i = 0;
    m_cdt.is_edge(m_corner, neighbor(m_corner, Vertex_handle()), f, i);
    std::vector<Face_handle> inside{is_inside(f) ? f : f->neighbor(i)};
    inside[0]->set_in_domain(false);
    for (std::size_t k = 0; k < inside.size(); ++k)
      for (int j = 0; j < 3; ++j) {
        const Face_handle n = inside[k]->neighbor(j);
        if (!inside[k]->is_constrained(j) && n->is_in_domain()) {
          n->set_in_domain(false);
          inside.push_back(n);
        }
      }
  }

  bool is_inside(Face_handle f) const
  {
    return CGAL::bounded_side_2(m_outline.begin(), m_outline.end(), CGAL::centroid(m_cdt.triangle(f))) ==
           CGAL::ON_BOUNDED_SIDE;
  }

  CDT& m_cdt;
  Outline m_outline;
  Vertex_handle m_corner; // a corner of the outline
};

#endif // BUBBLE_RELAXATION_2_DEMO_MOVING_HOLE_H
