// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_OUTSIDE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_OUTSIDE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Makes the triangulation of the bubbles on the outline of a domain, whose vertices are numbered as the bubbles
/// are; returns whether it can be made.
inline bool triangulate_outline(const Domain_2& domain, const Bubbles_2& b, Marked_triangles_2& outline)
{
  std::vector<Index> number(b.size(), no_index), vertices;
  std::vector<Point> points;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_on_edge(i) || (b.is_corner(i) && b.host[i] != no_index)) {
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

/// Makes the triangles outside of the domain anew. They depend on its outline only, since nothing sees through
/// the edges; so they need not be looked at while vertices move, which they would forbid where roundings alone
/// make a bend of a slanted edge.
class Outside_2
{
public:
  Outside_2(const Domain_2& domain, Bubble_mesh_2& mesh)
    : m_domain(domain), m_bubbles(mesh.bubbles), m_mesh(mesh.triangles)
  {}

  /// returns whether it could be made; if not, the mesh is as it was
  bool rebuild()
  {
    if (!triangulate_outline(m_domain, m_bubbles, m_outline))
      return false;
    Marked_triangles_2 result;
    const std::vector<Index> inside = take(m_mesh, 1, result), outside = take(m_outline, 0, result);
    link(m_mesh, inside, result);
    link(m_outline, outside, result);
    link_across_edges(result);
    m_mesh = std::move(result);
    return true;
  }

private:
  /// adds the triangles of one mark; returns their new numbers
  static std::vector<Index> take(const Marked_triangles_2& from, char mark, Marked_triangles_2& result)
  {
    std::vector<Index> number(from.inside.size(), no_index);
    for (std::size_t t = 0; t < from.inside.size(); ++t)
      if ((from.inside[t] != 0) == (mark != 0)) {
        number[t] = static_cast<Index>(result.inside.size());
        result.vertices.push_back(from.vertices[t]);
        result.neighbors.push_back({no_index, no_index, no_index});
        result.edges.push_back(from.edges[t]);
        result.inside.push_back(mark);
      }
    return number;
  }

  /// neighbours with the same mark
  static void link(const Marked_triangles_2& from, const std::vector<Index>& number,
                   Marked_triangles_2& result)
  {
    for (std::size_t t = 0; t < number.size(); ++t)
      for (int i = 0; i < 3 && number[t] != no_index; ++i) {
        const Index n = from.neighbors[t][i];
        if (n != no_index)
          result.neighbors[number[t]][i] = number[n];
      }
  }

  /// neighbours across the edges of the domain, one of them outside
  static void link_across_edges(Marked_triangles_2& result)
  {
    std::map<std::pair<Index, Index>, std::pair<Index, int>> sides; // from vertex to vertex
    for (std::size_t t = 0; t < result.inside.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const auto& v = result.vertices[t];
        if (result.edges[t][i] == no_index || result.neighbors[t][i] != no_index)
          continue;
        const auto other = sides.find({v[cw(i)], v[ccw(i)]});
        if (other == sides.end()) {
          sides[{v[ccw(i)], v[cw(i)]}] = {static_cast<Index>(t), i};
          continue;
        }
        result.neighbors[t][i] = other->second.first;
        result.neighbors[other->second.first][other->second.second] = static_cast<Index>(t);
      }
  }

  const Domain_2& m_domain;
  const Bubbles_2& m_bubbles;
  Marked_triangles_2& m_mesh;
  Marked_triangles_2 m_outline;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_OUTSIDE_2_H
