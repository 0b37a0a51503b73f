// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Team_of_ranks.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>

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
  check_given_points(ranks, points.size(), Is_given<NamedParameters, internal_np::sizing_function_t>::value);
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
    if (problem.cut != nullptr)
      mesh = join_distributed(*problem.cut, mesh, part.partition, ranks);
    input->options.progress->start_phase(Bubble_phase::EVALUATION);
    Team_of_ranks team(ranks);
    evaluate(mesh, problem, team, report);
    input->options.progress->start_phase(Bubble_phase::WRITING);
    const Phase_timer writing_time(report.seconds.writing);
    Bubbles_2 bubbles;
    ranks.agree_after([&] {
      ask_sizes(mesh, input->limits.sizes);
      bubbles = own_bubbles(mesh, ranks.rank());
    });
    write(Relaxed_part_2{mesh, bubbles, part.partition, input->options, ranks}, input->reading, report);
    ranks.agree_after([&] { input->options.progress->finish(); });
    write_bubbles(bubbles, points); // nothing of the user's can fail on any rank from here on
  }
  find_slowest(ranks, report.seconds);
  return Bubble_relaxation_report_2<typename Quality_number<typename CDT::Geom_traits>::type>(report);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
