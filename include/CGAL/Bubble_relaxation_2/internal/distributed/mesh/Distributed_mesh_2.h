// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_regions_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the numbers of the vertices of a triangle, in order
using Numbers_of_triangle = std::array<std::int64_t, 3>;

inline Numbers_of_triangle sorted_numbers(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  Numbers_of_triangle result{bubbles.id[vertices[0]], bubbles.id[vertices[1]], bubbles.id[vertices[2]]};
  std::sort(result.begin(), result.end());
  return result;
}

/// What a rank has of the one constrained Delaunay triangulation of the bubbles of all ranks. Triangles of the
/// domain with a vertex that this rank owns are the same as on one rank; all others are only what its
/// bubbles, the ghosts that it happens to know and the corners look like from here. When ranks have treated defects,
/// bubbles of others that no final triangle has may not be where they are here.
///
/// Its bubbles are own ones, ghosts, on edges too, and all corners, in the order of their identities.
struct Distributed_mesh_2 : Bubble_mesh_2
{
  std::vector<char> is_final;          ///< per triangle: in the domain, with an own vertex
  std::vector<char> is_owned;          ///< per triangle: each one of the domain on one rank only

  /// the vertex of a triangle that decides who owns it: the one with the smallest number
  Index first_vertex(std::size_t t) const
  {
    const std::array<Index, 3>& v = triangles.vertices[t];
    return (std::min)((std::min)(v[0], v[1]), v[2]); // indices follow numbers
  }

  void mark_triangles(int rank)
  {
    const std::size_t n = triangles.number_of_triangles();
    is_final.resize(n);
    is_owned.resize(n);
    const auto is_own = [&](Index v) { return bubbles.owner[v] == rank; };
    for (std::size_t t = 0; t < n; ++t) {
      tick(t);
      const std::array<Index, 3>& v = triangles.vertices[t];
      is_final[t] = triangles.inside[t] && (is_own(v[0]) || is_own(v[1]) || is_own(v[2]));
      is_owned[t] = is_final[t] && is_own(first_vertex(t));
    }
  }
};

/// Asks d anew where the bubbles of a rank, and those of others in triangles with them, are: neither the simulation nor
/// the treatment asks it again for every little displacement.
inline void ask_sizes(Distributed_mesh_2& mesh, const Sizes_2& sizing)
{
  Bubbles_2& known = mesh.bubbles;
  std::vector<char> is_asked(known.size(), 0);
  for (std::size_t i = 0; i < known.size(); ++i)
    is_asked[i] = known.is_ours(i);
  for (Index t : marked(mesh.is_final))
    for (Index v : mesh.triangles.vertices[t])
      is_asked[v] = 1;
  for (Index i : marked(is_asked))
    known.d[i] = sizing(known.point(static_cast<std::size_t>(i)));
}

/// On which edges of the domain a rank's triangles have sides, and in which regions they are.
class Triangle_places_2
{
public:
  Triangle_places_2(const Domain_2& domain, const Domain_regions_2& regions, const Distributed_mesh_2& mesh)
    : m_domain(domain), m_regions(regions), m_mesh(mesh)
  {}

  /// of each side the edge of the domain on which it lies, or `no_index`
  std::array<Index, 3> edges(std::size_t t) const
  {
    std::array<Index, 3> result{no_index, no_index, no_index};
    for (int i = 0; i < 3; ++i)
      if (m_mesh.triangles.edges[t][i] != no_index)
        result[i] = edge_of_piece(m_domain, m_mesh.bubbles, end(t, ccw(i)), end(t, cw(i)));
    return result;
  }

  /// A triangle beside an edge is where that says, since the edge may pass its corners on the wrong side by a rounding;
  /// another one is where its centre is. `edges`: of the triangle
  Index region(std::size_t t, const std::array<Index, 3>& edges)
  {
    if (m_regions.number_of_regions() == 1) // nothing has to be looked for
      return 0;
    for (int i = 0; i < 3; ++i)
      if (edges[i] != no_index) {
        const auto position = [&](int k) { return position_on(m_domain, m_mesh.bubbles, edges[i], end(t, k)); };
        return position(ccw(i)) < position(cw(i)) ? m_regions.left(edges[i]) : m_regions.right(edges[i]);
      }
    const Index k = static_cast<Index>(t);
    return m_regions(CGAL::centroid(m_mesh.point(k, 0), m_mesh.point(k, 1), m_mesh.point(k, 2)), m_hint);
  }

private:
  Index end(std::size_t t, int i) const { return m_mesh.triangles.vertices[t][i]; }

  const Domain_2& m_domain;
  const Domain_regions_2& m_regions;
  const Distributed_mesh_2& m_mesh;
  Index m_hint = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H
