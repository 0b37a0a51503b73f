// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Delaunay_population.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Overlap_population.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/expected_number_of_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/read_sizes.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// How the bubbles' number should change, by the rule the user chose.
template <class Concurrency_tag, class Simulation, class Sizing, class Team>
Population_change adjust_population(const Domain_2& domain, const Sizing& sizing,
                                    const Relaxation_options& options, const Bubbles_2& bubbles,
                                    const Simulation& simulation, Team& team)
{
  switch (options.population) {
  case Bubble_population::OVERLAP_RATIO:
    return Overlap_population<Sizing, Team>(domain, sizing, team)(bubbles);
  case Bubble_population::DELAUNAY:
    return Delaunay_population<Concurrency_tag, Sizing, Team>(domain, sizing, team)(
      bubbles, simulation.neighbors(), simulation.touched());
  default:
    return Population_change();
  }
}

template <class Report>
void add_to_report(const Round_result& result, unsigned evaluations_per_step, Report& report)
{
  ++report.number_of_rounds;
  report.number_of_steps += result.steps;
  report.number_of_force_evaluations += result.steps * evaluations_per_step;
  report.number_of_moves += result.moves;
  report.number_of_renewals += result.renewals;
  report.number_of_returns += result.returns;
}

/// on other ranks others of them count
inline std::size_t count_ours(const Bubbles_2& bubbles, const std::vector<Index>& those)
{
  return static_cast<std::size_t>(
    std::count_if(those.begin(), those.end(), [&bubbles](Index i) { return bubbles.is_ours(i); }));
}

/// The flow chart of the method (Fig. 2 of the paper) after the initial placement: simulate, adjust
/// the population, and again, until the bubbles rest and their population stays. In the first half of the
/// rounds, while it changes, a coarse rest will do.
template <class Concurrency_tag, class Integrator, class Sizing, class Team, class Report>
void relax(const Domain_2& domain, const Sizing& sizing, const Relaxation_options& options,
           Bubbles_2& bubbles, Team& team, Progress& progress, Report& report)
{
  Simulation_2<Concurrency_tag, Integrator, Sizing, Team> simulation(domain, sizing, options, bubbles, team);
  simulation.rest_coarsely();
  for (std::size_t round = team.resume(simulation, bubbles, report); round < options.number_of_rounds; ++round) {
    if (2 * round >= options.number_of_rounds)
      simulation.rest_finely();
    progress.start_round(round);
    const Round_result result = simulation.run_round(progress, report.seconds);
    add_to_report(result, Integrator::evaluations_per_step, report);
    if (result.is_cancelled) {
      report.stop_reason = Bubble_stop_reason::STOPPED_BY_CALLBACK;
      break;
    }
    const bool is_last = round + 1 == options.number_of_rounds;
    if (is_last && !result.is_at_rest)
      break;
    const Phase_timer timer(report.seconds.population);
    const Population_change change =
      adjust_population<Concurrency_tag>(domain, sizing, options, bubbles, simulation, team.population());
    if (!team.any(!change.is_empty()) && result.is_at_rest && !simulation.rest_finely()) {
      report.stop_reason = Bubble_stop_reason::CONVERGED;
      break;
    }
    if (is_last)
      break; // what is inserted now would not be relaxed
    simulation.apply(change);
    report.number_of_insertions += change.inserted.size();
    report.number_of_deletions += count_ours(bubbles, change.deleted);
    team.end_round(simulation, bubbles, report);
  }
  report.converged = report.stop_reason == Bubble_stop_reason::CONVERGED;
}

/// The whole method without the triangulation: initial bubbles, simulation, population.
template <class Concurrency_tag, class Cdt, class Sizing, class Report>
Bubbles_2 simulate_bubbles(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                           const Relaxation_options& options, Progress& progress, Report& report)
{
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    bubbles = place_bubbles<Concurrency_tag>(cdt, reading, sizing, options);
    report.number_of_initial_bubbles = bubbles.size();
  }
  Simulation_alone alone;
  if (options.integrator == Bubble_integrator::RUNGE_KUTTA_4)
    relax<Concurrency_tag, Runge_kutta_4<Concurrency_tag>>(reading.domain, sizing, options, bubbles, alone,
                                                           progress, report);
  else
    relax<Concurrency_tag, Semi_implicit_euler<Concurrency_tag>>(reading.domain, sizing, options,
                                                                 bubbles, alone, progress, report);
  bubbles.forget_gone();
  remove_coincident(reading.domain, bubbles);
  return bubbles;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_RELAXATION_RELAX_BUBBLES_H
