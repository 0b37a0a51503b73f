// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARK_TRIANGULATION_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARK_TRIANGULATION_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Makes triangles of points and of edges between them: triangulates, copies to arrays,
/// enters the edges, and floods the marks of their sides.
class Marking_2
{
  using Vb = Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Fb = Triangulation_face_base_with_info_2<Index, Kernel,
               Constrained_triangulation_face_base_2<Kernel>>;
  using Tds = Triangulation_data_structure_2<Vb, Fb>;
  using Cdt = Constrained_Delaunay_triangulation_2<Kernel, Tds,
                No_constraint_intersection_requiring_constructions_tag>;
  using Vertex_handle = Cdt::Vertex_handle;
  using Face_handle = Cdt::Face_handle;

public:
  Marking_2(const std::vector<Point>& points, const std::vector<Domain_edge_2>& edges, Triangles_2& result,
            std::vector<std::array<Index, 3>>& sides)
    : m_points(points), m_edges(edges), m_result(result), m_sides(sides)
  {}

  Marking_error operator()()
  {
    const Marking_error error = triangulate();
    if (error != Marking_error::NONE)
      return error;
    copy_to_arrays();
    Index edge_index = 0;
    for (const auto& e : m_edges) {
      tick(static_cast<std::size_t>(edge_index));
      const Marking_error edge_error = enter_edge(e, edge_index++);
      if (edge_error != Marking_error::NONE)
        return edge_error;
    }
    flood();
    return m_marks_differ ? Marking_error::MARKS_DIFFER : Marking_error::NONE;
  }

private:
  Marking_error triangulate()
  {
    m_handles.reserve(m_points.size());
    Face_handle near; // of the point before
    for (const Point& p : m_points) {
      const Vertex_handle v = m_cdt.insert(p, near);
      if (m_cdt.number_of_vertices() == m_handles.size())
        return Marking_error::POINTS_COINCIDE;
      v->info() = static_cast<Index>(m_handles.size());
      m_handles.push_back(v);
      near = v->face();
      tick(m_handles.size());
    }
    try {
      for (std::size_t k = 0; k < m_edges.size(); ++k) {
        tick(k);
        m_cdt.insert_constraint(m_handles[m_edges[k].source], m_handles[m_edges[k].target]);
      }
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      return Marking_error::EDGES_CROSS;
    }
    // all points of a needle may lie on a line when its edges are straightened
    return m_cdt.dimension() < 2 ? Marking_error::NO_TRIANGLE : Marking_error::NONE;
  }

  void copy_to_arrays()
  {
    const std::size_t n = m_cdt.number_of_faces();
    resize_in_turn(m_result.vertices, n);
    resize_in_turn(m_result.neighbors, n);
    assign_in_turn(m_sides, n, {no_index, no_index, no_index});
    assign_in_turn(m_result.inside, n, char(0));
    assign_in_turn(m_seen, n, char(0));
    number_along_points();
    for (Face_handle f : m_cdt.finite_face_handles()) {
      for (int i = 0; i < 3; ++i) {
        m_result.vertices[f->info()][i] = f->vertex(i)->info();
        m_result.neighbors[f->info()][i] = f->neighbor(i)->info();
      }
      tick(static_cast<std::size_t>(f->info()));
    }
  }

  /// Numbers the finite faces in the order of the points that they are around: what is near in space is near in memory, and
  /// numbers depend on nothing else.
  void number_along_points()
  {
    for (Face_handle f : m_cdt.all_face_handles())
      f->info() = no_index;
    m_cdt.infinite_vertex()->info() = no_index;
    Index number = 0;
    for (Vertex_handle v : m_handles) {
      tick(static_cast<std::size_t>(number));
      auto f = m_cdt.incident_faces(v, first_face(v)), first = f;
      do
        if (f->info() == no_index && !m_cdt.is_infinite(f))
          f->info() = number++;
      while (++f != first);
    }
  }

  /// of those around a vertex the one that begins at the first point
  Face_handle first_face(Vertex_handle v) const
  {
    const auto begin = [this, v](Face_handle f) { return f->vertex(m_cdt.ccw(f->index(v)))->info(); };
    auto f = m_cdt.incident_faces(v), end = f;
    Face_handle first = f;
    while (++f != end)
      if (begin(f) < begin(first))
        first = f;
    return first;
  }

  Marking_error enter_edge(const Domain_edge_2& e, Index edge_index)
  {
    Face_handle f;
    int i;
    // an edge that passes through a third point is there in parts only
    if (!m_cdt.is_edge(m_handles[e.source], m_handles[e.target], f, i))
      return Marking_error::EDGE_THROUGH_POINT;
    // two edges with the same ends have different marks, and a bubble could not tell which it is on
    const Index g = f->neighbor(i)->info();
    const int j = m_cdt.mirror_index(f, i);
    if (has_edge(f->info(), i) || has_edge(g, j))
      return Marking_error::EDGE_TWICE;
    const bool f_is_left = f->vertex(m_cdt.ccw(i)) == m_handles[e.source];
    enter_side(f->info(), i, edge_index, f_is_left ? e.inside_left : e.inside_right);
    enter_side(g, j, edge_index, f_is_left ? e.inside_right : e.inside_left);
    return Marking_error::NONE;
  }

  bool has_edge(Index t, int i) const
  {
    return t != no_index && m_sides[t][i] != no_index;
  }

  void enter_side(Index t, int i, Index edge_index, bool inside)
  {
    if (t != no_index)
      m_sides[t][i] = edge_index;
    mark(t, inside);
  }

  void mark(Index t, bool inside)
  {
    if (t == no_index || m_seen[t]) { // edges a rounding apart may have changed their order
      m_marks_differ |= inside != (t != no_index && m_result.inside[t] != 0);
      return;
    }
    m_seen[t] = 1;
    m_result.inside[t] = inside;
    m_stack.push_back(t);
  }

  void flood()
  {
    std::size_t number = 0;
    while (!m_stack.empty()) {
      tick(number++);
      const Index t = m_stack.back();
      m_stack.pop_back();
      for (int i = 0; i < 3; ++i)
        if (m_sides[t][i] == no_index)
          mark(m_result.neighbors[t][i], m_result.inside[t] != 0);
    }
  }

  const std::vector<Point>& m_points;
  const std::vector<Domain_edge_2>& m_edges;
  Triangles_2& m_result;
  std::vector<std::array<Index, 3>>& m_sides; // of the triangles: the edges behind them
  Cdt m_cdt;
  std::vector<Vertex_handle> m_handles; // by index of the point
  bool m_marks_differ = false;          // two edges say another of a triangle
  std::vector<char> m_seen;             // triangles that have their mark
  std::vector<Index> m_stack;           // triangles whose neighbours are to be marked
};

CGAL_BUBBLE_RELAXATION_2_INLINE
Marking_error mark_triangulation(const std::vector<Point>& points, const std::vector<Domain_edge_2>& edges,
                                 Triangles_2& result, std::vector<std::array<Index, 3>>& sides)
{
  return Marking_2(points, edges, result, sides)();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARK_TRIANGULATION_IMPL_H
