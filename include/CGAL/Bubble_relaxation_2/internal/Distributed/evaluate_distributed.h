// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVALUATE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVALUATE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Values_of_all_ranks.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distributed_quality.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/evaluate_size_gradient.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// d at the vertices of the triangles around own bubbles
template <class Sizing>
std::vector<double> sizes_around_own(const Distributed_mesh_2& mesh, const Sizing& sizing)
{
  const Flat_triangulation_2& tr = mesh.triangulation.tr;
  std::vector<char> is_needed(tr.points.size(), 0);
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (Index v : tr.vertices[t])
      is_needed[v] |= mesh.is_final[t];
  std::vector<double> sizes(tr.points.size(), 0);
  for (std::size_t v = 0; v < sizes.size(); ++v)
    if (is_needed[v])
      sizes[v] = sizing(tr.points[v]);
  return sizes;
}

/// Collective. Puts the statistics of the mesh of all ranks into the report, as `evaluate()` does of that of one.
/// What d throws on one rank all throw.
template <class Sizing, class Report>
void evaluate_distributed(const Distributed_mesh_2& mesh, const Sizing& sizing, const Communicator& comm,
                          Agreement& agreement, Report& report)
{
  const Phase_timer timer(report.seconds.evaluation);
  report.quality = distributed_quality<typename Report::FT>(mesh, &sizing, comm, agreement);
  report.number_of_vertices = report.quality.number_of_vertices();
  report.number_of_triangles = report.quality.number_of_triangles();
  Size_gradient_2 gradient(Report::steep_size_gradient);
  agreement.reach_after([&] {
    const std::vector<double> sizes = sizes_around_own(mesh, sizing);
    const std::vector<Point>& points = mesh.triangulation.tr.points;
    for_each_owned_edge(mesh, comm.rank(),
                        [&](Index a, Index b) { gradient.add(points[a], sizes[a], points[b], sizes[b]); });
  });
  gradient.tell(report, Values_of_all_ranks(comm));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVALUATE_DISTRIBUTED_H
