// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Simulation_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Places bubbles and simulates them, all ranks together: those that `relax_bubbles()` makes on one. Their
/// numbers are their indices there. `points`: see `place_distributed()`;
/// `traffic`: what this rank sent and held, if it is asked for.
/// \pre sizes of `problem` keep what they throw until ranks agree on it
inline Placed_part_2 simulate_distributed(Communicator& comm,
                                          const Problem_2& problem, Report& report,
                                          const Bubbles_2& points = {}, Traffic_2* traffic = nullptr)
{
  Simulation_team_2 team(comm, problem.options);
  Phase_timer placement_time(report.seconds.placement);
  problem.options.progress->start_phase(Bubble_phase::PLACEMENT);
  Placed_part_2 part = place_distributed(comm, problem, points);
  Bubbles_2& bubbles = part.bubbles;
  bubbles.rank = comm.rank();
  bubbles.owner.assign(bubbles.size(), comm.rank());
  const std::int64_t number = comm.sum(static_cast<std::int64_t>(bubbles.size()));
  report.number_of_initial_bubbles = static_cast<std::size_t>(number);
  team.start(part.partition, number);
  placement_time.stop();
  relax(problem, bubbles, team, report);
  if (traffic)
    *traffic = team.traffic();
  remove_confusing_of_ours(comm, problem.domain, bubbles);
  const Hilbert_partition_2& partition = team.even_partition(bubbles);
  return Placed_part_2{bring_home_and_number(comm, partition, team.population().next_number(), std::move(bubbles)),
                       partition};
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
