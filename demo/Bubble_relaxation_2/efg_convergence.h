// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_CONVERGENCE_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_CONVERGENCE_H

#include "efg_errors.h"
#include "log_log_plot.h"

#include <CGAL/node_set_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>

namespace efg {

/// The errors of one method on finer and finer meshes of the square.
struct Convergence
{
  std::string name;
  Log_log_plot::Points l2, h1; ///< over d
};

/// how fast values fall from the first to the last point: y ~ x^order
inline double order(const std::pair<double, double>& coarse, const std::pair<double, double>& fine)
{
  return std::log(coarse.second / fine.second) / std::log(coarse.first / fine.first);
}

/// relaxes a mesh with the defaults, for d, d/2, d/4 and so on, and solves with its vertices as nodes
template <class NamedParameters>
Convergence converge(const std::string& name, double d, int levels, const NamedParameters& np)
{
  Convergence result{name, {}, {}};
  std::cout << name << '\n';
  for (int level = 0; level < levels; ++level, d /= 2) {
    CDT mesh = paper::triangulate({square_outline()});
    CGAL::npbs_relax(mesh, CGAL::parameters::sizing_function(d));
    const Nodes nodes = CGAL::node_set_2(mesh);
    const Errors errors = solve(mesh, nodes, np);
    result.l2.emplace_back(d, errors.l2);
    result.h1.emplace_back(d, errors.h1);
    std::cout << std::right << std::setw(10) << d << std::setw(8) << nodes.size() << "  " << in_short(errors.l2);
    std::cout << std::fixed << std::setprecision(2);
    const auto print_order = [level](const Log_log_plot::Points& points) {
      if (level == 0)
        std::cout << std::setw(7) << "";
      else
        std::cout << std::setw(7) << order(points[points.size() - 2], points.back());
    };
    print_order(result.l2);
    std::cout << "   " << in_short(errors.h1);
    if (level > 0)
      print_order(result.h1);
    std::cout << std::endl << std::defaultfloat << std::setprecision(6);
  }
  const auto whole = [](const Log_log_plot::Points& points) { return order(points.front(), points.back()); };
  std::cout << std::fixed << std::setprecision(2) << std::setw(20) << "all" << std::setw(17) << whole(result.l2)
            << std::setw(18) << whole(result.h1) << std::endl << std::defaultfloat << std::setprecision(6);
  return result;
}

inline void show_convergence(int levels)
{
  using CGAL::Moving_least_squares_basis;
  constexpr double d = 0.1;
  std::cout << "\nConvergence: nodes are the vertices of a mesh that npbs_relax() makes of the square, by default\n"
            << std::right << std::setw(10) << "d" << std::setw(8) << "nodes" << "  in L2    order   in H1    order\n";
  const Convergence linear = converge("linear basis, defaults", d, levels, CGAL::parameters::default_values());
  const Convergence quadratic = converge("quadratic basis, defaults", d, levels,
                                         CGAL::parameters::mls_basis(Moving_least_squares_basis::QUADRATIC));
  for (bool is_quadratic : {false, true})
    converge(is_quadratic ? "quadratic basis, no correction" : "linear basis, no correction", d, levels,
             CGAL::parameters::mls_basis(is_quadratic ? Moving_least_squares_basis::QUADRATIC
                                                      : Moving_least_squares_basis::LINEAR)
               .consistent_integration(false));
  // as near to the paper as triangles allow; its radius in units of the distance on a grid of 144 nodes
  const Convergence paper = converge("linear, 1.65 d, 2 x 2 points, no correction", d, levels,
                                     CGAL::parameters::support_factor(1.65).number_of_gauss_points(2)
                                       .consistent_integration(false));
  Log_log_plot plot("Element-free Galerkin method: error over d");
  const auto show = [&](const std::string& norm, Log_log_plot::Points Convergence::*errors, double lower_order) {
    plot.start_panel("error in " + norm, "d", "error");
    for (const Convergence* c : {&linear, &quadratic, &paper})
      plot.add_series(c->name, c->*errors);
    const auto add_slope = [&](const Log_log_plot::Points& p, double order) {
      if (p.size() > 2)
        plot.add_slope(order, p[p.size() - 3], p[p.size() - 2]);
    };
    add_slope(linear.*errors, lower_order);
    add_slope(quadratic.*errors, lower_order + 1);
  };
  show("L2", &Convergence::l2, 2);
  show("H1", &Convergence::h1, 1);
  plot.write("efg_convergence.svg");
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_CONVERGENCE_H
