// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_MESH_PATCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_MESH_PATCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Those of the domain that can be reached from `triangle` in some steps across sides, sorted: the vertices that move
/// there are those up to about two edges away.
inline std::vector<Index> triangles_around(const Marked_triangles_2& m, Index triangle)
{
  constexpr int reach = 4;
  std::vector<Index> front(1, triangle), result = front;
  for (int step = 0; step < reach; ++step) {
    std::vector<Index> next;
    for (Index t : front)
      for (Index n : m.neighbors[t])
        if (n != no_index && m.inside[n] && !std::binary_search(result.begin(), result.end(), n))
          next.push_back(n);
    sort_each_once(next);
    const auto middle = result.insert(result.end(), next.begin(), next.end());
    std::inplace_merge(result.begin(), middle, result.end());
    front = std::move(next);
  }
  return result;
}

/// whether a mesh, whose edges are labelled, ends at some of its triangles where the domain does not
inline bool is_cut_off(const Marked_triangles_2& m, const std::vector<Index>& triangles)
{
  for (Index t : triangles)
    for (int i = 0; i < 3; ++i)
      if (m.neighbors[t][i] == no_index && m.edges[t][i] != OUTLINE)
        return true;
  return false;
}

/// The surroundings of a triangle as a mesh of their own, so that a change can be tried and forgotten. Bubbles with
/// triangles outside of the patch must stay; they look like corners. Beyond the patch there is nothing.
class Mesh_patch_2
{
public:
  /// `triangles`: what `triangles_around()` found
  Mesh_patch_2(const Bubble_mesh_2& mesh, std::vector<Index> triangles) : m_triangles(std::move(triangles))
  {
    const Marked_triangles_2& all = mesh.triangles;
    for (Index t : m_triangles)
      m_indices.insert(m_indices.end(), all.vertices[t].begin(), all.vertices[t].end());
    sort_each_once(m_indices);
    for (Index i : m_indices)
      m_mesh.bubbles.add(mesh.bubbles, i);
    for (Index t : m_triangles)
      add(all, t);
  }

  const std::vector<Index>& triangles() const { return m_triangles; } ///< of the whole mesh, sorted
  const std::vector<Index>& indices() const { return m_indices; }     ///< of the bubbles in the whole mesh, sorted
  const Bubble_mesh_2& mesh() const { return m_mesh; } ///< bubbles and triangles in the same order

  /// the number in the patch of a triangle of the whole mesh, `no_index` if it is not in it
  Index local_triangle(Index t) const { return index_among(m_triangles, t); }

  /// the same for what is the same, seen from a triangle of the patch
  std::uint64_t signature(Index triangle) const
  {
    const Bubbles_2& b = m_mesh.bubbles;
    std::uint64_t result = 0;
    const auto add = [&](std::size_t i) { result = hash_of_two(result, hash_of_place(b.x[i], b.y[i])); };
    for (std::size_t i = 0; i < b.size(); ++i)
      add(i);
    for (Index v : m_mesh.triangles.vertices[triangle])
      add(static_cast<std::size_t>(v));
    return result;
  }

private:
  void add(const Marked_triangles_2& all, Index t)
  {
    Marked_triangles_2& m = m_mesh.triangles;
    const Index k = append_triangle(m);
    m.edges[k] = all.edges[t];
    for (int i = 0; i < 3; ++i)
      m.vertices[k][i] = index_among(m_indices, all.vertices[t][i]);
    for (int i = 0; i < 3; ++i) {
      const Index n = all.neighbors[t][i];
      m.neighbors[k][i] = local_triangle(n);
      if (n != no_index && all.inside[n] && m.neighbors[k][i] == no_index) // the domain goes on there
        for (Index v : {m.vertices[k][ccw(i)], m.vertices[k][cw(i)]})
          m_mesh.bubbles.dimension[v] = Bubbles_2::CORNER;
    }
  }

  std::vector<Index> m_triangles, m_indices;
  Bubble_mesh_2 m_mesh;
};

/// What an operation made of a patch.
struct Patch_outcome_2
{
  Bubble_mesh_2 mesh;
  std::vector<Index> original; ///< of each bubble its number in the patch; inserted ones come after the last
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_MESH_PATCH_2_H
