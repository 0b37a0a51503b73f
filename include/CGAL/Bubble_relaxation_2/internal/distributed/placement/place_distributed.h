// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/Placement_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/Starting_points_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>

#include <cstddef>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

/// Brings placed bubbles to the ranks that own their places, as many to each, and numbers them. Of those that
/// cannot be told apart one stays, as `remove_coincident()` has it.
inline Placed_part_2 bring_home_and_number(Communicator& comm, const Domain_2& domain, const Placement_team_2& team,
                                           Bubbles_2 bubbles)
{
  remove_confusing_on_edges(domain, bubbles);
  bubbles.id.assign(bubbles.size(), no_index); // as yet
  Curve_sort_2 on_curve(hilbert_curve(domain), bubbles);
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (!bubbles.is_gone(i) && team.brings(static_cast<Index>(i)))
      on_curve.add(static_cast<Index>(i));
  const Hilbert_partition_2 partition = on_curve.send_home_evenly(comm);
  on_curve.forget_coincident();
  on_curve.select();
  number_along_curve(comm, bubbles);
  return Placed_part_2{std::move(bubbles), partition};
}

/// Collective. What a rank places, in `place(problem, team)`, of a problem with its share of what is given. `points`: of
/// those to start from, if any rank has some; they take the place of the free vertices of the domain's triangulation.
template <class Place>
Placed_part_2 place_by_all(Communicator& comm, const Problem_2& problem, const Bubbles_2& points, const Place& place)
{
  const Starting_points_2 given(comm, problem, points);
  const Problem_2 here{problem.domain, given.here(), problem.options, problem.wanted, problem.sizes};
  Placement_team_2 team(comm);
  Bubbles_2 bubbles = place(here, team);
  comm.agree();
  return bring_home_and_number(comm, problem.domain, team, std::move(bubbles));
}

/// The initial bubbles, each on the rank that owns its place. All ranks put bubbles on the outline, which all of
/// them have; the faces are filled by all together.
inline Placed_part_2 place_distributed(Communicator& comm, const Problem_2& problem, const Bubbles_2& points = {})
{
  return place_by_all(comm, problem, points, [](const Problem_2& p, Team& team) { return place_bubbles(p, team); });
}

/// The bubbles that were given, all of them, whatever d asks for, as `given_bubbles()` has them.
inline Placed_part_2 given_bubbles_distributed(Communicator& comm,
                                               const Problem_2& problem, const Bubbles_2& points = {})
{
  return place_by_all(comm, problem, points, [](const Problem_2& p, Team& team) { return given_bubbles(p, team); });
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H
