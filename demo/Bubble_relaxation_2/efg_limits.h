// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_LIMITS_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_LIMITS_H

#include "efg_node_sets.h"

#include <CGAL/Influence_domain_2.h>
#include <CGAL/Moving_least_squares_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>

namespace efg {

/// What a limit of the condition number lets pass.
struct Limit_effect
{
  std::size_t over_the_limit = 0;
  double largest_sum = 0; ///< of the magnitudes of shape functions, at the other points
};

/// adds a grid of points in the unit square, among nodes with the paper's radius
inline void add_points(const Nodes& nodes, double limit, int on_a_side, Limit_effect& effect)
{
  using Influence = CGAL::Influence_domain_2<paper::K>;
  using Moving_least_squares = CGAL::Moving_least_squares_2<paper::K>;
  const Influence influence(nodes, 0.15);
  const Moving_least_squares mls(influence, CGAL::parameters::maximum_condition_number(limit));
  Moving_least_squares::Shape_functions shapes;
  for (int i = 0; i < on_a_side; ++i)
    for (int j = 0; j < on_a_side; ++j) {
      mls(Point((i + 0.5) / on_a_side, (j + 0.5) / on_a_side), 0, shapes);
      if (shapes.enlargement > 1) {
        ++effect.over_the_limit;
        continue;
      }
      double sum = 0;
      for (double value : shapes.values)
        sum += std::abs(value);
      effect.largest_sum = (std::max)(effect.largest_sum, sum);
    }
}

/// where the limit of the condition number belongs: twice as many sets of random nodes as asked for
inline void show_limits(std::size_t seeds)
{
  constexpr int on_a_side = 24;
  const std::size_t sets = 2 * seeds, points = sets * on_a_side * on_a_side;
  std::cout << "\nLimits of the condition number: " << sets << " sets of 144 random nodes, radius 0.15, linear basis\n"
            << "  limit  points over it  largest sum of |shape functions| at the others of " << points << " points\n";
  for (double limit : {1e3, 1e4, 1e6, 1e8}) {
    Limit_effect effect;
    for (std::uint64_t seed = 0; seed < sets; ++seed)
      add_points(random_nodes(seed, 144), limit, on_a_side, effect);
    std::cout << std::right << std::setw(7) << limit << std::setw(14) << std::fixed << std::setprecision(2)
              << 100. * static_cast<double>(effect.over_the_limit) / static_cast<double>(points) << " %"
              << std::setw(12) << std::setprecision(0) << effect.largest_sum << std::endl
              << std::defaultfloat << std::setprecision(6);
  }
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_LIMITS_H
