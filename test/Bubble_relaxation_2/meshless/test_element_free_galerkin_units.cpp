// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The element-free Galerkin method in any unit and anywhere, on domains in several parts and of other kernels, and
// with nodes that no one would want.

#include "expect_throw.h"
#include "galerkin_problems.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace test_element_free_galerkin_units {

using namespace galerkin;

/// where what was in the unit square is: `unit` times as large, and moved
struct Place
{
  double unit, shift;

  Point operator()(const Point& p) const { return Point(shift + unit * p.x(), shift + unit * p.y()); }
  Point back(const Point& p) const { return Point((p.x() - shift) / unit, (p.y() - shift) / unit); }

  Nodes operator()(Nodes nodes) const
  {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes.points[i] = (*this)(nodes.points[i]);
      nodes.sizes[i] *= unit;
    }
    return nodes;
  }

  Exact operator()(const Exact& e) const
  {
    const Place place = *this;
    return Exact{[=](const Point& p) { return e.u(place.back(p)); },
                 [=](const Point& p) { return e.gradient(place.back(p)) / place.unit; },
                 [=](const Point& p) { return e.laplacian(place.back(p)) / (place.unit * place.unit); }};
  }

  CDT square() const { return domains::make({domains::square(shift, shift, unit)}); }
};

Options with(Dirichlet dirichlet, double unit)
{
  Options o;
  o.dirichlet = dirichlet;
  o.penalty_factor = 1e4 / unit;
  return o;
}

/// the error in the L2 norm of the function in the unit square
double l2(const Place& place, const Exact& exact, const Options& o,
          const std::function<bool(const Point&)>& is_dirichlet = nullptr)
{
  return error(place.square(), place(grid(12, 0.2)), place(exact), o, is_dirichlet).l2 / place.unit;
}

/// of mean 0 in the unit square
Exact without_mean()
{
  const Exact e = quadratic();
  return Exact{[e](const Point& p) { return e.u(p) - (1 + 1. - 1.5 + 1. / 3 - 0.5 + 1); }, e.gradient, e.laplacian};
}

CDT two_squares() { return domains::make({domains::square(0, 0, 1), domains::square(3, 0, 1)}); }

Nodes nodes_of_two_squares()
{
  Nodes nodes = grid(8);
  for (std::size_t i = 0, n = nodes.size(); i < n; ++i) {
    nodes.points.push_back(nodes.points[i] + Vector(3, 0));
    nodes.sizes.push_back(nodes.sizes[i]);
  }
  return nodes;
}

TEST(Units, do_not_matter)
{
  for (double unit : {1e-9, 1e9})
    for (Dirichlet d : {Dirichlet::NITSCHE, Dirichlet::PENALTY, Dirichlet::LAGRANGE_MULTIPLIERS}) {
      const double expected = l2(Place{1, 0}, paper_problem(), with(d, 1));
      EXPECT_NEAR(l2(Place{unit, 0}, paper_problem(), with(d, unit)) / expected, 1, 1e-6) << unit << ' ' << int(d);
    }
}

TEST(Units, do_not_matter_without_given_values)
{
  const auto nowhere = [](const Point&) { return false; };
  const double expected = l2(Place{1, 0}, without_mean(), Options(), nowhere);
  EXPECT_LT(expected, 1e-3);
  for (double unit : {1e-9, 1e9})
    EXPECT_NEAR(l2(Place{unit, 0}, without_mean(), Options(), nowhere) / expected, 1, 1e-6) << unit;
}

TEST(Units, an_offset_costs_what_coordinates_lose)
{
  for (Dirichlet d : {Dirichlet::NITSCHE, Dirichlet::PENALTY, Dirichlet::LAGRANGE_MULTIPLIERS})
    EXPECT_LT(l2(Place{1, 1e6}, linear(), with(d, 1)), d == Dirichlet::PENALTY ? 1e-3 : 1e-8) << int(d);
}

TEST(Parts, each_needs_given_values)
{
  const CDT cdt = two_squares();
  const Nodes nodes = nodes_of_two_squares();
  EXPECT_LT(error(cdt, nodes, linear(), Options()).h1, 1e-11);
  const auto on_the_left = [](const Point& p) { return p.x() < 2; };
  expect_throw<std::invalid_argument>([&] { solve(cdt, nodes, linear().problem(on_the_left), Options()); },
                                      {"no Dirichlet boundary in the part", "around (3.", "2 parts"});
  const auto nowhere = [](const Point&) { return false; };
  expect_throw<std::invalid_argument>([&] { solve(cdt, nodes, linear().problem(nowhere), Options()); },
                                      {"no Dirichlet boundary in the part"});
}

TEST(Too_many_cells, of_sizes_in_another_unit_or_a_fine_grid)
{
  Nodes nodes = grid(12);
  for (double& d : nodes.sizes)
    d *= 1e-3;
  expect_throw<std::length_error>([&] { Solver(square(), nodes, Options().parameters()); },
                                  {"nodes", "more than 1144"});
  namespace P = CGAL::parameters;
  expect_throw<std::length_error>(
    [&] { Solver(square(), nodes, P::integration_cells(Cells::GRID)); }, {"nodes", "more than 1144"});
  expect_throw<std::length_error>(
    [&] { Solver(square(), grid(12), P::integration_cells(Cells::GRID).grid_cells(100000)); },
    {"grid_cells", "100000 x 100000", "1144000"});
}

TEST(Deficient_supports, are_counted_before_the_report)
{
  Options o;
  o.support_factor = 1.05;
  o.deficient_support = CGAL::Deficient_support::REPORT;
  const Nodes nodes = grid(12, 0.4);
  for (int k = 0;; ++k) {
    ASSERT_LT(k, 3) << "what is told does not suffice";
    try {
      solve(square(), nodes, linear().problem(), o);
      EXPECT_EQ(k, 1);
      return;
    } catch (const CGAL::Deficient_support_error_2& e) {
      EXPECT_GT(e.number_of_points, 10u);
      ASSERT_GT(e.sufficient_enlargement, 1);
      o.support_factor *= e.sufficient_enlargement;
    }
  }
}

// with a factor of 10 errors were up to 70 times larger on such nodes
TEST(Nitsche, the_default_suffices_for_nodes_close_to_the_boundary)
{
  Nodes nodes = grid(14);
  for (const Point& p : grid(14, 0.45).points)
    if (p.x() > 0.02 && p.x() < 0.98 && p.y() > 0.02 && p.y() < 0.98) {
      nodes.points.push_back(Point(0.5 + 0.98 * (p.x() - 0.5), 0.5 + 0.98 * (p.y() - 0.5)));
      nodes.sizes.push_back(nodes.sizes[0]);
    }
  const auto h1 = [&](const auto& np) {
    return Solver(square(), nodes, np).solve(paper_problem().problem()).error(paper_problem().u, paper_problem().gradient).h1;
  };
  EXPECT_LT(h1(CGAL::parameters::default_values()), 1.2 * h1(CGAL::parameters::nitsche_factor(200.)));
}

TEST(Solution_at_many_points, is_that_at_each)
{
  const Solution s = solve(square(), grid(12, 0.2), paper_problem().problem(), Options());
  const std::vector<Point> points{{0.1, 0.2}, {0.5, 0.5}, {0.99, 0.01}};
  const auto values = s.evaluate(points, 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_DOUBLE_EQ(values.values[i], s.value(points[i]));
    EXPECT_DOUBLE_EQ(values.dx[i], s.gradient(points[i]).x());
    EXPECT_DOUBLE_EQ(values.dy[i], s.gradient(points[i]).y());
  }
}

TEST(Kernels, exact_constructions_a_hierarchy_of_constraints_and_seeds)
{
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Cdt = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Exact_kernel, CGAL::Default, CGAL::Exact_predicates_tag>>;
  using Exact_point = Exact_kernel::Point_2;
  Cdt cdt = domains::make<Cdt>({domains::square(0, 0, 1), domains::square(0.41, 0.33, 0.26)});
  cdt.insert_constraint(Exact_point(0, 0), Exact_point(0.41, 0.33)); // no boundary
  CGAL::Node_set_2<Exact_point> nodes;
  const Nodes inexact = grid(12, 0, is_in_hole);
  for (const Point& p : inexact.points)
    nodes.points.emplace_back(p.x(), p.y());
  nodes.sizes = inexact.sizes;
  CGAL::Poisson_problem_2<Exact_kernel> problem;
  problem.dirichlet = [](const Exact_point& p) { return CGAL::to_double(1 + 2 * p.x() - 3 * p.y()); };
  const std::vector<Exact_point> holes{{0.5, 0.5}};
  const auto solution =
    CGAL::Element_free_Galerkin_2<Cdt>(cdt, nodes, CGAL::parameters::seeds(holes)).solve(problem);
  EXPECT_NEAR(solution.value(Exact_point(0.2, 0.9)), 1 + 0.4 - 2.7, 1e-11);
  EXPECT_LT(solution.error([&](const Exact_point& p) { return problem.dirichlet(p); },
                           [](const Exact_point&) { return Exact_kernel::Vector_2(2, -3); }).h1, 1e-11);
}

} // namespace test_element_free_galerkin_units
