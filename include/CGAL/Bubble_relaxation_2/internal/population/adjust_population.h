// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_ADJUST_POPULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_ADJUST_POPULATION_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Delaunay_population.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Overlap_population.h>

#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// How the bubbles' number should change, by the rule the user chose. `touched`: those that may have moved since it was
/// asked last; `step`: what is to be done now, which the paper's rule does not ask
inline Population_change adjust_population(const Problem_2& p, const Bubbles_2& bubbles,
                                           const Neighbor_sets_2& neighbors, const std::vector<Index>& touched,
                                           Population_step step, Team& team)
{
  switch (p.options.population) {
  case Bubble_population::OVERLAP_RATIO:
    return Overlap_population(p.domain, p.sizes, team)(bubbles);
  case Bubble_population::DELAUNAY:
    return Delaunay_population(p.domain, p.sizes, team, p.options.threads)(bubbles, neighbors, touched, step);
  default:
    return Population_change();
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_ADJUST_POPULATION_H
