// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_REBUILD_OUTSIDE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_REBUILD_OUTSIDE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// whether a bubble lies on an edge of the domain, or at an end of one
inline bool is_on_outline(const Bubbles_2& b, std::size_t i)
{
  return b.is_on_edge(i) || (b.is_corner(i) && b.host[i] != no_index);
}

/// The vertices that a mesh may have outside of the domain: those on its outline, and others that none of the domain's
/// triangles has. Pieces of the outline end at rounded places, and may leave a bubble beside them outside.
inline std::vector<Index> vertices_outside(const Bubble_mesh_2& mesh)
{
  std::vector<char> marks = vertices_of_triangles(mesh.triangles, true, mesh.bubbles.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    tick(i);
    marks[i] = !mesh.bubbles.is_gone(i) && (!marks[i] || is_on_outline(mesh.bubbles, i));
  }
  return marked(marks);
}

/// Triangulates what lies outside of a domain, whose vertices are numbered as the bubbles are; returns whether that can be
/// made, and each vertex beside the outline is outside. `vertices`: what `vertices_outside()` found
inline bool triangulate_outside(const Domain_2& domain, const Bubbles_2& b, const std::vector<Index>& vertices,
                                Marked_triangles_2& outside)
{
  std::vector<Index> number(b.size(), no_index);
  std::vector<Point> points;
  for (Index v : vertices) {
    number[v] = static_cast<Index>(points.size());
    points.push_back(b.point(static_cast<std::size_t>(v)));
  }
  std::vector<Domain_edge_2> edges = cut_edges(domain, b);
  for (Domain_edge_2& e : edges) {
    e.source = number[e.source];
    e.target = number[e.target];
  }
  if (mark_triangulation(points, edges, outside) != Marking_error::NONE)
    return false;
  keep_triangles(outside, [&outside](std::size_t t) { return outside.inside[t] == 0; });
  for (auto& triangle : outside.vertices)
    for (Index& v : triangle)
      v = vertices[v];
  const std::vector<char> is_outside = vertices_of_triangles(outside, false, b.size());
  return std::all_of(vertices.begin(), vertices.end(), [&](Index v) {
    return is_outside[v] || is_on_outline(b, static_cast<std::size_t>(v));
  });
}

/// Makes triangles neighbours that have the same constrained side and do not know of each other.
inline void link_across_edges(Marked_triangles_2& m)
{
  std::map<std::pair<Index, Index>, std::pair<Index, int>> sides; // from vertex to vertex
  for (std::size_t t = 0; t < m.inside.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto& v = m.vertices[t];
      if (m.edges[t][i] == no_index || m.neighbors[t][i] != no_index)
        continue;
      const auto other = sides.find({v[cw(i)], v[ccw(i)]});
      if (other == sides.end()) {
        sides[{v[ccw(i)], v[cw(i)]}] = {static_cast<Index>(t), i};
        continue;
      }
      m.neighbors[t][i] = other->second.first;
      m.neighbors[other->second.first][other->second.second] = static_cast<Index>(t);
    }
}

/// Makes the triangles outside of the domain anew. They depend on its outline only, since nothing sees through
/// the edges; so they need not be looked at while vertices move, which they would forbid where roundings alone
/// make a bend of a slanted edge. Returns whether they could be made; if not, the mesh is as it was.
inline bool rebuild_outside(const Domain_2& domain, Bubble_mesh_2& mesh)
{
  Marked_triangles_2 outside;
  if (!triangulate_outside(domain, mesh.bubbles, vertices_outside(mesh), outside))
    return false;
  Marked_triangles_2& m = mesh.triangles;
  keep_triangles(m, [&m](std::size_t t) { return m.inside[t] != 0; });
  const Index first = static_cast<Index>(m.number_of_triangles());
  for (auto& neighbors : outside.neighbors)
    for (Index& n : neighbors)
      n = n == no_index ? no_index : first + n;
  m.vertices.insert(m.vertices.end(), outside.vertices.begin(), outside.vertices.end());
  m.neighbors.insert(m.neighbors.end(), outside.neighbors.begin(), outside.neighbors.end());
  m.edges.insert(m.edges.end(), outside.edges.begin(), outside.edges.end());
  m.inside.insert(m.inside.end(), outside.inside.begin(), outside.inside.end());
  link_across_edges(m);
  return true;
}

/// Parts of the outline can be as near to each other as the rounding of what is on it, and cross. That is seen when the
/// triangles outside of the domain are made, which takes long: so it is looked at when all of a treatment is done, and if
/// they do, all is done once more, carefully, which is after each part.
struct Outline_care
{
  bool is_careful;
  bool has_changed_outline = false; ///< and nobody has looked whether it crosses itself

  /// Whether a part of the treatment may stay, as far as the outline is concerned. `closes()`: whether it does not cross
  /// itself then
  template <class Closes>
  bool allows(bool changes_outline, const Closes& closes)
  {
    if (is_careful)
      return !changes_outline || closes();
    has_changed_outline = has_changed_outline || changes_outline;
    return true;
  }

  /// what was done with another one is part of this
  void add(const Outline_care& other) { has_changed_outline = has_changed_outline || other.has_changed_outline; }
};

/// Ranks see on the way that the outline crosses itself: one rank does before it goes back to another mesh.
/// \throws Edges_too_near
template <class Treatment>
void check_before_leaving(const Treatment& treatment, typename Treatment::Mesh& mesh, const Outline_care& care)
{
  if (care.has_changed_outline && !treatment.closes_outline(mesh))
    throw Edges_too_near(treatment.problem().domain);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_REBUILD_OUTSIDE_H
