// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_SIMPLIFIED_COAST_H
#define BUBBLE_RELAXATION_2_BENCHMARK_SIMPLIFIED_COAST_H

#include "coast.h"

#include <CGAL/simplify_outline_2.h>

/// d of a coast, which is the same everywhere
inline double wanted_length(const paper::Domain& coast) { return coast.d(paper::Point(0, 0)); }

inline void simplify(const paper::Domain& coast, paper::CDT& cdt)
{
  const double d = wanted_length(coast);
  CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(d).relative_outline_tolerance(0.1));
}

/// \param gap in units of d
inline void simplify_by_rules(const paper::Domain& coast, paper::CDT& cdt, double gap = 1)
{
  const double d = wanted_length(coast);
  CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(d)
                                  .relative_outline_tolerance(0.1)
                                  .minimum_island_area(d * d / 2)
                                  .minimum_gap(gap * d));
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_SIMPLIFIED_COAST_H
