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

#include <boost/container/flat_map.hpp>

#include <algorithm>
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
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
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

/// The surroundings of a triangle as bubbles and edges of their own, so that a change can be tried and
/// forgotten. Bubbles with triangles outside of the patch must stay; they look like corners.
class Mesh_patch_2
{
public:
  /// `triangles`: what `triangles_around()` found
  Mesh_patch_2(const Bubble_mesh_2& mesh, std::vector<Index> triangles)
    : m_all_bubbles(mesh.bubbles), m_triangles_of_mesh(mesh.triangles), m_triangles(std::move(triangles))
  {
    collect_bubbles();
    collect_edges();
  }

  const std::vector<Index>& triangles() const { return m_triangles; } ///< of the mesh, sorted
  const std::vector<Index>& indices() const { return m_indices; }     ///< of the bubbles in the mesh, sorted
  const Bubbles_2& bubbles() const { return m_bubbles; }
  const std::vector<Domain_edge_2>& edges() const { return m_edges; } ///< between bubbles of the patch

  /// what the mesh has in `edges` for a side where it goes on beyond the patch, between two bubbles of the patch;
  /// `other` for all other sides
  Index edge_on_rim(Index source, Index target, Index other) const
  {
    const auto side = m_rim.find({source, target});
    return side == m_rim.end() ? other : side->second;
  }

  /// the number in the patch of a bubble of the mesh that is in it
  Index local(Index i) const
  {
    return static_cast<Index>(std::lower_bound(m_indices.begin(), m_indices.end(), i) -
                              m_indices.begin());
  }

  /// the same for what is the same, seen from a triangle of the patch
  std::uint64_t signature(Index triangle) const
  {
    std::uint64_t result = 0;
    const auto add = [&result](const Bubbles_2& b, std::size_t i) {
      result = hash_of_two(result, hash_of_place(b.x[i], b.y[i]));
    };
    for (std::size_t i = 0; i < m_bubbles.size(); ++i)
      add(m_bubbles, i);
    for (Index v : m_triangles_of_mesh.vertices[triangle])
      add(m_all_bubbles, static_cast<std::size_t>(v));
    return result;
  }

private:
  bool contains(Index t) const
  {
    return t != no_index && std::binary_search(m_triangles.begin(), m_triangles.end(), t);
  }

  void collect_bubbles()
  {
    const Marked_triangles_2& m = m_triangles_of_mesh;
    for (Index t : m_triangles)
      m_indices.insert(m_indices.end(), m.vertices[t].begin(), m.vertices[t].end());
    std::sort(m_indices.begin(), m_indices.end());
    m_indices.erase(std::unique(m_indices.begin(), m_indices.end()), m_indices.end());
    for (Index i : m_indices)
      m_bubbles.add(m_all_bubbles, i);
    // on the rim: where the domain goes on
    for (Index t : m_triangles)
      for (int i = 0; i < 3; ++i) {
        const Index n = m.neighbors[t][i];
        if (n == no_index || !m.inside[n] || contains(n))
          continue;
        const Index source = local(m.vertices[t][ccw(i)]), target = local(m.vertices[t][cw(i)]);
        m_rim[{source, target}] = m.edges[t][i];
        m_bubbles.dimension[source] = m_bubbles.dimension[target] = Bubbles_2::CORNER;
      }
  }

  /// the rim and the constraints inside
  void collect_edges()
  {
    const Marked_triangles_2& m = m_triangles_of_mesh;
    for (Index t : m_triangles)
      for (int i = 0; i < 3; ++i) {
        const Index n = m.neighbors[t][i];
        const bool goes_on = contains(n);
        if (goes_on && (m.edges[t][i] == no_index || n < t))
          continue;
        m_edges.push_back(Domain_edge_2{local(m.vertices[t][ccw(i)]), local(m.vertices[t][cw(i)]),
                                        true, goes_on});
      }
  }

  const Bubbles_2& m_all_bubbles;
  const Marked_triangles_2& m_triangles_of_mesh;
  std::vector<Index> m_triangles, m_indices;
  Bubbles_2 m_bubbles;
  std::vector<Domain_edge_2> m_edges;
  boost::container::flat_map<std::pair<Index, Index>, Index> m_rim;
};

/// What an operation made of a patch.
struct Patch_outcome_2
{
  Bubble_mesh_2 mesh;
  std::vector<Index> original; ///< of each bubble its number in the patch; inserted ones come after the last

  /// The triangles that take the place of those of the patch, with labels of edges. `number[k]`: what bubble `k` is
  /// called there.
  std::vector<New_triangle_2> triangles(const Mesh_patch_2& patch, const std::vector<Index>& number) const
  {
    std::vector<New_triangle_2> result;
    const Marked_triangles_2& m = mesh.triangles;
    for (std::size_t k = 0; k < m.inside.size(); ++k) {
      if (!m.inside[k])
        continue;
      const Index t = static_cast<Index>(k);
      New_triangle_2 triangle;
      for (int i = 0; i < 3; ++i) {
        triangle.vertices[i] = number[m.vertices[t][i]];
        triangle.edges[i] = label(patch, t, i);
      }
      result.push_back(triangle);
    }
    return result;
  }

private:
  /// the rim of a patch is an edge there, but not where the patch is put
  Index label(const Mesh_patch_2& patch, Index t, int i) const
  {
    const Marked_triangles_2& m = mesh.triangles;
    if (m.edges[t][i] == no_index)
      return no_index;
    return patch.edge_on_rim(original[m.vertices[t][ccw(i)]], original[m.vertices[t][cw(i)]],
                             edge_label(m, t, i));
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_MESH_PATCH_2_H
