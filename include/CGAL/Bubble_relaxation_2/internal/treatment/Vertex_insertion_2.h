// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Inserts vertices into a mesh that is a constrained Delaunay triangulation, and stays one in the domain: what lies
/// around them is found from the triangles that asked for them, and nothing else is looked at.
class Vertex_insertion_2
{
public:
  explicit Vertex_insertion_2(Bubble_mesh_2& mesh) : m_mesh(mesh), m_triangles(mesh) {}

  /// The first triangle for which `is_it(t)` holds, of those that hang together with `start` without an edge of the domain
  /// in between; the nearest come first.
  template <class Predicate>
  Index find(Index start, const Predicate& is_it) const
  {
    std::vector<Index> queue(1, start);
    std::unordered_set<Index> seen{start};
    for (std::size_t k = 0; k < queue.size(); ++k) {
      const Index t = queue[k];
      if (is_it(t))
        return t;
      for (int i = 0; i < 3; ++i) {
        const Index n = m_mesh.triangles.neighbors[t][i];
        if (n != no_index && m_mesh.triangles.edges[t][i] == no_index && seen.insert(n).second)
          queue.push_back(n);
      }
    }
    return no_index;
  }

  /// Inserts the bubble `v` of a face, searched from a triangle; returns whether coordinates can tell it from what there was.
  bool in_face(Index v, Index start)
  {
    const Point p = m_mesh.bubbles.point(v);
    const auto has_on = [&](Index t, int i) {
      return CGAL::orientation(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i)), p) == COLLINEAR;
    };
    const Index t = find(start, [&](Index u) { return contains(u, p); });
    if (t == no_index)
      return false;
    for (int i = 0; i < 3; ++i)
      if (has_on(t, i)) {
        if (m_mesh.triangles.edges[t][i] != no_index || m_mesh.triangles.neighbors[t][i] == no_index ||
            has_on(t, ccw(i)) || has_on(t, cw(i)))
          return false; // on an edge of the domain, where the mesh ends, or on a vertex
        m_triangles.insert_on_side(v, t, i);
        return true;
      }
    m_triangles.insert_in_triangle(v, t);
    return true;
  }

  /// the same for a bubble on a side of a triangle, but for rounding
  bool on_side(Index v, Index t, int i)
  {
    const Index n = m_mesh.triangles.neighbors[t][i];
    if (!can_be_split(v, t, i) ||
        (n != no_index && m_triangles.is_inside(n) && !can_be_split(v, n, m_mesh.triangles.index_of_neighbor(n, t))))
      return false;
    m_triangles.insert_on_side(v, t, i);
    return true;
  }

private:
  bool contains(Index t, const Point& p) const
  {
    for (int i = 0; i < 3; ++i)
      if (CGAL::orientation(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i)), p) == RIGHT_TURN)
        return false;
    return true;
  }

  /// whether both parts of a triangle, split at a vertex on side `i`, are counterclockwise
  bool can_be_split(Index v, Index t, int i) const
  {
    const Point p = m_mesh.bubbles.point(v), a = m_mesh.point(t, i);
    return CGAL::orientation(a, m_mesh.point(t, ccw(i)), p) == LEFT_TURN &&
           CGAL::orientation(a, p, m_mesh.point(t, cw(i))) == LEFT_TURN;
  }

  Bubble_mesh_2& m_mesh;
  Editable_triangulation_2 m_triangles; // of it
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H
