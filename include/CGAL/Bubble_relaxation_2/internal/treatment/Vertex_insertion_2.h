// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Angle_refinement_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Inserts vertices into a mesh that is a constrained Delaunay triangulation, and stays one in the domain: what lies
/// around them is found from the triangles that asked for them, and nothing else is looked at.
class Vertex_insertion_2
{
public:
  Vertex_insertion_2(const Domain_2& domain, const Sizes_2& sizes, Bubble_mesh_2& mesh)
    : m_domain(domain), m_sizes(sizes), m_mesh(mesh), m_triangles(mesh)
  {}

  /// returns whether coordinates can tell the vertex from what there was
  bool operator()(const Steiner_point_2& p)
  {
    const Index v = static_cast<Index>(m_mesh.bubbles.size());
    m_mesh.bubbles.add(Point(p.x, p.y), m_sizes(p.x, p.y), p.dimension, p.host, p.s);
    return p.is_on_edge() ? insert_on_edge(v, p) : insert_in_face(v, p.triangle);
  }

private:
  bool insert_in_face(Index v, Index start)
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
        if (m_mesh.triangles.edges[t][i] != no_index || has_on(t, ccw(i)) || has_on(t, cw(i)))
          return false; // on an edge of the domain, or a vertex
        m_triangles.insert_on_side(v, t, i);
        return true;
      }
    m_triangles.insert_in_triangle(v, t);
    return true;
  }

  bool insert_on_edge(Index v, const Steiner_point_2& p)
  {
    const Index t = find(p.triangle, [&](Index u) { return side_on_edge(u, p) < 3; });
    if (t == no_index)
      return false;
    const int i = side_on_edge(t, p);
    const Index n = m_mesh.triangles.neighbors[t][i];
    if (!can_be_split(v, t, i) ||
        (n != no_index && m_triangles.is_inside(n) && !can_be_split(v, n, m_mesh.triangles.index_of_neighbor(n, t))))
      return false;
    m_triangles.insert_on_side(v, t, i);
    return true;
  }

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

  bool contains(Index t, const Point& p) const
  {
    for (int i = 0; i < 3; ++i)
      if (CGAL::orientation(m_mesh.point(t, ccw(i)), m_mesh.point(t, cw(i)), p) == RIGHT_TURN)
        return false;
    return true;
  }

  /// the side of a triangle that is the piece of an edge of the domain that is to be split; 3 if none is
  int side_on_edge(Index t, const Steiner_point_2& p) const
  {
    for (int i = 0; i < 3; ++i) {
      const Index u = m_mesh.triangles.vertices[t][ccw(i)], w = m_mesh.triangles.vertices[t][cw(i)];
      if (m_mesh.triangles.edges[t][i] == no_index || edge_of_piece(m_domain, m_mesh.bubbles, u, w) != p.host)
        continue;
      const double s = position_on(m_domain, m_mesh.bubbles, p.host, u),
                   r = position_on(m_domain, m_mesh.bubbles, p.host, w);
      if ((std::min)(s, r) < p.s && p.s < (std::max)(s, r))
        return i;
    }
    return 3;
  }

  /// whether both parts of a triangle, split at a vertex on side `i`, are counterclockwise
  bool can_be_split(Index v, Index t, int i) const
  {
    const Point p = m_mesh.bubbles.point(v), a = m_mesh.point(t, i);
    return CGAL::orientation(a, m_mesh.point(t, ccw(i)), p) == LEFT_TURN &&
           CGAL::orientation(a, p, m_mesh.point(t, cw(i))) == LEFT_TURN;
  }

  const Domain_2& m_domain;
  const Sizes_2& m_sizes;
  Bubble_mesh_2& m_mesh;
  Editable_triangulation_2 m_triangles; // of it
};

/// Inserts vertices into a mesh; returns whether that can be done, and none on an edge is so near to others that it would
/// be removed, see `remove_confusing_on_edges()`. If not, the mesh is not to be used any more. If there are some on edges,
/// the triangles outside of the domain are still to be made.
inline bool insert_points(const Domain_2& domain, const Sizes_2& sizes, const std::vector<Steiner_point_2>& points,
                          Bubble_mesh_2& mesh)
{
  label_edges(mesh.triangles);
  Vertex_insertion_2 insert(domain, sizes, mesh);
  if (!std::all_of(points.begin(), points.end(), [&insert](const Steiner_point_2& p) { return insert(p); }))
    return false;
  if (std::none_of(points.begin(), points.end(), [](const Steiner_point_2& p) { return p.is_on_edge(); }))
    return true;
  Bubbles_2 outline;
  for (std::size_t i = 0; i < mesh.bubbles.size(); ++i)
    if (!mesh.bubbles.is_in_face(i))
      outline.add(mesh.bubbles, i);
  remove_confusing_on_edges(domain, outline);
  return outline.left().size() == outline.size();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_INSERTION_2_H
