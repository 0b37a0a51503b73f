// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreed_sizing_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Number_compaction.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Simulation_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/hilbert_curve.h>
#include <CGAL/Bubble_relaxation_2/internal/relax.h>
#include <CGAL/Bubble_relaxation_2/internal/remove_coincident.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Removes bubbles of ours that cannot be told apart on edges, as `remove_crowded_on_edges()` does of all.
inline void remove_crowded_of_ours(const Domain_2& domain, const Population_team_2& team, Bubbles_2& b)
{
  const Outline_bubbles_2 outline = team.outline(domain, b);
  for (std::size_t e = 0; e < outline.on_edge.size(); ++e) {
    Crowd_on_edge crowd(domain.length(static_cast<Index>(e)));
    for (const Outline_bubble_2& bubble : outline.on_edge[e])
      if (crowd.has(bubble.s, bubble.d) && bubble.index != no_index)
        b.remove(bubble.index);
  }
}

/// The bubbles that are left, each on the rank that owns its place and numbered from 0 on.
inline Placed_part_2 bring_home_and_number(const Communicator& comm, Sparse_exchange& exchange,
                                           const Hilbert_partition_2& partition, std::int64_t end, Bubbles_2 bubbles)
{
  std::vector<Index> left;
  left.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (bubbles.is_ours(i) && !bubbles.is_gone(i))
      left.push_back(static_cast<Index>(i));
  bubbles.select(left);
  std::vector<std::int64_t> numbers = std::move(bubbles.number);
  bubbles.forget_parts();
  Numbered_bubbles_2 home = bring_home(partition, exchange, comm.rank(), {std::move(bubbles), std::move(numbers)});
  remove_those_in_one_place(home.bubbles);
  home.forget_gone();
  Number_compaction(comm, exchange, end)(home.numbers);
  return Placed_part_2{std::move(home), partition};
}

/// Gives each rank its first bubbles, new ones or those of a checkpoint; returns how many were new.
template <class Cdt, class Sizing>
std::size_t find_first_bubbles(const Communicator& comm, Sparse_exchange& exchange, Agreement& agreement,
                               const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                               const Relaxation_options& options, const Numbered_bubbles_2& points,
                               Checkpoints_2& checkpoints, Simulation_team_2& team, Bubbles_2& bubbles)
{
  if (checkpoints.is_restart()) {
    const Restart_2& restart = checkpoints.read(hilbert_curve(reading.domain), sizing);
    for (const Bubble_state_2& s : restart.states)
      add(bubbles, s.bubble, false);
    team.start(restart);
    return static_cast<std::size_t>(restart.header.initial_bubbles);
  }
  Placed_part_2 part = place_distributed(comm, exchange, agreement, cdt, reading, sizing, options, points);
  team.start(part);
  bubbles = std::move(part.bubbles.bubbles);
  bubbles.number = std::move(part.bubbles.numbers);
  bubbles.is_foreign.assign(bubbles.size(), 0);
  return static_cast<std::size_t>(comm.sum(static_cast<std::int64_t>(bubbles.size())));
}

/// Places bubbles and simulates them, all ranks together: those that `simulate_bubbles()` makes on one. Their
/// numbers are their indices there. What d throws on one rank is thrown on all. `points`: see `place_distributed()`;
/// `traffic`: what this rank sent and held, if it is asked for.
template <class Cdt, class Sizing, class Report>
Placed_part_2 simulate_distributed(const Communicator& comm, Sparse_exchange& exchange, Agreement& agreement,
                                   const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& users,
                                   const Relaxation_options& options, Progress& progress, Report& report,
                                   const Numbered_bubbles_2& points = {}, Traffic_2* traffic = nullptr)
{
  const Agreed_sizing_field_2<Sizing> sizing(users, agreement, Hilbert_curve_2(reading.domain.bbox()).side());
  Checkpoints_2 checkpoints(comm, exchange, agreement, hash_of_places(reading), options);
  Simulation_team_2 team(comm, exchange, agreement, checkpoints, options);
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    report.number_of_initial_bubbles = find_first_bubbles(comm, exchange, agreement, cdt, reading, sizing, options,
                                                          points, checkpoints, team, bubbles);
  }
  if (options.integrator == Bubble_integrator::RUNGE_KUTTA_4)
    relax<Sequential_tag, Runge_kutta_4<Sequential_tag>>(reading.domain, sizing, options, bubbles, team, progress,
                                                         report);
  else
    relax<Sequential_tag, Semi_implicit_euler<Sequential_tag>>(reading.domain, sizing, options, bubbles, team,
                                                               progress, report);
  if (traffic)
    *traffic = team.traffic();
  remove_crowded_of_ours(reading.domain, team.population(), bubbles);
  return bring_home_and_number(comm, exchange, team.partition(), team.population().next_number(),
                               std::move(bubbles));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATE_DISTRIBUTED_H
