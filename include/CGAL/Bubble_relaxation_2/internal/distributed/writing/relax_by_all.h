// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. What `Distributed::npbs_relax()` and `Distributed::npbs_mesh()` have in common: all but what they
/// return, which `write(part, input, ranks, report)` prepares by all ranks. If it throws, it throws on all.
template <class PointSet, class CDT, class NamedParameters, class Write>
auto relax_by_all(PointSet& points, const CDT& domain, MPI_Comm comm, const NamedParameters& np, const Write& write)
{
  Communicator ranks(comm);

  Report report;
  Phase_timer reading_time(report.seconds.reading);
  const auto input = read_same_input(domain, np, ranks);
  const Progress_scope scope(*input->options.progress);
  const std::int64_t n = ranks.sum(static_cast<std::int64_t>(points.size()));
  if (n != 0 && !Is_given<NamedParameters, internal_np::sizing_function_t>::value)
    ranks.throw_on_all(
      std::invalid_argument("Bubble_relaxation_2: parameter points has " + std::to_string(n) + " points on all ranks "
                            "together, but there is no sizing_function; no rank has their mesh to take sizes from"));
  Bubbles_2 given;
  ranks.agree_after([&] { given = read_bubbles(points, input->reading.domain, input->limits.sizes, true); });
  reading_time.stop();
  const std::optional<Relaxed_part_2> part = relax_part(input->problem(), given, ranks, report);
  if (part) {
    const Phase_timer writing_time(report.seconds.writing);
    write(*part, *input, ranks, report);
    ranks.agree_after([&] { input->options.progress->finish(); });
    write_bubbles(part->bubbles, points); // nothing of the user's can fail on any rank from here on
  }
  Bubble_relaxation_seconds& s = report.seconds; // of the slowest rank
  for (double* phase : {&s.reading, &s.placement, &s.renewal, &s.motion, &s.population, &s.treatment, &s.writing,
                        &s.evaluation})
    *phase = ranks.largest(*phase);
  return Bubble_relaxation_report_2<typename Quality_number<typename CDT::Geom_traits>::type>(report);
}

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own, in the order of their numbers. `known`: see `with_neighbors()`
template <class Relaxation>
void write_neighbors(const Bubbles_2& known, double radius, Relaxation& relaxation)
{
  const std::ptrdiff_t n = std::count(known.owner.begin(), known.owner.end(), known.rank);
  std::vector<std::size_t> offsets;
  std::vector<Index> neighbors, ghosts;
  find_neighbors(known, radius, Threads(), offsets, neighbors);
  neighbors.resize(offsets[n]); // without those of ghosts
  relaxation.neighbor_radius = radius;
  relaxation.neighbor_offsets.assign(offsets.begin(), offsets.begin() + n + 1);
  relaxation.neighbors.reserve(neighbors.size());
  for (Index j : neighbors) {
    tick(relaxation.neighbors.size());
    relaxation.neighbors.push_back(known.id[j]);
    if (!known.is_ours(j))
      ghosts.push_back(j);
  }
  std::sort(ghosts.begin(), ghosts.end(), [&](Index i, Index j) { return known.id[i] < known.id[j]; });
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  for (Index i : ghosts) {
    relaxation.ghost_ids.push_back(known.id[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(known.x[i], known.y[i]));
    relaxation.ghost_sizes.push_back(known.d[i]);
    relaxation.ghost_owners.push_back(known.owner[i]);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
