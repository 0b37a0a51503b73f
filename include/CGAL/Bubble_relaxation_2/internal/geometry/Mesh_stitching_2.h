// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MESH_STITCHING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MESH_STITCHING_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A triangle that is to be put into a mesh, and what the mesh shall have in `edges` for its sides.
struct New_triangle_2
{
  std::array<Index, 3> vertices, edges;
};

/// Puts other triangles in the place of some of the domain, with vertices that may be new, and flips edges until
/// the domain has its constrained Delaunay triangulation again. What lies elsewhere is not looked at, but where numbers
/// change. Where the outline is another one, the triangles have no neighbours outside.
class Mesh_stitching_2
{
public:
  explicit Mesh_stitching_2(Bubble_mesh_2& mesh)
    : m_mesh(mesh), m_triangles(mesh.triangles), m_is_gone(mesh.triangles.inside.size(), 0)
  {}

  /// replaces the triangles `old` by `made`, as long as `finish()` was not called
  void replace(const std::vector<Index>& old, const std::vector<New_triangle_2>& made)
  {
    for (Index t : old)
      m_is_gone[t] = 1;
    for (Index t : old)
      cut_out(t);
    std::vector<Side> sides;
    for (std::size_t k = 0; k < made.size(); ++k) {
      const Index t = k < old.size() ? old[k] : append();
      put(made[k], t);
      for (int i = 0; i < 3; ++i)
        sides.push_back(side(t, i));
    }
    std::sort(m_rim.begin(), m_rim.end());
    std::sort(sides.begin(), sides.end());
    for (const Side& s : sides)
      link(s, sides);
    m_rim.clear();
  }

  /// Forgets the bubbles that are gone, which no triangle has any more. Returns the mesh, for more changes.
  Editable_triangulation_2 finish()
  {
    forget_vertices(m_mesh.bubbles.indices_left());
    m_mesh.bubbles.forget_gone();
    const std::vector<Index> new_index = keep_triangles(m_triangles, [this](std::size_t t) { return !m_is_gone[t]; });
    for (Index& t : m_made)
      t = new_index[t];
    Editable_triangulation_2 mesh(m_mesh);
    for (Index t : m_made)
      mesh.restore_delaunay_around(t);
    return mesh;
  }

  /// the triangles that were put in, as they are numbered when the mesh is finished
  const std::vector<Index>& made() const { return m_made; }

private:
  /// a side from one vertex to another, seen from the triangle on its left
  struct Side
  {
    Index source, target, triangle;
    int index;

    bool operator<(const Side& s) const
    {
      return std::make_pair(source, target) < std::make_pair(s.source, s.target);
    }
  };

  Side side(Index t, int i) const
  {
    const std::array<Index, 3>& v = m_triangles.vertices[t];
    return Side{v[ccw(i)], v[cw(i)], t, i};
  }

  void cut_out(Index t)
  {
    for (int i = 0; i < 3; ++i) {
      const Index n = m_triangles.neighbors[t][i];
      if (n == no_index || m_is_gone[n])
        continue;
      const Side s = side(t, i);
      const int j = m_triangles.index_of_side(n, s.source, s.target);
      m_rim.push_back(Side{s.source, s.target, n, j});
      m_triangles.neighbors[n][j] = no_index;
    }
  }

  Index append()
  {
    m_is_gone.push_back(0);
    return append_triangle(m_triangles);
  }

  void put(const New_triangle_2& triangle, Index t)
  {
    m_triangles.vertices[t] = triangle.vertices;
    m_triangles.neighbors[t] = {no_index, no_index, no_index};
    m_triangles.edges[t] = triangle.edges;
    m_is_gone[t] = 0;
    m_made.push_back(t);
  }

  /// `nullptr` if there is none
  static const Side* find(const std::vector<Side>& sides, Index source, Index target)
  {
    const auto s = std::lower_bound(sides.begin(), sides.end(), Side{source, target, no_index, 0});
    return s != sides.end() && s->source == source && s->target == target ? &*s : nullptr;
  }

  void link(const Side& s, const std::vector<Side>& sides)
  {
    Index& neighbor = m_triangles.neighbors[s.triangle][s.index];
    if (const Side* twin = find(sides, s.target, s.source))
      neighbor = twin->triangle;
    else if (const Side* rim = find(m_rim, s.source, s.target)) {
      neighbor = rim->triangle;
      m_triangles.neighbors[rim->triangle][rim->index] = s.triangle;
    }
  }

  void forget_vertices(const std::vector<Index>& number)
  {
    for (std::size_t t = 0; t < m_is_gone.size(); ++t) {
      if (m_is_gone[t])
        continue;
      for (Index& v : m_triangles.vertices[t]) {
        v = number[v];
        if (v == no_index) // of the old outline: a triangle outside, which is to be made anew
          m_is_gone[t] = 1;
      }
    }
  }

  Bubble_mesh_2& m_mesh;
  Marked_triangles_2& m_triangles; // of it
  std::vector<char> m_is_gone; // of each triangle
  std::vector<Side> m_rim;     // of what is replaced now, each with the triangle beyond
  std::vector<Index> m_made;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MESH_STITCHING_2_H
