// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Adaptive solution: Laplace's equation on a domain with an inner corner. Solve, estimate the error, make the next d
// from it, relax the mesh that is there, and so on: the error falls as fast as on domains without such a corner, by
// linear finite elements on the mesh and by the element-free Galerkin method on its nodes. With the same d everywhere
// it does not. With --tolerance the loop of finite elements alone runs, until the estimated error is no more than that.

#include "adaptive_solution.h"
#include "corner_singularity.h"
#include "corner_solvers.h"
#include "log_log_plot.h"
#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using paper::CDT;
using Exact = Corner_singularity<paper::K>;
using Steps = std::vector<Adaptive_step>;
using Solver = std::function<Solved(const CDT&, const Triangle_arrays<CDT>&)>;
using Look = std::function<void(const CDT&, const Adaptive_step&)>;

constexpr std::size_t steps_of_rates = 5; ///< the last ones, over which rates are told

struct Arguments
{
  double nodes = 130000, efg_nodes = 33000, tolerance = 0;
};

Arguments read_arguments(int argc, char** argv)
{
  Arguments result;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    double* const value = name == "--nodes"       ? &result.nodes
                          : name == "--efg-nodes" ? &result.efg_nodes
                          : name == "--tolerance" ? &result.tolerance
                                                  : nullptr;
    char* end = nullptr;
    if (value != nullptr && i + 1 < argc)
      *value = std::strtod(argv[i + 1], &end);
    if (end == nullptr || end == argv[i + 1] || *end != '\0' || !(*value > 0 && std::isfinite(*value)))
      throw std::invalid_argument("usage: adaptive_poisson [--nodes N] [--efg-nodes N] [--tolerance T], all positive");
  }
  return result;
}

void print_head(const std::string& title)
{
  std::cout << '\n' << title << "\n   nodes  smallest d        L2   rate        H1   rate  estimate  mean q  min q"
            << "  relaxing/solving\n";
}

/// an error, and the power of the number of nodes by which it fell since the step before
void print_error(double error, double rate)
{
  std::cout << std::setw(10) << std::scientific << std::setprecision(2) << error << std::fixed << std::setw(7);
  if (std::isfinite(rate))
    std::cout << rate;
  else
    std::cout << ' ';
}

void print_step(const Adaptive_step& s, const Adaptive_step& before)
{
  const double growth = std::log(double(s.nodes) / double(before.nodes)); // 0 in the first step: no rate
  std::cout << std::setw(8) << s.nodes << std::setw(12) << std::scientific << std::setprecision(1) << s.smallest_size;
  print_error(s.error.l2, std::log(s.error.l2 / before.error.l2) / growth);
  print_error(s.error.h1, std::log(s.error.h1 / before.error.h1) / growth);
  std::cout << std::setw(10) << std::scientific << std::setprecision(2) << s.estimate << std::fixed
            << std::setprecision(3) << std::setw(8) << s.mean_quality << std::setw(7) << s.minimum_quality
            << std::setprecision(2) << std::setw(18) << s.relaxing / s.solving << std::endl;
}

double l2(const Adaptive_step& s) { return s.error.l2; }
double h1(const Adaptive_step& s) { return s.error.h1; }

Steps study(const std::string& title, Refinement refinement, const Arguments& arguments, double most_nodes,
            const Solver& solver, const Look& look)
{
  CDT cdt = paper::triangulate({Exact::outline()});
  Adaptive_options options;
  options.refinement = refinement;
  options.most_nodes = most_nodes;
  options.tolerance = arguments.tolerance;
  print_head(title);
  Adaptive_step before;
  const Steps steps = Adaptive_solution<CDT>(cdt, options)(solver, [&](const CDT& mesh, const Adaptive_step& step) {
    print_step(step, before.nodes == 0 ? step : before);
    before = step;
    look(mesh, step);
  });
  if (steps.size() > 1)
    std::cout << "rates of the last " << (std::min)(steps.size(), steps_of_rates) << " meshes: L2 "
              << std::setprecision(2) << observed_rate(steps, steps_of_rates, l2) << ", H1 "
              << observed_rate(steps, steps_of_rates, h1) << '\n';
  return steps;
}

/// Pictures of each mesh, whole or as much around the corner as has about 10 000 nodes, and the corner itself. In a
/// square of half the side a around the corner there are about a^(2/3) of all nodes.
class Mesh_pictures
{
public:
  void operator()(const CDT& mesh, const Adaptive_step& step)
  {
    Svg_picture picture;
    add(picture, mesh, step, 10000);
    add(picture, mesh, step, 500);
    picture.write("adaptive_poisson_mesh_" + std::to_string(m_number) + ".svg");
    if (m_number == 0 || m_number == 2 || m_number == 4)
      add(m_overview, mesh, step, 10000);
    if (m_number == 4)
      add(m_overview, mesh, step, 500);
    ++m_number;
  }

  void write() const { m_overview.write("adaptive_poisson_meshes.svg"); }

private:
  static void add(Svg_picture& picture, const CDT& mesh, const Adaptive_step& step, double nodes)
  {
    const double a = std::pow((std::min)(1., nodes / double(step.nodes)), 1.5);
    std::ostringstream caption;
    caption << step.nodes << " nodes, a square with sides of " << std::setprecision(2) << 2 * a;
    picture.add_part_of_mesh(mesh, CGAL::Bbox_2(-a, -a, a, a), caption.str());
  }

  Svg_picture m_overview;
  int m_number = 0;
};

Log_log_plot::Points points(const Steps& steps, double (*error)(const Adaptive_step&))
{
  Log_log_plot::Points result;
  for (const Adaptive_step& s : steps)
    result.emplace_back(double(s.nodes), error(s));
  return result;
}

struct Study { std::string name; Steps steps; };

void plot(const std::vector<Study>& studies)
{
  Log_log_plot picture("Laplace's equation, u = r^(2/3) sin(2 theta / 3)");
  for (bool is_l2 : {true, false}) {
    picture.start_panel(is_l2 ? "error of values, L2" : "error of the gradient, H1", "nodes", "error");
    for (const Study& s : studies)
      picture.add_series(s.name, points(s.steps, is_l2 ? l2 : h1));
    for (int k : {0, 1}) { // uniform, adapted
      const auto line = points(studies[k].steps, is_l2 ? l2 : h1);
      const double order = k == 0 ? (is_l2 ? -0.67 : -0.33) : (is_l2 ? -1 : -0.5);
      picture.add_slope(order, line[line.size() / 2], line.back(), k == 0 ? 0.6 : 2.5);
    }
  }
  picture.write("adaptive_poisson.svg");
}

int main(int argc, char** argv)
try {
  const Arguments arguments = read_arguments(argc, argv);
  const Look no_look = [](const CDT&, const Adaptive_step&) {};
  Mesh_pictures pictures;
  const auto adapted = [&] {
    return study("finite elements, equal errors of the gradient", Refinement::EQUAL_GRADIENT, arguments,
                 arguments.nodes, &by_finite_elements<CDT>, std::ref(pictures));
  };
  if (arguments.tolerance > 0) {
    adapted();
    return EXIT_SUCCESS;
  }
  std::vector<Study> studies;
  studies.push_back({"finite elements, uniform", study("finite elements, d the same everywhere", Refinement::UNIFORM,
                                                       arguments, arguments.nodes, &by_finite_elements<CDT>, no_look)});
  studies.push_back({"finite elements, adapted", adapted()});
  pictures.write();
  study("finite elements, equal errors of the values", Refinement::EQUAL_VALUE, arguments, arguments.nodes,
        &by_finite_elements<CDT>, no_look);
  using Basis = CGAL::Moving_least_squares_basis;
  studies.push_back({"element-free Galerkin, uniform",
                     study("element-free Galerkin, d the same everywhere", Refinement::UNIFORM, arguments,
                           arguments.efg_nodes, &by_element_free_galerkin<Basis::LINEAR, CDT>, no_look)});
  studies.push_back({"element-free Galerkin, adapted",
                     study("element-free Galerkin, equal errors of the gradient", Refinement::EQUAL_GRADIENT,
                           arguments, arguments.efg_nodes, &by_element_free_galerkin<Basis::LINEAR, CDT>, no_look)});
  studies.push_back({"the same with a quadratic basis",
                     study("element-free Galerkin with a quadratic basis, equal errors of the gradient",
                           Refinement::EQUAL_GRADIENT, arguments, arguments.efg_nodes,
                           &by_element_free_galerkin<Basis::QUADRATIC, CDT>, no_look)});
  plot(studies);
} catch (const std::exception& e) {
  std::cerr << "adaptive_poisson: " << e.what() << '\n';
  return EXIT_FAILURE;
}
