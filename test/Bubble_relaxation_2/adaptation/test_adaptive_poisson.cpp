// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Relaxation in a loop with a solver: sizes from the estimated error of the last solution, on an existing mesh.

#include "../../../demo/Bubble_relaxation_2/adaptive_cycles.h"
#include "../../../demo/Bubble_relaxation_2/adaptive_solution.h"
#include "../../../demo/Bubble_relaxation_2/corner_singularity.h"
#include "../../../demo/Bubble_relaxation_2/corner_solvers.h"
#include "../../../demo/Bubble_relaxation_2/paper_domains.h"
#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_adaptive_poisson {

using domains::CDT;
using domains::K;
using domains::Point;
using Mesh = Triangle_arrays<CDT>;
using Exact = Corner_singularity<K>;
using Steps = std::vector<Adaptive_step>;

struct Problem
{
  std::function<double(const Point&)> source, dirichlet;
};

CDT l_shape() { return paper::triangulate({Exact::outline()}); }

Solved solve_corner(const CDT&, const Mesh& mesh)
{
  Problem problem;
  problem.dirichlet = &Exact::value;
  const Eigen::VectorXd u = solve_by_linear_elements(mesh, problem);
  return Solved{u, [&mesh, u] { return error_of_linear_elements<Exact>(mesh, u); }};
}

template <class Look>
Steps solve_corner(const Adaptive_options& options, const Look& look)
{
  CDT cdt = l_shape();
  return Adaptive_solution<CDT>(cdt, options)([](const CDT& c, const Mesh& m) { return solve_corner(c, m); }, look);
}

double l2(const Adaptive_step& s) { return s.error.l2; }
double h1(const Adaptive_step& s) { return s.error.h1; }

TEST(Linear_finite_elements, reproduce_linear_solutions)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.1);
  const Mesh mesh(cdt);
  Problem problem;
  problem.dirichlet = [](const Point& p) { return 1 + 2 * p.x() - 3 * p.y(); };
  const Eigen::VectorXd u = solve_by_linear_elements(mesh, problem);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_NEAR(u[static_cast<Eigen::Index>(v)], problem.dirichlet(mesh.points[v]), 1e-13);
  EXPECT_LT(Error_estimate<CDT>(mesh, u).total(), 1e-12);
}

TEST(Linear_finite_elements, converge_with_a_source)
{
  Problem problem; // u = x (1 - x) y (1 - y)
  problem.dirichlet = [](const Point&) { return 0.; };
  problem.source = [](const Point& p) { return 2 * (p.x() * (1 - p.x()) + p.y() * (1 - p.y())); };
  std::vector<double> errors;
  for (double d : {0.1, 0.05}) {
    const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, d);
    const Mesh mesh(cdt);
    const Eigen::VectorXd u = solve_by_linear_elements(mesh, problem);
    const auto error = integrate_error(mesh, Point(-1, -1), 4, [&](std::size_t t, const Point& p, const auto& bary) {
      const Eigen::Vector2d g = mesh.hat_gradients(t) * mesh.values(t, u);
      return Eigen::Vector3d(bary.dot(mesh.values(t, u)) - p.x() * (1 - p.x()) * p.y() * (1 - p.y()),
                             g[0] - (1 - 2 * p.x()) * p.y() * (1 - p.y()),
                             g[1] - (1 - 2 * p.y()) * p.x() * (1 - p.x()));
    });
    errors.push_back(error.l2);
    EXPECT_NEAR(Error_estimate<CDT>(mesh, u).total() / error.h1, 1, 0.1) << d;
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
}

TEST(Error_norms, are_exact_at_the_singular_corner)
{
  // The norm of the solution on the square [0, 1]^2, one side of which ends in the corner, in polar coordinates:
  // |grad u|^2 = 4/9 r^(-2/3). By symmetry twice the triangle below the diagonal, where r reaches 1 / cos(theta).
  double expected = 0;
  for (const auto& node : gauss_points(20)) {
    const double theta = node[0] * Exact::pi / 4;
    expected += 2 * node[1] * Exact::pi / 4 * 4. / 9 * std::pow(std::cos(theta), -4. / 3) / (4. / 3);
  }
  const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.4);
  const Mesh mesh(cdt);
  const auto gradient_alone = [](std::size_t, const Point& p, const auto&) {
    const auto g = Exact::gradient(p);
    return Eigen::Vector3d(0, g.x(), g.y());
  };
  const double norm = integrate_error(mesh, Exact::corner(), 6, gradient_alone).h1;
  EXPECT_NEAR(norm * norm, expected, 1e-6 * expected);
  // with plain Gauss points it is not
  const double plain = integrate_error(mesh, Point(-1, -1), 6, gradient_alone).h1;
  EXPECT_GT(std::abs(plain * plain - expected), 1e-5 * expected);
}

TEST(Error_norms, do_not_depend_on_the_number_of_points)
{
  CDT cdt = l_shape();
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1));
  const Mesh mesh(cdt);
  const Eigen::VectorXd u = solve_corner(cdt, mesh).values;
  const Error_norms few = error_of_linear_elements<Exact>(mesh, u, 4);
  const Error_norms many = error_of_linear_elements<Exact>(mesh, u, 12);
  EXPECT_NEAR(few.l2, many.l2, 1e-3 * many.l2);
  EXPECT_NEAR(few.h1, many.h1, 1e-3 * many.h1);
}

TEST(Adaptive_solution, falls_at_the_optimal_rate)
{
  Adaptive_options options;
  options.most_nodes = 16000;
  const validation::Snapshot domain = validation::snapshot(l_shape());
  const Steps adapted = solve_corner(options, [&](const CDT& cdt, const Adaptive_step& step) {
    validation::expect_mesh_of(domain, cdt);
    EXPECT_NEAR(validation::domain_area(cdt), 3, 1e-12);
    EXPECT_GT(step.minimum_quality, 0.75) << step.nodes;
    EXPECT_GT(step.mean_quality, 0.975) << step.nodes;
    EXPECT_NEAR(step.estimate / step.error.h1, 1, step.nodes > 3000 ? 0.05 : 0.4) << step.nodes;
  });
  options.refinement = Refinement::UNIFORM;
  const Steps uniform = solve_corner(options, [](const CDT&, const Adaptive_step&) {});
  ASSERT_GE(adapted.size(), 6u);
  EXPECT_LT(observed_rate(adapted, 3, l2), -0.95);
  EXPECT_LT(observed_rate(adapted, 3, h1), -0.48);
  EXPECT_GT(observed_rate(uniform, 5, l2), -0.75);
  EXPECT_GT(observed_rate(uniform, 5, h1), -0.38);
  EXPECT_LT(adapted.back().error.l2, uniform.back().error.l2 / 20);
  // the number of nodes is what was asked for
  for (std::size_t k = 1; k < adapted.size(); ++k)
    EXPECT_NEAR(double(adapted[k].nodes) / double(adapted[k - 1].nodes), options.growth, 0.15);
  EXPECT_LT(adapted.back().smallest_size, 1e-4); // towards the corner d goes as r^(2/3)
}

TEST(Adaptive_solution, by_the_element_free_galerkin_method)
{
  const auto solve = [](Refinement refinement) {
    Adaptive_options options;
    options.most_nodes = 3600;
    options.refinement = refinement;
    CDT cdt = l_shape();
    return Adaptive_solution<CDT>(cdt, options)(
      &by_element_free_galerkin<CGAL::Moving_least_squares_basis::LINEAR, CDT>,
      [](const CDT&, const Adaptive_step&) {});
  };
  const Steps adapted = solve(Refinement::EQUAL_GRADIENT), uniform = solve(Refinement::UNIFORM);
  ASSERT_GE(adapted.size(), 5u);
  EXPECT_GT(adapted.back().nodes, 3000u);
  EXPECT_LT(observed_rate(adapted, 4, l2), -1.);
  EXPECT_LT(observed_rate(adapted, 4, h1), -1.);
  EXPECT_GT(observed_rate(uniform, 4, h1), -0.6);
  EXPECT_LT(adapted.back().error.l2, uniform.back().error.l2 / 10);
  EXPECT_LT(adapted.back().error.h1, uniform.back().error.h1 / 5);
}

TEST(Adaptive_solution, stops_at_the_tolerance_or_tells_that_it_cannot)
{
  Adaptive_options options;
  options.most_nodes = 4000;
  options.tolerance = 0.03;
  const Steps steps = solve_corner(options, [](const CDT&, const Adaptive_step&) {});
  EXPECT_LE(steps.back().estimate, 0.03);
  EXPECT_GT(steps[steps.size() - 2].estimate, 0.03);
  EXPECT_LT(steps.back().error.h1, 0.03);

  options.tolerance = 1e-3;
  expect_throw<std::runtime_error>([&] { solve_corner(options, [](const CDT&, const Adaptive_step&) {}); },
                                   {"0.001", "4000"});
}

/// Each cycle makes vertices only where the error asks for smaller triangles, all together are hardly more than the
/// last mesh has, and that is as good as one that is made at once.
TEST(Adaptive_cycles, pay_for_what_they_change)
{
  Cycle_options options;
  options.nodes = 15000;
  Adaptive_cycles<CDT> loop(options);
  std::map<CDT::Vertex_handle, Point> points;
  std::vector<Adaptive_cycle> cycles = loop([&](const Adaptive_cycle& cycle) {
    validation::expect_valid_mesh(loop.mesh());
    std::size_t kept = 0;
    for (CDT::Vertex_handle v : loop.mesh().finite_vertex_handles()) {
      const auto found = points.find(v);
      kept += found != points.end() && found->second == v->point();
    }
    EXPECT_GE(kept + cycle.new_vertices, cycle.vertices);
    points.clear();
    for (CDT::Vertex_handle v : loop.mesh().finite_vertex_handles())
      points[v] = v->point();
    EXPECT_GT(cycle.minimum_quality, 0.8);
  });
  ASSERT_GE(cycles.size(), 4u);
  std::size_t all = 0;
  for (const Adaptive_cycle& cycle : cycles)
    all += cycle.new_vertices;
  const Adaptive_cycle last = cycles.back(), once = loop.at_once();
  EXPECT_LT(last.new_vertices, last.vertices / 2);
  EXPECT_LT(double(all), 1.4 * double(last.vertices));
  EXPECT_NEAR(double(last.vertices), options.nodes, 0.25 * options.nodes);
  EXPECT_NEAR(double(last.vertices) / double(once.vertices), 1, 0.03);
  EXPECT_NEAR(last.error.h1 / once.error.h1, 1, 0.03);
  EXPECT_NEAR(last.estimate / last.error.h1, 1, 0.35);
  EXPECT_LT(last.error.h1, cycles.front().error.h1 / 10);
  EXPECT_LT(last.iterations, once.iterations); // from the solution that was carried over
}

} // namespace test_adaptive_poisson
