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
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. Each phase takes as long as on the slowest rank.
inline void find_slowest(const Communicator& comm, Bubble_relaxation_seconds& s)
{
  for (double* phase : {&s.reading, &s.placement, &s.renewal, &s.motion, &s.population, &s.treatment, &s.writing,
                        &s.evaluation})
    *phase = comm.largest(*phase);
}

/// Collective. Adds up what each rank counts for itself.
inline void add_up_counts(const Communicator& comm, Report& r)
{
  for (std::size_t* count : {&r.number_of_moves, &r.number_of_returns, &r.number_of_insertions, &r.number_of_deletions})
    *count = static_cast<std::size_t>(comm.sum(static_cast<std::int64_t>(*count)));
}

/// What a rank has when bubbles have been simulated and treated, before its points are changed.
struct Relaxed_part_2
{
  const Distributed_mesh_2& mesh;
  const Bubbles_2& bubbles;             ///< its own, in the order of their numbers
  const Hilbert_partition_2& partition; ///< that they need not be at home in any more
  const Relaxation_options& options;
  Communicator& comm;
};

/// Collective. What `Distributed::npbs_relax()` and `Distributed::npbs_mesh()` have in common: all but what they
/// return, which `write(part, reading, report)` prepares by all ranks. If it throws, it throws on all.
template <class PointSet, class CDT, class NamedParameters, class Write>
auto relax_by_all(PointSet& points, const CDT& domain, MPI_Comm comm, const NamedParameters& np, const Write& write)
{
  Communicator ranks(comm);

  Report report;
  Phase_timer reading_time(report.seconds.reading);
  const auto input = read_same_input(domain, np, ranks);
  const Progress_scope scope(*input->options.progress);
  const Domain_2& read_domain = input->reading.domain;
  const std::int64_t n = ranks.sum(static_cast<std::int64_t>(points.size()));
  if (n != 0 && !Is_given<NamedParameters, internal_np::sizing_function_t>::value)
    ranks.throw_on_all(
      std::invalid_argument("Bubble_relaxation_2: parameter points has " + std::to_string(n) + " points on all ranks "
                            "together, but there is no sizing_function; no rank has their mesh to take sizes from"));
  Bubbles_2 given;
  ranks.agree_after([&] { given = read_bubbles(points, read_domain, input->limits.sizes); });
  Problem_2 problem = input->problem();
  problem.sizes = agreed_sizes(input->limits.sizes, ranks, Hilbert_curve_2(read_domain.bbox()).side());
  reading_time.stop();
  const Placed_part_2 part = simulate_distributed(ranks, problem, report, given);
  ranks.agree(); // the callback may have thrown, or d after the last step
  add_up_counts(ranks, report);
  Distributed_mesh_2 mesh;
  if (report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK)
    mesh = treat_distributed(problem, given, part, ranks, report);
  if (report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK) {
    input->options.progress->start_phase(Bubble_phase::EVALUATION);
    if (problem.cut != nullptr) {
      const Phase_timer joining_time(report.seconds.evaluation);
      Bubbles_2 own = own_bubbles(mesh.bubbles);
      problem.cut->join(own);
      const std::int64_t end = ranks.sum(static_cast<std::int64_t>(own.size()));
      mesh = triangulate_from_anywhere(problem.cut->whole(), part.partition, ranks, end, std::move(own));
    }
    Team_of_ranks team(ranks);
    evaluate(mesh, problem, team, report);
    input->options.progress->start_phase(Bubble_phase::WRITING);
    const Phase_timer writing_time(report.seconds.writing);
    Bubbles_2 bubbles;
    ranks.agree_after([&] {
      ask_sizes(mesh, input->limits.sizes);
      bubbles = own_bubbles(mesh.bubbles);
    });
    write(Relaxed_part_2{mesh, bubbles, part.partition, input->options, ranks}, input->reading, report);
    ranks.agree_after([&] { input->options.progress->finish(); });
    write_bubbles(bubbles, points); // nothing of the user's can fail on any rank from here on
  }
  find_slowest(ranks, report.seconds);
  return Bubble_relaxation_report_2<typename Quality_number<typename CDT::Geom_traits>::type>(report);
}

/// Collective. The bubbles of this rank, and after them those of others that are neighbours of one of them, and perhaps
/// some more: nearer than `radius` times the mean of both sizes, so nearer than that times the larger one.
/// \pre the numbers of `own` ascend
inline Bubbles_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius,
                                Communicator& comm)
{
  std::vector<Bubble_record_2> records;
  for (std::size_t i = 0; i < own.size(); ++i)
    records.push_back(record(own, i));
  const Shared_lists lists = share_around(comm, partition, radius, farthest_stray(comm, partition, own), records);
  Bubbles_2 known = with_owner(own, comm.rank());
  for (const auto& list : lists.received)
    for (Index i : list.second)
      add(known, records[i], list.first);
  return known;
}

/// Writes the neighbour sets of the bubbles of a rank into a `Relaxation_2`, and what it has to know of neighbours
/// that others own, in the order of their numbers. `known`: see `with_neighbors()`
template <class Relaxation>
void write_neighbors(const Bubbles_2& known, double radius, Relaxation& relaxation)
{
  constexpr std::size_t usual_number = 7;
  const std::size_t n = static_cast<std::size_t>(std::count(known.owner.begin(), known.owner.end(), known.rank));
  relaxation.neighbor_radius = radius;
  relaxation.neighbors.reserve(usual_number * n);
  relaxation.neighbor_offsets.reserve(n + 1);
  relaxation.neighbor_offsets.push_back(0);
  Neighbor_sets_2 sets(radius);
  sets.build(known);
  std::vector<char> is_ghost(known.size(), 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j) {
      relaxation.neighbors.push_back(known.id[*j]);
      is_ghost[*j] = !known.is_ours(*j);
    }
    relaxation.neighbor_offsets.push_back(relaxation.neighbors.size());
  }
  std::vector<Index> ghosts = marked(is_ghost);
  std::sort(ghosts.begin(), ghosts.end(), [&](Index i, Index j) { return known.id[i] < known.id[j]; });
  for (Index i : ghosts) {
    relaxation.ghost_ids.push_back(known.id[i]);
    relaxation.ghost_points.push_back(typename Relaxation::Point_2(known.x[i], known.y[i]));
    relaxation.ghost_sizes.push_back(known.d[i]);
    relaxation.ghost_owners.push_back(known.owner[i]);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
