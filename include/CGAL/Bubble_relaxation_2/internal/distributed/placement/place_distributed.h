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
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/Starting_points_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/Growth_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_rhombic.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Bubbles as they are placed: those that all ranks have, and after them those that only this rank has, or that
/// others have too.
struct Placement_2
{
  Bubbles_2 bubbles;
  std::vector<char> is_ours; ///< each is on one rank only

  /// of those that all ranks have it is the first
  Placement_2(Bubbles_2 common, Communicator& comm)
    : bubbles(std::move(common)), is_ours(bubbles.size(), comm.rank() == 0)
  {}
};

/// Bubbles where those in faces were given.
inline void keep_given(const Domain_2& domain, const Starting_points_2& given, const Sizes_2& sizing,
                       Placement_2& placed)
{
  Index hint = 0;
  for (const Starting_points_2::Free& f : given.free()) {
    const Index triangle = domain.host_of(f.point, hint);
    if (triangle == no_index) // rounded out of the domain
      continue;
    placed.bubbles.add(f.point, sizing(f.point), Bubbles_2::FACE, triangle);
    placed.is_ours.push_back(1);
  }
}

/// Large bubbles that fill the domain, the same on all ranks: where they are many, bubbles will be many.
inline Bubbles_2 large_bubbles(const Domain_2& domain, const Sizes_2& sizing, const Bubbles_2& on_outline)
{
  const double factor = factor_of_large_bubbles(sizing.expected_number);
  Bubbles_2 large = enlarge(domain, on_outline, factor);
  Team alone;
  grow_from_all(domain, scaled(sizing, factor), {}, large, alone, Threads());
  return large;
}

/// Bubbles where those in faces were given, as far as they fit d; the rest is filled by a front of all ranks.
inline void adapt_given(const Domain_2& domain, const Starting_points_2& given, const Sizes_2& sizing,
                        Growth_team_2& team, Bubbles_2& bubbles)
{
  team.divide(domain, large_bubbles(domain, sizing, bubbles));
  const std::vector<Mesh_star_2> stars = given.stars();
  std::vector<Growth_seed_2> seeds;
  Index hint = 0;
  for (std::size_t k = 0; k < stars.size(); ++k) {
    const Starting_points_2::Free& f = given.free()[k];
    const Index triangle = domain.host_of(f.point, hint);
    if (triangle == no_index)
      continue;
    const double d = sizing(f.point);
    if (stars[k].fits(d))
      seeds.push_back(Growth_seed_2{f.point.x(), f.point.y(), d, stars[k].direction, f.number, triangle});
  }
  std::vector<double> directions(bubbles.size(), 0);
  team.bring_seeds(seeds, bubbles, directions);
  grow_from_all(domain, sizing, directions, bubbles, team, Threads());
}

/// Bubbles in the cells of a rhombus: each rank makes those in its part.
inline void place_rhombic_by_all(Communicator& comm, const Domain_2& domain,
                          const Sizes_2& sizing, Placement_2& placed)
{
  const Hilbert_partition_2 partition = partition_of_common(
    hilbert_curve(domain), large_bubbles(domain, sizing, placed.bubbles), comm.size());
  Part_team_2 team(comm, partition); // each makes those whose centres are in its part
  Rhombic_placement(domain, sizing, placed.bubbles, team)();
  placed.is_ours.resize(placed.bubbles.size(), 1);
}

/// what `place_bubbles()` does, by all ranks together
inline Placement_2 place_by_all(Communicator& comm, const Problem_2& problem, const Starting_points_2& given)
{
  const Domain_2& domain = problem.domain;
  const Sizes_2& sizing = problem.sizes;
  const Relaxation_options& options = problem.options;
  const bool adapts = !options.placement_is_given && given.has_free(), keeps = keeps_given_bubbles(options);
  const On_edges way = adapts || keeps ? On_edges::KEEP_THE_RIGHT_NUMBER : On_edges::PLACE_ANEW;
  Placement_2 placed(place_on_outline(domain, given.outline(), way, sizing), comm);
  if (keeps) {
    keep_given(domain, given, sizing, placed);
    return placed;
  }
  if (!adapts && options.placement == Bubble_placement::RHOMBIC) {
    place_rhombic_by_all(comm, domain, sizing, placed);
    return placed;
  }
  Growth_team_2 team(comm);
  if (adapts)
    adapt_given(domain, given, sizing, team, placed.bubbles);
  else
    place_frontal(domain, sizing, placed.bubbles, team, Threads());
  placed.is_ours.resize(placed.bubbles.size(), comm.rank() == 0);
  for (std::size_t i = 0; team.is_divided() && i < placed.is_ours.size(); ++i)
    placed.is_ours[i] = team.owns(static_cast<Index>(i));
  return placed;
}

/// Brings placed bubbles to the ranks that own their places, as many to each, and numbers them. Of those that
/// cannot be told apart one stays, as `remove_coincident()` has it.
inline Placed_part_2 bring_home_and_number(Communicator& comm, const Domain_2& domain, Placement_2& placed)
{
  Bubbles_2& bubbles = placed.bubbles;
  remove_confusing_on_edges(domain, bubbles);
  bubbles.id.assign(bubbles.size(), no_index); // as yet
  Curve_sort_2 on_curve(hilbert_curve(domain), bubbles);
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (!bubbles.is_gone(i) && placed.is_ours[i])
      on_curve.add(static_cast<Index>(i));
  const Hilbert_partition_2 partition = on_curve.send_home_evenly(comm);
  on_curve.forget_coincident();
  on_curve.select();
  number_along_curve(comm, bubbles);
  return Placed_part_2{std::move(bubbles), partition};
}

/// The initial bubbles, each on the rank that owns its place. All ranks put bubbles on the outline, which all of
/// them have; the faces are filled by all together. `points`: this rank's part of those to start from, if any rank
/// has some; they take the place of the free vertices of the domain's triangulation.
inline Placed_part_2 place_distributed(Communicator& comm, const Problem_2& problem, const Bubbles_2& points = {})
{
  const Starting_points_2 given(comm, problem, points);
  Placement_2 placed = place_by_all(comm, problem, given);
  comm.agree();
  return bring_home_and_number(comm, problem.domain, placed);
}

/// The bubbles that were given, all of them, whatever d asks for, as `given_bubbles()` has them.
inline Placed_part_2 given_bubbles_distributed(Communicator& comm,
                                               const Problem_2& problem, const Bubbles_2& points = {})
{
  const Starting_points_2 given(comm, problem, points);
  Placement_2 placed(place_on_outline(problem.domain, given.outline(), On_edges::KEEP, problem.sizes), comm);
  keep_given(problem.domain, given, problem.sizes, placed);
  comm.agree();
  return bring_home_and_number(comm, problem.domain, placed);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PLACEMENT_PLACE_DISTRIBUTED_H
