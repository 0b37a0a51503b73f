// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_REMOVAL_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_REMOVAL_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Takes a vertex out of a mesh that is a constrained Delaunay triangulation, and stays one: the polygons around it are
/// triangulated by cutting ears off, then edges are flipped.
class Vertex_removal_2
{
public:
  /// \param v no corner \pre there are no triangles outside of the domain, and the edges of `mesh` are labelled
  Vertex_removal_2(const Bubble_mesh_2& mesh, Index v)
    : m_bubbles(mesh.bubbles), m_triangles(mesh.triangles), m_vertex(v)
  {
    for (std::size_t t = 0; t < m_triangles.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i)
        if (m_triangles.vertices[t][i] == v)
          m_corners.push_back(Corner_2{static_cast<Index>(t), i});
  }

  std::size_t number_of_triangles() const { return m_corners.size(); }

  /// whether the domain ends beside the vertex
  bool is_on_outline() const
  {
    return std::any_of(m_corners.begin(), m_corners.end(), [this](const Corner_2& c) {
      return edge(c, ccw(c.index)) == OUTLINE || edge(c, cw(c.index)) == OUTLINE;
    });
  }

  /// Changes a copy of the mesh, whose bubbles get numbers without a gap; returns whether that can be done.
  bool operator()(Bubble_mesh_2& mesh) const
  {
    std::vector<Index> old;
    std::vector<New_triangle_2> made;
    bool has_begun = false;
    for (const Corner_2& c : m_corners) {
      old.push_back(c.triangle);
      if (edge(c, cw(c.index)) == no_index)
        continue;
      has_begun = true;
      if (!cut_ears(polygon_from(c), made))
        return false;
    }
    if (!has_begun && (m_corners.empty() || !cut_ears(polygon_from(m_corners.front()), made))) // in a face
      return false;
    mesh.bubbles.remove(m_vertex);
    Mesh_stitching_2 stitching(mesh);
    stitching.replace(old, made);
    stitching.finish();
    return true;
  }

private:
  /// of a polygon, which is on its left
  struct Side
  {
    Index source, target, edge;
  };

  Index edge(const Corner_2& c, int i) const { return m_triangles.edges[c.triangle][i]; }
  Index source(const Corner_2& c) const { return m_triangles.vertices[c.triangle][ccw(c.index)]; }
  Index target(const Corner_2& c) const { return m_triangles.vertices[c.triangle][cw(c.index)]; }

  /// From one corner on counterclockwise: all around, or to the edge of the domain that the vertex is on, which closes the
  /// polygon in one piece.
  std::vector<Side> polygon_from(const Corner_2& first) const
  {
    std::vector<Side> polygon;
    for (const Corner_2* c = &first;;) {
      polygon.push_back(Side{source(*c), target(*c), edge(*c, c->index)});
      if (const Index piece = edge(*c, ccw(c->index)); piece != no_index) {
        polygon.push_back(Side{target(*c), source(first), piece});
        return polygon;
      }
      const auto next = std::find_if(m_corners.begin(), m_corners.end(),
                                     [this, c](const Corner_2& other) { return source(other) == target(*c); });
      if (next == m_corners.end())
        return {}; // some are missing
      c = &*next;
      if (c == &first)
        return polygon;
    }
  }

  bool cut_ears(std::vector<Side> polygon, std::vector<New_triangle_2>& made) const
  {
    while (polygon.size() > 3) {
      std::size_t k = 0;
      while (k < polygon.size() && !is_ear(polygon, k))
        ++k;
      if (k == polygon.size())
        return false;
      const std::size_t next = (k + 1) % polygon.size();
      const Side first = polygon[k], second = polygon[next];
      made.push_back({{first.source, first.target, second.target}, {second.edge, no_index, first.edge}});
      polygon[k] = Side{first.source, second.target, no_index};
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(next));
    }
    if (polygon.size() < 3 || !is_ear(polygon, 0))
      return false;
    made.push_back({{polygon[0].source, polygon[1].source, polygon[2].source},
                    {polygon[1].edge, polygon[2].edge, polygon[0].edge}});
    return true;
  }

  /// whether a side and the next one make a triangle in the polygon
  bool is_ear(const std::vector<Side>& polygon, std::size_t k) const
  {
    const Index u = polygon[k].source, v = polygon[k].target, w = polygon[(k + 1) % polygon.size()].target;
    if (CGAL::orientation(m_bubbles.point(u), m_bubbles.point(v), m_bubbles.point(w)) != LEFT_TURN)
      return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](const Side& s) {
      const Point p = m_bubbles.point(s.source);
      const auto is_right_of = [&](Index from, Index to) {
        return CGAL::orientation(m_bubbles.point(from), m_bubbles.point(to), p) == RIGHT_TURN;
      };
      return s.source != u && s.source != v && s.source != w && !is_right_of(u, v) && !is_right_of(v, w) &&
             !is_right_of(w, u);
    });
  }

  const Bubbles_2& m_bubbles;
  const Marked_triangles_2& m_triangles;
  const Index m_vertex;
  std::vector<Corner_2> m_corners; // of the vertex
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_REMOVAL_2_H
