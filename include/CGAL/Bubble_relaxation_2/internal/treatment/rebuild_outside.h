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
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Makes the triangulation of the bubbles on the outline of a domain, and of others that are in none of its triangles:
/// pieces of the outline end at rounded places, so one beside them may have come to lie outside. Vertices are numbered as
/// the bubbles are. Returns whether it can be made.
inline bool triangulate_outline(const Domain_2& domain, const Bubbles_2& b, const std::vector<char>& is_in_domain,
                                Marked_triangles_2& outline)
{
  std::vector<Index> number(b.size(), no_index), vertices;
  std::vector<Point> points;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_on_edge(i) || (b.is_corner(i) && b.host[i] != no_index) || !is_in_domain[i]) {
      number[i] = static_cast<Index>(points.size());
      points.push_back(b.point(i));
      vertices.push_back(static_cast<Index>(i));
    }
  std::vector<Domain_edge_2> edges = cut_edges(domain, b);
  for (Domain_edge_2& e : edges) {
    e.source = number[e.source];
    e.target = number[e.target];
  }
  if (mark_triangulation(points, edges, outline) != Marking_error::NONE)
    return false;
  for (auto& triangle : outline.vertices)
    for (Index& v : triangle)
      v = vertices[v];
  return true;
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
  Marked_triangles_2 &m = mesh.triangles, outside;
  const std::vector<char> is_in_domain = vertices_of_triangles(m, true, mesh.bubbles.size());
  if (!triangulate_outline(domain, mesh.bubbles, is_in_domain, outside))
    return false;
  const std::vector<char> is_outside = vertices_of_triangles(outside, false, mesh.bubbles.size());
  for (std::size_t i = 0; i < is_in_domain.size(); ++i)
    if (!is_in_domain[i] && !is_outside[i])
      return false; // what was outside would have to come back in
  keep_triangles(m, [&m](std::size_t t) { return m.inside[t] != 0; });
  keep_triangles(outside, [&outside](std::size_t t) { return outside.inside[t] == 0; });
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
    throw Edges_too_near();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_REBUILD_OUTSIDE_H
