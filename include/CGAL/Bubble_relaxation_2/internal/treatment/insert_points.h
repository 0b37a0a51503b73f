// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_INSERT_POINTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_INSERT_POINTS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Angle_refinement_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Vertex_insertion_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the side of a triangle that is the piece of an edge of the domain that is to be split; 3 if none is
inline int side_on_edge(const Domain_2& domain, const Bubble_mesh_2& mesh, Index t, const Steiner_point_2& p)
{
  for (int i = 0; i < 3; ++i) {
    const Index u = mesh.triangles.vertices[t][ccw(i)], w = mesh.triangles.vertices[t][cw(i)];
    if (mesh.triangles.edges[t][i] == no_index || edge_of_piece(domain, mesh.bubbles, u, w) != p.host)
      continue;
    const double s = position_on(domain, mesh.bubbles, p.host, u),
                 r = position_on(domain, mesh.bubbles, p.host, w);
    if ((std::min)(s, r) < p.s && p.s < (std::max)(s, r))
      return i;
  }
  return 3;
}

/// Inserts the bubble `v` that was added for a point; returns whether that can be done.
inline bool insert_point(const Domain_2& domain, const Bubble_mesh_2& mesh, const Steiner_point_2& p, Index v,
                         Vertex_insertion_2& insertion)
{
  if (!p.is_on_edge())
    return insertion.in_face(v, p.triangle);
  const Index t = insertion.find(p.triangle, [&](Index u) { return side_on_edge(domain, mesh, u, p) < 3; });
  return t != no_index && insertion.on_side(v, t, side_on_edge(domain, mesh, t, p));
}

/// Inserts vertices into a mesh; returns whether that can be done, and none on an edge is so near to others that it would
/// be removed, see `remove_confusing_on_edges()`. If not, the mesh is not to be used any more. If there are some on edges,
/// the triangles outside of the domain are still to be made.
inline bool insert_points(const Domain_2& domain, const Sizes_2& sizes, const std::vector<Steiner_point_2>& points,
                          Bubble_mesh_2& mesh)
{
  label_edges(mesh.triangles);
  Vertex_insertion_2 insertion(mesh);
  for (const Steiner_point_2& p : points) {
    const Index v = static_cast<Index>(mesh.bubbles.size());
    mesh.bubbles.add(Point(p.x, p.y), sizes(p.x, p.y), p.dimension, p.host, p.s);
    if (!insert_point(domain, mesh, p, v, insertion))
      return false;
  }
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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_INSERT_POINTS_H
