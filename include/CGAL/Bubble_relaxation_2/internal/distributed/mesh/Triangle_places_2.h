// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_TRIANGLE_PLACES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_TRIANGLE_PLACES_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_regions_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>

#include <array>
#include <cstddef>

namespace CGAL::Bubble_relaxation_2::internal {

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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_TRIANGLE_PLACES_2_H
