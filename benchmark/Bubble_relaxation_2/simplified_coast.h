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

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

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

/// The coasts of a folder that are asked for: those of one resolution, or of all that are there; all if none is.
/// \param size d in kilometres
inline std::vector<paper::Domain> read_coasts(const std::string& folder, double size,
                                              const std::vector<std::string>& names)
{
  std::vector<paper::Domain> coasts;
  for (const Region& region : read_regions(folder + "/coasts.txt"))
    for (const char* resolution : {"low", "intermediate", "high"}) {
      const std::string name = region.name + '_' + resolution;
      const auto is_asked_for = [&](const std::string& n) { return n == name || n == region.name; };
      if (!names.empty() && std::none_of(names.begin(), names.end(), is_asked_for))
        continue;
      std::ifstream in(folder + '/' + name + ".txt");
      if (!in)
        continue;
      coasts.push_back({0, name, Coast(region, in).outlines(), [size](const paper::Point&) { return size; }, 0, 0});
    }
  if (coasts.empty())
    throw std::runtime_error(folder + ": has none of the coasts");
  return coasts;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_SIMPLIFIED_COAST_H
