// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_ALONE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_ALONE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Population_alone.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// what all ranks together have to know after a step
struct Step_sums
{
  std::size_t restless; ///< bubbles that moved more than the tolerance
  std::size_t outrun;   ///< bubbles that have used up their skin
};

/// No other ranks: what a team does at each place of the simulation.
struct Simulation_alone
{
  static constexpr bool is_alone = true;

  /// of all ranks
  std::size_t number_of_all(const Bubbles_2& bubbles) const { return bubbles.size(); }
  /// whether another rank has to know where a bubble is
  bool is_at_border(Index) const { return false; }
  /// begins to tell other ranks where bubbles are within a step
  void send_positions(const Neighbor_sets_2&, const std::vector<double>&, const std::vector<double>&) const {}
  /// puts in where theirs are
  void receive_positions(std::vector<double>&, std::vector<double>&) const {}
  /// completes the neighbour sets of bubbles that other ranks own
  template <class Neighbor_sets>
  void share_sets(const Bubbles_2&, Neighbor_sets&)
  {}
  /// begins to tell other ranks of the bubbles at the border that were active
  void send_moves(const Bubbles_2&, const std::vector<Index>&, const std::vector<char>&) {}
  /// takes over what others told: returns their bubbles that were active, and adds whether they move
  const std::vector<Index>& receive_moves(Bubbles_2&, const std::vector<Index>&, std::vector<char>&) const
  {
    return none;
  }
  /// over all ranks
  Step_sums sum(const Step_sums& sums) const { return sums; }
  /// whether no rank wants to stop
  bool goes_on(bool here) const { return here; }
  /// looks for the bubbles of other ranks around ours before the first step
  template <class Simulation>
  void surround(Simulation&, Bubbles_2&)
  {}
  /// whether bubbles have gone so far that those of other ranks around them are to be looked for anew
  bool is_outgrown() const { return false; }
  /// looks for them
  template <class Simulation>
  void surround_anew(Simulation&, Bubbles_2&)
  {}
  /// after the last step of a round
  template <class Simulation>
  void end_steps(Simulation&, Bubbles_2&)
  {}
  /// looks for bubbles of other ranks on the other side of holes that are wider than all is known
  template <class Simulation>
  void look_across_holes(Simulation&, Bubbles_2&)
  {}
  /// tells other ranks of the bubbles from `first` on, which are new, and adds those of others
  template <class Simulation>
  void share_new(Simulation&, Bubbles_2&, Index)
  {}
  /// whether it holds on any rank
  bool any(bool here) const { return here; }
  /// brings a simulation to where it was interrupted, if it was; returns how many rounds it had until then
  template <class Simulation, class Report>
  std::size_t resume(Simulation&, Bubbles_2&, Report&) const
  {
    return 0;
  }
  /// keeps where the simulation is now, after a round and its change of the population
  template <class Simulation, class Report>
  void end_round(const Simulation&, const Bubbles_2&, Report&) const
  {}

  Population_alone& population() { return m_population; }

  const std::vector<Index> none{};

private:
  Population_alone m_population;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_SIMULATION_ALONE_H
