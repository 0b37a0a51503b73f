// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/population/adjust_population.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <CGAL/Bubble_relaxation_report_2.h>

#include <cstddef>

namespace CGAL::Bubble_relaxation_2::internal {

inline void add_to_report(const Round_result& result, unsigned evaluations_per_step, Observer* observer,
                          Report& report)
{
  ++report.number_of_rounds;
  report.number_of_steps += result.steps;
  report.number_of_force_evaluations += result.steps * evaluations_per_step;
  report.number_of_moves += result.moves;
  report.number_of_renewals += result.renewals;
  report.number_of_returns += result.returns;
  if (observer != nullptr)
    observer->round_ends(report);
}

/// In the second half of the rounds what still does not rest swings to and fro, which shorter and shorter steps end.
inline void choose_step(std::size_t round, const Relaxation_options& options, Simulation_2& simulation)
{
  if (round < (options.number_of_rounds + 1) / 2)
    return;
  simulation.rest_finely();
  if (options.population == Bubble_population::DELAUNAY)
    simulation.halve_steps();
}

/// Changes the population. When few bubbles come in, the time of coarse rest and insertions is over. In a mesh that was
/// given d may have changed in one place only: there all holes are filled first.
inline void change_population(const Population_change& change, const Relaxation_options& options,
                              Simulation_2& simulation, Bubbles_2& bubbles, Team& team)
{
  constexpr std::size_t many = 50; // one in so many
  if (!simulation.rests_coarsely() || options.population != Bubble_population::DELAUNAY) {
    simulation.apply(change);
    return;
  }
  const std::size_t before = team.number_of_all(bubbles);
  simulation.apply(change);
  const std::size_t inserted = team.number_of_all(bubbles) - before;
  if (keeps_given_bubbles(options) ? inserted == 0 : many * inserted < before)
    simulation.rest_finely();
}

/// The flow chart of the method (Fig. 2 of the paper) after the initial placement: simulate, adjust
/// the population, and again, until the bubbles rest and their population stays. At first a coarse rest will do, and
/// bubbles are inserted; then it is to be as fine as is asked for, and they are deleted.
inline void relax(const Problem_2& problem, Bubbles_2& bubbles, Team& team, Report& report)
{
  const std::size_t number_of_rounds = problem.options.number_of_rounds;
  Progress& progress = *problem.options.progress;
  progress.start_phase(Bubble_phase::SIMULATION);
  Simulation_2 simulation(problem, bubbles, team);
  simulation.rest_coarsely();
  for (std::size_t round = 0; round < number_of_rounds; ++round) {
    choose_step(round, problem.options, simulation);
    const Round_result result = simulation.run_round(report.seconds);
    add_to_report(result, simulation.evaluations_per_step(), progress.observer(), report);
    if (result.is_cancelled) {
      tell_that_it_was_stopped(report);
      break;
    }
    const bool is_last = round + 1 == number_of_rounds;
    if (is_last && !result.is_at_rest)
      break;
    const Phase_timer timer(report.seconds.population);
    const Population_step step = simulation.rests_coarsely() ? Population_step::INSERTION : Population_step::DELETION;
    const Population_change change =
      adjust_population(problem, bubbles, simulation.neighbors(), simulation.touched(), step, team);
    if (!team.any(!change.is_empty()) && result.is_at_rest && !simulation.rest_finely()) {
      report.stop_reason = Bubble_stop_reason::CONVERGED;
      break;
    }
    if (is_last)
      break; // what is inserted now would not be relaxed
    report.number_of_insertions += change.inserted.size();
    report.number_of_deletions += bubbles.count_ours(change.deleted);
    change_population(change, problem.options, simulation, bubbles, team);
  }
  report.converged = report.stop_reason == Bubble_stop_reason::CONVERGED;
}

/// The whole method without the triangulation: initial bubbles, simulation, population.
inline Bubbles_2 relax_bubbles(const Problem_2& problem, Report& report)
{
  Progress& progress = *problem.options.progress;
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    progress.start_phase(Bubble_phase::PLACEMENT);
    bubbles = place_bubbles(problem);
    report.number_of_initial_bubbles = bubbles.size();
  }
  Team alone;
  try {
    relax(problem, bubbles, alone, report);
  } catch (const Stopped_by_callback&) { // each bubble is somewhere in the domain, so there is a mesh
    if (problem.options.restore_when_stopped)
      throw;
    tell_that_it_was_stopped(report);
  }
  if (!problem.options.restore_when_stopped)
    progress.remember_stop();
  bubbles.forget_gone();
  remove_coincident(problem.domain, bubbles);
  return bubbles;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H
