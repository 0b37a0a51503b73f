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
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. Replaces distinct numbers below `end`, of which each rank has some, by 0, 1, … in their order. Each rank
/// counts those of an interval of numbers, which are mostly its own. \pre they ascend
inline void compact_numbers(Communicator& comm, std::int64_t end, std::vector<std::int64_t>& numbers)
{
  Messages<std::int64_t> out;
  for (std::int64_t number : numbers)
    out[static_cast<int>(number * comm.size() / end)].push_back(number);
  Messages<std::int64_t> in = deliver(comm, out);
  std::vector<std::int64_t> counted;
  for (const auto& message : in)
    counted.insert(counted.end(), message.second.begin(), message.second.end());
  std::sort(counted.begin(), counted.end());
  const std::int64_t before = comm.sum_before(static_cast<std::int64_t>(counted.size()));
  for (auto& message : in)
    for (std::int64_t& number : message.second)
      number = before + (std::lower_bound(counted.begin(), counted.end(), number) - counted.begin());
  auto next = numbers.begin();
  for (const auto& message : deliver(comm, in)) // from lower ranks come lower numbers
    next = std::copy(message.second.begin(), message.second.end(), next);
}

/// Removes bubbles of ours that cannot be told apart on edges, as `remove_crowded_on_edges()` does of all.
inline void remove_crowded_of_ours(Communicator& comm, const Domain_2& domain, Bubbles_2& b)
{
  std::vector<Bubble_record_2> all = gather_outline(comm, b);
  std::sort(all.begin(), all.end(), [](const Bubble_record_2& p, const Bubble_record_2& q) {
    return std::tie(p.dimension, p.host, p.s, p.id) < std::tie(q.dimension, q.host, q.s, q.id);
  });
  std::unordered_map<std::int64_t, Index> index;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_on_edge(i))
      index[b.id[i]] = static_cast<Index>(i);
  for (auto first = all.begin(), end = first; first != all.end(); first = end) {
    end = std::find_if(first, all.end(), [first](const Bubble_record_2& r) {
      return r.dimension != first->dimension || r.host != first->host;
    });
    if (first->dimension != Bubbles_2::EDGE)
      continue;
    Crowd_on_edge crowd(domain.length(first->host));
    for (auto r = first; r != end; ++r)
      if (const auto known = index.find(r->id); crowd.has(r->s, r->d) && known != index.end())
        b.remove(known->second);
  }
}

/// The bubbles that are left, each on the rank that owns its place and numbered from 0 on.
inline Placed_part_2 bring_home_and_number(Communicator& comm,
                                           const Hilbert_partition_2& partition, std::int64_t end, Bubbles_2 bubbles)
{
  std::vector<Index> left;
  left.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (bubbles.is_ours(i) && !bubbles.is_gone(i))
      left.push_back(static_cast<Index>(i));
  bubbles.select(left);
  bubbles.owner.clear(); // all are ours
  Bubbles_2 home = send_home(comm, partition, std::move(bubbles));
  remove_those_in_one_place(home);
  home.forget_gone();
  compact_numbers(comm, end, home.id);
  return Placed_part_2{std::move(home), partition};
}

/// Gives each rank its first bubbles, new ones or those of a checkpoint; returns how many were new.
inline std::size_t find_first_bubbles(Communicator& comm, const Problem_2& problem, const Bubbles_2& points,
                                      Checkpoints_2& checkpoints, Simulation_team_2& team, Bubbles_2& bubbles)
{
  bubbles.rank = comm.rank();
  if (checkpoints.is_restart()) {
    const Restart_2& restart = checkpoints.read(hilbert_curve(problem.domain), problem.sizes);
    for (const Bubble_state_2& s : restart.states)
      add(bubbles, s.bubble(), comm.rank());
    team.start(restart.partition, restart.header.number_of_all);
    return static_cast<std::size_t>(restart.header.initial_bubbles);
  }
  Placed_part_2 part = place_distributed(comm, problem, points);
  const std::int64_t number = comm.sum(static_cast<std::int64_t>(part.bubbles.size()));
  team.start(part.partition, number);
  bubbles = std::move(part.bubbles);
  bubbles.rank = comm.rank();
  bubbles.owner.assign(bubbles.size(), comm.rank());
  return static_cast<std::size_t>(number);
}

/// Places bubbles and simulates them, all ranks together: those that `relax_bubbles()` makes on one. Their
/// numbers are their indices there. `points`: see `place_distributed()`;
/// `traffic`: what this rank sent and held, if it is asked for.
/// \pre sizes of `problem` keep what they throw until ranks agree on it
inline Placed_part_2 simulate_distributed(Communicator& comm,
                                          const Problem_2& problem, Progress& progress, Report& report,
                                          const Bubbles_2& points = {}, Traffic_2* traffic = nullptr)
{
  Checkpoints_2 checkpoints(comm, hash_of_places(problem.domain, problem.given), problem.options);
  Simulation_team_2 team(comm, checkpoints, problem.options);
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    report.number_of_initial_bubbles =
      find_first_bubbles(comm, problem, points, checkpoints, team, bubbles);
  }
  relax(problem, bubbles, team, progress, report);
  if (traffic)
    *traffic = team.traffic();
  remove_crowded_of_ours(comm, problem.domain, bubbles);
  return bring_home_and_number(comm, team.partition(), team.population().next_number(),
                               std::move(bubbles));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
