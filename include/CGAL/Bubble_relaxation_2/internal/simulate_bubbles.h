// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/expected_number_of_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/relax.h>
#include <CGAL/Bubble_relaxation_2/internal/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/with_sizing_field.h>

#include <CGAL/Bubble_relaxation_parameters.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H
