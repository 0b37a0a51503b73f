// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The user's d on one of several ranks. What it throws is kept until all ranks can throw it; until then d is `large`,
/// so that little is done in vain.
inline Sizes_2 agreed_sizes(const Sizes_2& users, Communicator& comm, double large)
{
  Sizes_2 result([users, &comm, large](double x, double y) {
    double d = large;
    if (!comm.has_failed())
      comm.keep([&] { d = users(x, y); });
    return d;
  });
  result.expected_number = users.expected_number;
  return result;
}

CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
std::optional<Relaxed_part_2> relax_part(Problem_2 problem, const Bubbles_2& given, Communicator& comm,
                                         Report& report)
{
  const Sizes_2 users_sizes = problem.sizes;
  problem.sizes = agreed_sizes(users_sizes, comm, Hilbert_curve_2(problem.whole_domain().bbox()).side());
  const auto is_stopped = [&] { return report.stop_reason == Bubble_stop_reason::STOPPED_BY_CALLBACK; };
  const Placed_part_2 part = simulate_distributed(comm, problem, report, given);
  comm.agree(); // the callback may have thrown, or d after the last step
  for (std::size_t* count : {&report.number_of_moves, &report.number_of_returns, &report.number_of_insertions,
                             &report.number_of_deletions})
    comm.add_up(count, 1);
  if (is_stopped())
    return {};
  Distributed_mesh_2 mesh = treat_distributed(problem, given, part, comm, report);
  comm.agree(); // or it threw since: that is more than a stop
  if (is_stopped())
    return {};
  problem.options.progress->start_phase(Bubble_phase::EVALUATION);
  if (problem.cut != nullptr) {
    const Phase_timer joining_time(report.seconds.evaluation);
    Bubbles_2 own = own_bubbles(mesh.bubbles);
    problem.cut->join(own);
    const std::int64_t end = comm.sum(static_cast<std::int64_t>(own.size()));
    mesh = triangulate_from_anywhere(problem.cut->whole(), part.partition, comm, end, std::move(own));
  }
  Team_of_ranks team(comm);
  evaluate(mesh, problem, team, report);
  problem.options.progress->start_phase(Bubble_phase::WRITING);
  const Phase_timer writing_time(report.seconds.writing);
  Bubbles_2 own;
  comm.agree_after([&] {
    ask_sizes(mesh, users_sizes);
    own = own_bubbles(mesh.bubbles);
  });
  return Relaxed_part_2{std::move(mesh), std::move(own), part.partition};
}

CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
Bubbles_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius,
                         Communicator& comm)
{
  std::vector<Bubble_record_2> records = records_of(own);
  const Shared_lists lists = share_around(comm, partition, radius, farthest_stray(comm, partition, own), records);
  Bubbles_2 known = with_owner(own, comm.rank());
  for (const auto& list : lists.received)
    for (Index i : list.second)
      add(known, records[i], list.first);
  return known;
}

CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
Distributed_mesh_2 triangulate_part(const Domain_2& domain, Bubbles_2 points, bool have_numbers, const Sizes_2* sizes,
                                    Communicator& comm, Mesh_quality_2<double>& quality)
{
  Progress nobody; // a callback of what this is called in must not stop one rank alone
  const Progress_scope scope(nobody);
  Point_distribution_2 distribute(domain, comm);
  const Bubbles_2 own = distribute(std::move(points), have_numbers);
  Distributed_mesh_2 mesh = distributed_triangulate(domain, own, distribute.partition(), comm);
  Team_of_ranks team(comm);
  quality = quality_of(mesh, sizes, Threads(), team);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_IMPL_H
