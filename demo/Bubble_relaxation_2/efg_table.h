// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_TABLE_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_TABLE_H

#include "efg_errors.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace efg {

/// the errors of row d of the paper's table
constexpr Errors row_d{0.000378625, 0.014812266, 0};

/// The paper's settings, but for the number of Gauss points and the penalty factor, which it does not tell.
inline auto paper_settings(double penalty_factor = 1e4, int gauss_points = 2)
{
  return CGAL::parameters::support_radius(0.15)
    .mls_basis(CGAL::Moving_least_squares_basis::LINEAR)
    .mls_weight(CGAL::Moving_least_squares_weight::QUARTIC_SPLINE)
    .integration_cells(CGAL::Integration_cells::GRID)
    .grid_cells(12)
    .number_of_gauss_points(gauss_points)
    .consistent_integration(false)
    .dirichlet_condition(CGAL::Dirichlet_condition::PENALTY)
    .penalty_factor(penalty_factor);
}

/// the nodes of a seed
using Make_nodes = std::function<Nodes(std::uint64_t)>;

inline Make_nodes simulated(std::vector<Stage> (*stages)(std::size_t), std::size_t steps)
{
  return [stages, steps](std::uint64_t seed) { return paper_nodes(seed, stages(steps)); };
}

inline Make_nodes all_random()
{
  return [](std::uint64_t seed) { return random_nodes(seed, 144); };
}

/// the square as a domain only, or with the triangles of the nodes, over which the defaults integrate
enum class Domain { BARE, MESH };

/// of the sets on which the simulation's settings were chosen, and of others
constexpr std::uint64_t first_seed = 1000, first_other_seed = 5000;

/// the errors with the nodes of so many seeds, on the square
template <class NamedParameters>
Error_sample sample(std::size_t seeds, const Make_nodes& make_nodes, Domain domain, const NamedParameters& np)
{
  Error_sample errors;
  for (std::uint64_t k = 0; k < seeds; ++k) {
    const Nodes nodes = make_nodes(first_seed + k);
    CDT square = paper::triangulate({square_outline()});
    if (domain == Domain::MESH)
      square.insert(nodes.points.begin(), nodes.points.end());
    errors.add(solve(square, nodes, np));
  }
  return errors;
}

/// the same with the paper's grid of cells
template <class NamedParameters>
Error_sample sample(std::size_t seeds, const Make_nodes& make_nodes, const NamedParameters& np)
{
  return sample(seeds, make_nodes, Domain::BARE, np);
}

inline void print_header(const std::string& title)
{
  std::cout << '\n' << title << '\n' << std::left << std::setw(42) << "" << std::setw(33) << "error in L2"
            << "error in H1\n";
}

inline void print_paper_row(const std::string& name, double l2, double h1)
{
  Error_sample paper;
  paper.add(Errors{l2, h1, 0});
  print_row(std::cout, name, paper);
}

inline std::string how_many_beat_the_paper(const Error_sample& errors)
{
  return std::to_string(errors.better_than(row_d)) + " of " + std::to_string(errors.size()) + " below d of the paper";
}

inline std::string how_many_have_holes(const Error_sample& errors)
{
  return errors.with_enlarged() == 0 ? ""
                                     : std::to_string(errors.with_enlarged()) + " of " + std::to_string(errors.size()) +
                                         " with enlarged supports";
}

inline void show_table_1(std::size_t seeds)
{
  struct Row { const char* name; std::size_t steps; double l2, h1; };
  const Row rows[] = {{"a: random", 0, 0.390010815, 2.933037054},
                      {"b: 250 steps", 250, 0.004286155, 0.041298026},
                      {"c: 500 steps", 500, 0.000408937, 0.016183909},
                      {"d: 1000 steps", 1000, row_d.l2, row_d.h1}};
  print_header("Table 1 of the paper: 144 nodes, linear basis, radius 0.15, 12 x 12 cells, 2 x 2 points, penalty 1e4");
  const auto show = [&](const char* name, const Make_nodes& nodes) {
    const Error_sample errors = sample(seeds, nodes, paper_settings());
    print_row(std::cout, name, errors, how_many_have_holes(errors));
  };
  for (const Row& row : rows) {
    print_paper_row(std::string(row.name) + ", the paper", row.l2, row.h1);
    if (row.steps == 0) {
      show("   too small supports enlarged", simulated(constant_size, 0));
      continue;
    }
    show("   d 1.12 times the natural distance", simulated(constant_size, row.steps));
    show("   d 1.25 times, after 250 steps 1.08", simulated(large_then_less, row.steps));
  }
  const auto grid = [](std::uint64_t) { return grid_nodes(12); };
  print_row(std::cout, "a grid of 12 x 12 nodes", sample(1, grid, paper_settings()));
}

/// where the paper's row a comes from
inline void show_row_a(std::size_t seeds)
{
  using CGAL::Deficient_support;
  print_header("Row a: what becomes of points with too few nodes around, where the moment matrix is singular");
  print_paper_row("the paper", 0.390010815, 2.933037054);
  const Make_nodes inside = simulated(constant_size, 0);
  const auto enlarge = paper_settings().deficient_support(Deficient_support::ENLARGE);
  const auto pseudo_inverse = paper_settings().deficient_support(Deficient_support::PSEUDO_INVERSE);
  print_row(std::cout, "44 on the boundary: enlarged", sample(seeds, inside, enlarge));
  print_row(std::cout, "44 on the boundary: pseudo-inverse", sample(seeds, inside, pseudo_inverse));
  print_row(std::cout, "all 144 random: enlarged", sample(seeds, all_random(), enlarge));
  print_row(std::cout, "all 144 random: pseudo-inverse", sample(seeds, all_random(), pseudo_inverse));
}

/// what limits the paper's row d, and what better settings give with the same nodes
inline void show_settings(std::size_t seeds)
{
  using CGAL::parameters::support_radius;
  const Make_nodes nodes = simulated(large_then_less, 1000);
  const auto show = [&](const std::string& name, Domain domain, const auto& np) {
    const Error_sample errors = sample(seeds, nodes, domain, np);
    print_row(std::cout, name, errors, how_many_beat_the_paper(errors));
  };
  print_header("Row d: other settings, the same nodes (d 1.25 times, after 250 steps 1.08)");
  print_paper_row("the paper", row_d.l2, row_d.h1);
  for (double penalty : {1e2, 1e3, 1e4, 1e5, 1e6})
    show("penalty 1e" + std::to_string(std::lround(std::log10(penalty))), Domain::BARE, paper_settings(penalty));
  show("3 x 3 Gauss points, else the paper's", Domain::BARE, paper_settings(1e4, 3));
  show("4 x 4 Gauss points, else the paper's", Domain::BARE, paper_settings(1e4, 4));
  show("2 x 2, consistent integration", Domain::BARE, paper_settings().consistent_integration(true));
  show("2 x 2, consistent integration, Nitsche", Domain::BARE,
       paper_settings().consistent_integration(true).dirichlet_condition(CGAL::Dirichlet_condition::NITSCHE));
  show("the package's, but for the radius", Domain::MESH, support_radius(0.15));
  show("the package's", Domain::MESH, CGAL::parameters::default_values());
  show("the package's, quadratic basis", Domain::MESH,
       CGAL::parameters::mls_basis(CGAL::Moving_least_squares_basis::QUADRATIC));
  for (int factor : {3, 5, 20, 50})
    show("the package's, Nitsche's factor " + std::to_string(factor), Domain::MESH,
         CGAL::parameters::nitsche_factor(factor));
  const auto grid = [](std::uint64_t) { return grid_nodes(12); };
  print_row(std::cout, "a grid: 3 x 3, else the paper's", sample(1, grid, paper_settings(1e4, 3)));
  print_row(std::cout, "a grid: the package's", sample(1, grid, Domain::MESH, CGAL::parameters::default_values()));
}

/// row d with twice as many sets of nodes on which nothing was chosen: how sure is what it tells?
inline void show_other_seeds(std::size_t seeds)
{
  const Make_nodes chosen_on = simulated(large_then_less, 1000);
  const Make_nodes nodes = [&](std::uint64_t seed) { return chosen_on(seed - first_seed + first_other_seed); };
  const auto show = [&](const std::string& name, Domain domain, const auto& np) {
    const Error_sample errors = sample(2 * seeds, nodes, domain, np);
    print_row(std::cout, name, errors, how_many_beat_the_paper(errors));
  };
  print_header("Row d: " + std::to_string(2 * seeds) + " other sets of nodes, on which nothing was chosen");
  show("the paper's settings", Domain::BARE, paper_settings());
  show("3 x 3 Gauss points, else the paper's", Domain::BARE, paper_settings(1e4, 3));
  show("the package's", Domain::MESH, CGAL::parameters::default_values());
  show("the package's, quadratic basis", Domain::MESH,
       CGAL::parameters::mls_basis(CGAL::Moving_least_squares_basis::QUADRATIC));
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_TABLE_H
