// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_LOG_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_LOG_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What bubbles and triangles of a mesh were before they were changed, so that all changes can be undone. In a mesh that
/// is good almost everywhere few are changed, and this takes far less than a copy.
class Treatment_log_2
{
public:
  /// where a bubble was, for `note()`
  struct Vertex
  {
    Index bubble, place;
    double x, y, s;
  };

  /// where a bubble is
  static Vertex vertex(const Bubbles_2& b, Index v) { return Vertex{v, b.place[v], b.x[v], b.y[v], b.s[v]}; }

  /// a bubble was moved, or is going to be
  void note(const Vertex& before) { m_vertices.push_back(before); }

  /// a triangle, or what it knows of its neighbours, is going to be changed
  void note(const Marked_triangulation_2& mesh, Index t)
  {
    m_triangles.push_back(
      Triangle{t, mesh.inside[t] != 0, mesh.tr.vertices[t], mesh.tr.neighbors[t], mesh.edges[t]});
  }

  /// makes all what it was when the log was empty, and empties it
  void undo(Marked_triangulation_2& mesh, Bubbles_2& b)
  {
    for (auto v = m_vertices.rbegin(); v != m_vertices.rend(); ++v) {
      b.place[v->bubble] = v->place;
      b.x[v->bubble] = v->x;
      b.y[v->bubble] = v->y;
      b.s[v->bubble] = v->s;
      mesh.tr.points[v->bubble] = b.point(v->bubble);
    }
    for (auto t = m_triangles.rbegin(); t != m_triangles.rend(); ++t) {
      mesh.inside[t->triangle] = t->is_inside;
      mesh.tr.vertices[t->triangle] = t->vertices;
      mesh.tr.neighbors[t->triangle] = t->neighbors;
      mesh.edges[t->triangle] = t->edges;
    }
    m_vertices.clear();
    m_triangles.clear();
  }

private:
  struct Triangle
  {
    Index triangle;
    bool is_inside;
    std::array<Index, 3> vertices, neighbors, edges;
  };

  std::vector<Vertex> m_vertices;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_LOG_2_H
