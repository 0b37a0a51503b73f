// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUALITY_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUALITY_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Values_of_all_ranks.h>
#include <CGAL/Bubble_relaxation_2/internal/evaluate.h>
#include <CGAL/Mesh_quality_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// adds the triangles that a rank owns
inline void add_owned_triangles(const Distributed_mesh_2& mesh, Mesh_quality_accumulator_2& accumulator)
{
  const Flat_triangulation_2& tr = mesh.triangulation.tr;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    if (mesh.is_owned[t]) {
      const Index f = static_cast<Index>(t);
      accumulator.add_triangle(tr.point(f, 0), tr.point(f, 1), tr.point(f, 2));
    }
}

/// Calls `visit(a, b)` for the ends of all edges that a rank owns: those of which it owns the end with the smaller
/// number.
template <class Visitor>
void for_each_owned_edge(const Distributed_mesh_2& mesh, int rank, const Visitor& visit)
{
  const Marked_triangulation_2& marked = mesh.triangulation;
  const Flat_triangulation_2& tr = marked.tr;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (int i = 0; i < 3 && mesh.is_final[t]; ++i) {
      const Index n = tr.neighbors[t][i], f = static_cast<Index>(t);
      if (n != no_index && marked.inside[n] && n < f)
        continue; // seen from the other side
      const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
      if (mesh.known.owners[(std::min)(a, b)] == rank)
        visit(a, b);
    }
}

/// adds the lengths of the edges that a rank owns over d in the midpoints
template <class Sizing>
void add_owned_lengths(const Distributed_mesh_2& mesh, int rank, const Sizing& sizing,
                       Mesh_quality_accumulator_2& accumulator)
{
  const std::vector<Point>& points = mesh.triangulation.tr.points;
  for_each_owned_edge(mesh, rank,
                      [&](Index a, Index b) { add_length(points[a], points[b], sizing, accumulator); });
}

/// adds the vertices that a rank owns
inline void add_owned_vertices(const Distributed_mesh_2& mesh, int rank,
                               Mesh_quality_accumulator_2& accumulator)
{
  const Marked_triangulation_2& marked = mesh.triangulation;
  const std::size_t n = mesh.known.size();
  std::vector<char> is_in_domain(n, 0), is_interior(n, 1);
  std::vector<std::size_t> degrees(n, 0);
  for (std::size_t t = 0; t < marked.tr.number_of_triangles(); ++t) {
    const auto& v = marked.tr.vertices[t];
    for (int i = 0; i < 3; ++i) {
      ++degrees[v[i]];
      if (marked.inside[t])
        is_in_domain[v[i]] = 1;
      if (marked.edges[t][i] != no_index)
        is_interior[v[ccw(i)]] = is_interior[v[cw(i)]] = 0;
    }
  }
  for (std::size_t v = 0; v < n; ++v)
    if (is_in_domain[v] && mesh.known.owners[v] == rank)
      accumulator.add_vertex(is_interior[v] != 0, degrees[v]);
}

/// Collective. The statistics of the mesh of all ranks, on all ranks the same as one rank alone would find them,
/// to the last bit. `sizing`: a pointer to the sizing field, or null if there are to be no lengths. What it
/// throws on one rank all throw.
template <class FT = double, class Sizing>
Mesh_quality_2<FT> distributed_quality(const Distributed_mesh_2& mesh, const Sizing* sizing,
                                       const Communicator& comm, Agreement& agreement)
{
  Mesh_quality_accumulator_2 accumulator;
  agreement.reach_after([&] {
    add_owned_triangles(mesh, accumulator);
    add_owned_vertices(mesh, comm.rank(), accumulator);
    if (sizing != nullptr)
      add_owned_lengths(mesh, comm.rank(), *sizing, accumulator);
  });
  return Mesh_quality_2<FT>(accumulator.statistics(Values_of_all_ranks(comm)));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_QUALITY_H
