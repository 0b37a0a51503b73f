// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_DIRECT_WRITE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_DIRECT_WRITE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Whether a kernel has coordinates in double and exact predicates.
template <class Traits, class = void>
struct Is_exact_on_doubles : std::false_type {};

template <class Traits>
struct Is_exact_on_doubles<Traits, std::enable_if_t<Traits::Has_filtered_predicates_tag::value>>
  : std::is_same<typename Traits::FT, double> {};

/// Whether a triangulation is CGAL's constrained Delaunay triangulation itself, on such a kernel: what is
/// derived from it, like `Constrained_triangulation_plus_2`, may know more of its vertices and faces.
template <class Cdt>
struct Is_plain : std::false_type {};

template <class Traits, class Tds, class Itag>
struct Is_plain<Constrained_Delaunay_triangulation_2<Traits, Tds, Itag>> : Is_exact_on_doubles<Traits> {};

/// Writes the mesh in arrays into the triangulation that its domain was read from, triangle by triangle: a mesh
/// that is known need not be found again by insertion. Vertices of corners and pinned vertices stay. Nothing
/// else does, so it is for triangulations that hold nothing but the domain.
template <class Cdt>
class Direct_write_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Reading = Domain_reading_2<Cdt>;

public:
  Direct_write_2(Cdt& cdt, const Reading& reading, const Bubble_mesh_2& mesh, const Elevations<Cdt>& elevations)
    : m_cdt(cdt), m_reading(reading), m_bubble_mesh(mesh), m_bubbles(mesh.bubbles), m_mesh(mesh.triangles),
      m_elevations(elevations)
  {}

  /// whether the triangulation holds nothing but the domain
  static bool is_possible(const Cdt& cdt, const Reading& reading)
  {
    std::size_t known = reading.free.size() + reading.pinned.size() + reading.graph->corners().size();
    for (const auto& chain : reading.graph->chains())
      known += chain.splits.size();
    return known == cdt.number_of_vertices() && !reading.graph->touches_other_constraints();
  }

  template <class Tags>
  void operator()(const Tags& tags)
  {
    m_cdt.tds().faces().clear();
    make_vertices();
    make_triangles();
    surround_hull();
    tags.write([this](const auto& visit) { this->for_each_piece(visit); });
  }

private:
  /// a vertex or a triangle has come
  void tell_progress() { tick(m_done++, m_bubbles.size() + m_mesh.number_of_triangles()); }

  void make_vertices()
  {
    for (Index v : m_reading.free)
      m_cdt.tds().delete_vertex(m_reading.vertex(v));
    for (const auto& chain : m_reading.graph->chains())
      for (Index v : chain.splits)
        m_cdt.tds().delete_vertex(m_reading.vertex(v));
    m_vertices.reserve(m_bubbles.size());
    for (std::size_t i = 0; i < m_bubbles.size(); ++i) {
      tell_progress();
      Vertex_handle v;
      if (m_bubbles.is_corner(i)) {
        v = vertex_of_corner(m_reading, m_bubbles, i);
      } else {
        v = m_cdt.tds().create_vertex();
        v->set_point(point_of_vertex<Cdt>(m_reading, m_bubbles, m_elevations, i));
      }
      m_vertices.push_back(&*v);
    }
  }

  void make_triangles()
  {
    const Marked_triangles_2& tr = m_mesh;
    m_faces.reserve(tr.number_of_triangles());
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      tell_progress();
      const auto& v = tr.vertices[t];
      const Face_handle f = m_cdt.tds().create_face(vertex(v[0]), vertex(v[1]), vertex(v[2]));
      m_faces.push_back(&*f);
      for (int i = 0; i < 3; ++i) {
        vertex(v[i])->set_face(f);
        f->set_constraint(i, m_mesh.edges[t][i] != no_index);
        const Index n = tr.neighbors[t][i];
        if (n != no_index && static_cast<std::size_t>(n) < t)
          m_cdt.tds().set_adjacency(f, i, face(m_faces[n]), tr.index_of_neighbor(n, static_cast<Index>(t)));
      }
      mark(f, m_mesh.inside[t] != 0);
    }
  }

  /// the infinite faces, one beyond each side of the hull
  void surround_hull()
  {
    const Marked_triangles_2& tr = m_mesh;
    const Vertex_handle infinite = m_cdt.infinite_vertex();
    std::vector<void*> hull, ending_at; // hull sides run clockwise, seen from outside
    resize_in_turn(ending_at, m_bubbles.size());
    std::vector<Index> sources;
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      tick(t);
      for (int i = 0; i < 3; ++i) {
        if (tr.neighbors[t][i] != no_index)
          continue;
        const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
        const Face_handle f = m_cdt.tds().create_face(vertex(b), vertex(a), infinite);
        f->set_constraints(false, false, m_mesh.edges[t][i] != no_index);
        m_cdt.tds().set_adjacency(face(m_faces[t]), i, f, 2);
        mark(f, false);
        hull.push_back(&*f);
        sources.push_back(a);
        ending_at[b] = &*f;
      }
    }
    for (std::size_t k = 0; k < hull.size(); ++k)
      m_cdt.tds().set_adjacency(face(hull[k]), 0, face(ending_at[sources[k]]), 1);
    infinite->set_face(face(hull.front()));
  }

  /// what `Tags_2::write()` wants to know
  template <class Visit>
  void for_each_piece(const Visit& visit) const
  {
    internal::for_each_piece(m_reading.domain, m_bubble_mesh, [&](Index t, int i, Index e, bool is_left) {
      if (m_mesh.neighbors[t][i] > t)
        return; // is seen from the other side
      const Index source = m_mesh.vertices[t][is_left ? ccw(i) : cw(i)];
      visit(typename Cdt::Edge(face(m_faces[t]), i), vertex(source), static_cast<std::size_t>(e));
    });
  }

  Vertex_handle vertex(Index bubble) const { return Handles<Cdt>::vertex(m_vertices[bubble]); }

  static Face_handle face(void* address) { return Handles<Cdt>::face(address); }

  static void mark([[maybe_unused]] Face_handle f, [[maybe_unused]] bool inside)
  {
    if constexpr (Domain_marks_2<Cdt>::has_marks)
      f->set_in_domain(inside);
  }

  Cdt& m_cdt;
  const Reading& m_reading;
  const Bubble_mesh_2& m_bubble_mesh;
  const Bubbles_2& m_bubbles;
  const Marked_triangles_2& m_mesh;
  const Elevations<Cdt>& m_elevations;
  std::size_t m_done = 0;        // vertices and triangles that have come
  std::vector<void*> m_vertices; // of the bubbles
  std::vector<void*> m_faces;    // of the triangles
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_DIRECT_WRITE_2_H
