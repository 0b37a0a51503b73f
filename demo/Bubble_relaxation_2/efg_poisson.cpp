// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What nodes are worth to the element-free Galerkin method: section 3.1 of the paper with its table of errors, what
// its settings cost, how errors fall, and other nodes of equal number beside bubbles.

#include "efg_convergence.h"
#include "efg_equal_nodes.h"
#include "efg_table.h"
#include "svg_picture.h"

#include <CGAL/Influence_domain_2.h>
#include <CGAL/Moving_least_squares_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Figure 17 of the paper: the node sets of its table
void draw_figure_17()
{
  Svg_picture picture;
  for (std::size_t steps : {0, 250, 500, 1000}) {
    const efg::Nodes nodes = efg::paper_nodes(1000, efg::large_then_less(steps));
    efg::CDT cdt = paper::triangulate({efg::square_outline()});
    cdt.insert(nodes.points.begin(), nodes.points.end());
    picture.add_nodes(cdt, steps == 0 ? "at random" : "after " + std::to_string(steps) + " steps");
  }
  picture.write("figure_17.svg");
}

/// other nodes of the same number beside the vertices of a mesh, with the same radius and the same cells of integration
void show_equal_nodes(const std::string& domain, const std::vector<paper::Outline>& outlines, const efg::CDT& mesh,
                      std::size_t seeds)
{
  const efg::Nodes bubbles = CGAL::node_set_2(mesh);
  const double distance = efg::median(bubbles.sizes);
  const efg::Equal_nodes equal(outlines, bubbles, distance);
  const auto np = CGAL::parameters::support_radius(2.5 * distance);
  efg::print_header(std::to_string(bubbles.size()) + " nodes of " + domain +
                    ", radius 2.5 times their distance, else the defaults");
  const auto show = [&](const std::string& name, std::size_t number, const efg::Make_nodes& nodes) {
    efg::Error_sample errors;
    for (std::uint64_t seed = 0; seed < number; ++seed)
      errors.add(efg::solve(mesh, nodes(seed), np));
    efg::print_row(std::cout, name, errors, efg::how_many_have_holes(errors));
  };
  show("bubbles", 1, [&](std::uint64_t) { return bubbles; });
  show("a grid, and the bubbles on the boundary", 1, [&](std::uint64_t) { return equal.grid(); });
  show("a grid alone", 1, [&](std::uint64_t) { return equal.bare_grid(); });
  show("Halton, and the bubbles on the boundary", 1, [&](std::uint64_t) { return equal.halton(); });
  show("random, and the bubbles on the boundary", seeds, [&](std::uint64_t seed) { return equal.random(seed); });
}

void show_equal_nodes(std::size_t seeds)
{
  for (int on_a_side : {12, 24}) {
    const auto n = static_cast<std::size_t>(on_a_side * on_a_side);
    show_equal_nodes("the square", {efg::square_outline()}, efg::square_mesh(n), seeds);
  }
  const paper::Domain trunk = paper::trunk(1);
  efg::CDT mesh = paper::triangulate(trunk);
  CGAL::npbs_relax(mesh, CGAL::parameters::sizing_function(0.04));
  show_equal_nodes("the trunk of Fig. 9", trunk.outlines, mesh, seeds);
}

/// What a limit of the condition number lets pass.
struct Limit_effect
{
  std::size_t over_the_limit = 0;
  double largest_sum = 0; ///< of the magnitudes of shape functions, at the other points
};

/// adds a grid of points in the unit square, among nodes with the paper's radius
void add_points(const efg::Nodes& nodes, double limit, int on_a_side, Limit_effect& effect)
{
  using Influence = CGAL::Influence_domain_2<paper::K>;
  using Moving_least_squares = CGAL::Moving_least_squares_2<paper::K>;
  const Influence influence(nodes, 0.15);
  const Moving_least_squares mls(influence, CGAL::parameters::maximum_condition_number(limit));
  Moving_least_squares::Shape_functions shapes;
  for (int i = 0; i < on_a_side; ++i)
    for (int j = 0; j < on_a_side; ++j) {
      mls(paper::Point((i + 0.5) / on_a_side, (j + 0.5) / on_a_side), 0, shapes);
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
void show_limits(std::size_t seeds)
{
  constexpr int on_a_side = 24;
  const std::size_t sets = 2 * seeds, points = sets * on_a_side * on_a_side;
  std::cout << "\nLimits of the condition number: " << sets << " sets of 144 random nodes, radius 0.15, linear basis\n"
            << "  limit  points over it  largest sum of |shape functions| at the others of " << points << " points\n";
  for (double limit : {1e3, 1e4, 1e6, 1e8}) {
    Limit_effect effect;
    for (std::uint64_t seed = 0; seed < sets; ++seed)
      add_points(efg::random_nodes(seed, 144), limit, on_a_side, effect);
    std::cout << std::right << std::setw(7) << limit << std::setw(14) << std::fixed << std::setprecision(2)
              << 100. * static_cast<double>(effect.over_the_limit) / static_cast<double>(points) << " %"
              << std::setw(12) << std::setprecision(0) << effect.largest_sum << std::endl
              << std::defaultfloat << std::setprecision(6);
  }
}

using Parts = std::map<std::string, std::function<void(std::size_t seeds)>>;

Parts all_parts()
{
  return {{"table", efg::show_table_1},
          {"random", efg::show_row_a},
          {"settings", efg::show_settings},
          {"others", efg::show_other_seeds},
          {"limits", show_limits},
          {"equal", [](std::size_t seeds) { show_equal_nodes(seeds); }},
          {"convergence", [](std::size_t) { efg::show_convergence(4); }},
          {"pictures", [](std::size_t) { draw_figure_17(); }}};
}

/// \throws std::invalid_argument with one line for the user
std::set<std::string> read_parts(const std::string& list, const Parts& parts)
{
  std::set<std::string> chosen;
  std::istringstream in(list);
  for (std::string name; std::getline(in, name, ',');) {
    if (parts.count(name) == 0)
      throw std::invalid_argument("there is no part '" + name +
                                  "', only table, random, limits, settings, others, equal, convergence and pictures");
    chosen.insert(name);
  }
  return chosen;
}

std::size_t read_number(const std::string& text)
{
  std::size_t number = 0;
  std::istringstream in(text);
  if (text.find('-') != std::string::npos || !(in >> number) || !in.eof() || number == 0)
    throw std::invalid_argument("--seeds needs a positive number, not '" + text + "'");
  return number;
}

} // namespace

int main(int argc, char** argv)
try {
  const Parts parts = all_parts();
  std::set<std::string> chosen;
  std::size_t seeds = 20;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--seeds" && i + 1 < argc)
      seeds = read_number(argv[++i]);
    else if (argument == "--parts" && i + 1 < argc)
      chosen = read_parts(argv[++i], parts);
    else
      throw std::invalid_argument("usage: efg_poisson [--seeds 20] [--parts table,settings]");
  }
  std::cout << "-Laplace(u) = -(x^2 + y^2) e^(xy), u = e^(xy): medians of " << seeds << " seeds [least .. largest]\n";
  for (const char* name : {"table", "random", "limits", "settings", "others", "equal", "convergence", "pictures"})
    if (chosen.empty() || chosen.count(name) > 0)
      parts.at(name)(seeds);
} catch (const std::exception& e) {
  std::cerr << "efg_poisson: " << e.what() << '\n';
  return 1;
}
