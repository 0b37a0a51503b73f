// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The element-free Galerkin method finds what it must find exactly, and the errors that are known on a grid.

#include "expect_throw.h"
#include "galerkin_problems.h"

#include <gtest/gtest.h>

namespace test_element_free_galerkin {

using namespace galerkin;
using namespace CGAL::Bubble_relaxation_2::internal;

double integral(const std::vector<Background_cell_2>& cells, std::size_t n, int i, int j)
{
  const Cell_quadrature_2 rule(n);
  double sum = 0;
  for (const Background_cell_2& c : cells)
    rule.for_each_point(c, [&](double x, double y, double w) { sum += w * std::pow(x, i) * std::pow(y, j); });
  return sum;
}

Integration_domain_2 domain(const CDT& cdt)
{
  return Integration_domain_2(Domain_marks_2<CDT>(cdt, CGAL::parameters::default_values()));
}

TEST(Gauss_rule, is_exact_up_to_its_degree_and_no_further)
{
  const std::vector<Background_cell_2> square{{0, 0, 1, 0, 0, 1, false}}, triangle{{0, 0, 1, 0, 0, 1, true}};
  for (int n : {1, 2, 3, 4, 7, 12, 30}) {
    SCOPED_TRACE(n);
    const int degree = 2 * n - 1;
    for (int i = 0; i <= degree; ++i) {
      EXPECT_NEAR(integral(square, n, i, degree), 1. / (i + 1) / (degree + 1), 1e-14);
      // i! j! / (i + j + 2)!
      const int j = degree - i;
      const double exact = std::exp(std::lgamma(i + 1) + std::lgamma(j + 1) - std::lgamma(i + j + 3));
      EXPECT_NEAR(integral(triangle, n, i, j), exact, 1e-13 * exact + 1e-16);
    }
    if (n < 7) {
      EXPECT_GT(std::abs(integral(square, n, 2 * n, 0) - 1. / (2 * n + 1)), 1e-9);
    }
  }
}

TEST(Background_cells, fill_a_domain_with_a_hole)
{
  const CDT cdt = square_with_hole();
  const Integration_domain_2 d = domain(cdt);
  const double area = 1 - 0.26 * 0.26;
  const double moment = 0.25 - 0.26 * 0.54 * 0.26 * 0.46; // of x y
  EXPECT_NEAR(d.area, area, 1e-15);
  for (int n : {1, 3, 12, 40}) {
    const auto cells = Grid_cells_2(d, n, n + 1).cells();
    EXPECT_NEAR(integral(cells, 1, 0, 0), area, 1e-13);
    EXPECT_NEAR(integral(cells, 2, 1, 1), moment, 1e-13);
  }
  for (double size : {1., 0.1, 0.02}) {
    const auto cells = triangle_cells(d, [&](const auto&) { return size; }, 100000);
    EXPECT_NEAR(integral(cells, 2, 1, 1), moment, 1e-13);
    EXPECT_NEAR(integral(cells, 1, 0, 0), area, 1e-13);
    for (const Background_cell_2& c : cells)
      EXPECT_LE((std::max)({std::hypot(c.ux, c.uy), std::hypot(c.vx, c.vy), std::hypot(c.ux - c.vx, c.uy - c.vy)}),
                largest_cell_side * size);
  }
  // whole rectangles are cells, and those of a rectangle that is triangulated anyhow as well
  EXPECT_EQ(Grid_cells_2(domain(square()), 12, 12).cells().size(), 144u);
}

TEST(Boundary, has_holes_and_outer_normals)
{
  CDT cdt = square_with_hole();
  cdt.insert_constraint(Point(0.1, 0.1), Point(0.3, 0.2)); // the domain on both sides: no boundary
  const Integration_domain_2 d = domain(cdt);
  double length = 0, flow_x = 0, flow = 0;
  for (const Boundary_edge_2& e : d.boundary) {
    const auto n = e.outer_normal();
    const Point m = middle(e.a, e.b);
    length += e.length();
    flow_x += e.length() * n.x;
    flow += e.length() * (n.x * m.x() + n.y * m.y()); // the divergence of (x, y) is 2
  }
  EXPECT_NEAR(length, 4 + 4 * 0.26, 1e-14);
  EXPECT_NEAR(flow_x, 0, 1e-14);
  EXPECT_NEAR(flow, 2 * d.area, 1e-14);
  // 12 segments a side of a rectangle with 12 x 12 cells
  EXPECT_EQ(cut_boundary(domain(square()), Grid_cells_2(domain(square()), 12, 12)).size(), 48u);
}

// L2 and H1 errors on a grid of 12 x 12 nodes that an independent program found, to four digits
TEST(Paper, errors_on_a_grid_of_144_nodes)
{
  struct Row
  {
    double penalty, l2, h1;
  };
  for (const Row& r : {Row{1e2, 6.33e-3, 2.94e-2}, Row{1e3, 5.92e-4, 9.04e-3}, Row{1e4, 2.734e-4, 8.641e-3},
                       Row{1e5, 3.86e-4, 1.11e-2}, Row{1e6, 2.11e-3, 4.77e-2}}) {
    const auto e = error(square(), grid(12), paper_problem(), paper_options(r.penalty));
    EXPECT_NEAR(e.l2, r.l2, 3e-3 * r.l2) << r.penalty;
    EXPECT_NEAR(e.h1, r.h1, 3e-3 * r.h1) << r.penalty;
  }
}

TEST(Paper, more_points_and_larger_supports_are_better)
{
  Options o = paper_options(1e4);
  const auto before = error(square(), grid(12), paper_problem(), o);
  o.gauss_points = 4;
  const auto integrated = error(square(), grid(12), paper_problem(), o);
  const auto by_default = error(square(), grid(12), paper_problem(), Options());
  EXPECT_LT(integrated.l2, 0.8 * before.l2);
  EXPECT_LT(by_default.l2, 0.2 * before.l2);
  EXPECT_LT(by_default.h1, 0.4 * before.h1);
}

TEST(Patch, a_linear_solution_is_exact_with_consistent_integration_only)
{
  const Nodes nodes = grid(12, 0.25);
  for (Cells cells : {Cells::TRIANGLES, Cells::GRID})
    for (int n : {2, 3})
      for (Dirichlet dirichlet : {Dirichlet::NITSCHE, Dirichlet::LAGRANGE_MULTIPLIERS}) {
        Options o;
        o.cells = cells;
        o.gauss_points = n;
        o.dirichlet = dirichlet;
        EXPECT_LT(error(square(), nodes, linear(), o).h1, 1e-11);
        o.consistent = false;
        EXPECT_GT(error(square(), nodes, linear(), o).h1, 1e-3);
      }
}

TEST(Patch, a_quadratic_solution_is_exact_with_the_quadratic_basis)
{
  for (double jitter : {0., 0.25})
    for (int n : {3, 4}) {
      Options o;
      o.basis = Basis::QUADRATIC;
      o.gauss_points = n;
      const Nodes nodes = grid(12, jitter);
      EXPECT_LT(error(square(), nodes, linear(), o).h1, 1e-11);
      EXPECT_LT(error(square(), nodes, quadratic(), o).h1, 1e-11);
      o.basis = Basis::LINEAR;
      EXPECT_GT(error(square(), nodes, quadratic(), o).h1, 1e-3);
    }
}

TEST(Patch, with_a_hole_and_given_flow)
{
  const CDT cdt = square_with_hole();
  const Nodes nodes = grid(14, 0.2, is_in_hole);
  const auto left_and_right = [](const Point& p) { return p.x() == 0 || p.x() == 1; };
  for (Cells cells : {Cells::TRIANGLES, Cells::GRID})
    for (Dirichlet dirichlet : {Dirichlet::NITSCHE, Dirichlet::LAGRANGE_MULTIPLIERS}) {
      Options o;
      o.cells = cells;
      o.dirichlet = dirichlet;
      EXPECT_LT(error(cdt, nodes, linear(), o).h1, 1e-11);
      EXPECT_LT(error(cdt, nodes, linear(), o, left_and_right).h1, 1e-11);
    }
  Options o;
  o.basis = Basis::QUADRATIC;
  EXPECT_LT(error(cdt, nodes, quadratic(), o, left_and_right).h1, 1e-10);
}

TEST(Dirichlet, all_ways_agree)
{
  const Nodes nodes = grid(12, 0.2);
  Options o;
  const auto nitsche = error(square(), nodes, paper_problem(), o);
  EXPECT_LT(nitsche.l2, 2e-4);
  o.dirichlet = Dirichlet::LAGRANGE_MULTIPLIERS;
  EXPECT_LT(error(square(), nodes, paper_problem(), o).l2, 1.5 * nitsche.l2);
  o.dirichlet = Dirichlet::PENALTY;
  const auto penalty = error(square(), nodes, paper_problem(), o);
  EXPECT_GT(penalty.l2, nitsche.l2); // by (du/dn) / alpha
  EXPECT_LT(penalty.l2, 4 * nitsche.l2);
}

TEST(Dirichlet, multipliers_on_round_and_short_edged_outlines)
{
  // edges as short as the distance of nodes, and a few times as long, with nodes on them
  struct Outline
  {
    int corners, nodes_on_edge;
  };
  for (const Outline& outline : {Outline{32, 1}, Outline{8, 4}}) {
    const domains::Outline polygon = domains::polygon(0.5, 0.5, 0.5, outline.corners);
    Nodes nodes = grid(12, 0, [&](const Point& p) { return std::hypot(p.x() - 0.5, p.y() - 0.5) > 0.4; });
    for (std::size_t k = 0; k < polygon.size(); ++k)
      for (int i = 0; i < outline.nodes_on_edge; ++i) {
        const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const double t = static_cast<double>(i) / outline.nodes_on_edge;
        nodes.points.push_back(Point(a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)));
        nodes.sizes.push_back(1. / 11);
      }
    Options o;
    o.dirichlet = Dirichlet::LAGRANGE_MULTIPLIERS;
    const CDT cdt = domains::make({polygon});
    const Solution s = solve(cdt, nodes, paper_problem().problem(), o);
    EXPECT_GT(s.report().number_of_multipliers, 15u);
    EXPECT_LE(s.report().number_of_multipliers, 23u); // two thirds of the nodes on the boundary
    EXPECT_LT(s.report().condition_number, 1e6);
    // hats are continuous where the outline bends a little, and the flow is not, so this is no better
    EXPECT_LT(s.error(paper_problem().u, paper_problem().gradient).l2, 1e-3) << outline.corners;
  }
}

TEST(Dirichlet, the_default_penalty_is_scale_free)
{
  const CDT cdt = domains::make({domains::square(0, 0, 1000)});
  Nodes nodes = grid(12);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.points[i] = Point(1000 * nodes.points[i].x(), 1000 * nodes.points[i].y());
    nodes.sizes[i] *= 1000;
  }
  const auto np = CGAL::parameters::dirichlet_condition(Dirichlet::PENALTY);
  Problem large;
  large.dirichlet = [](const Point& p) { return std::exp(1e-6 * p.x() * p.y()); };
  large.source = [](const Point& p) {
    return -1e-12 * (p.x() * p.x() + p.y() * p.y()) * std::exp(1e-6 * p.x() * p.y());
  };
  const Solution a = Solver(square(), grid(12), np).solve(paper_problem().problem()), b = Solver(cdt, nodes, np).solve(large);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    EXPECT_NEAR(a.coefficients()[i], b.coefficients()[i], 1e-10);
}

TEST(Neumann, without_given_values_the_mean_is_zero)
{
  const Nodes nodes = grid(12, 0.2);
  const auto nowhere = [](const Point&) { return false; };
  Exact exact = linear();
  exact.u = [](const Point& p) { return 2 * p.x() - 3 * p.y() + 0.5; };
  EXPECT_LT(error(square(), nodes, exact, Options(), nowhere).h1, 1e-11);
  Problem bad = exact.problem(nowhere);
  bad.source = [](const Point&) { return 1.; };
  expect_invalid([&] { solve(square(), nodes, bad, Options()); }, {"no Dirichlet boundary"});
}

TEST(Solution, values_and_gradients_are_those_of_the_error_and_outlive_the_solver)
{
  const Exact exact = paper_problem();
  const Solution copy = [&] {
    const Nodes nodes = grid(12, 0.2);
    const CDT cdt = square();
    return Solver(cdt, nodes, Options().parameters()).solve(exact.problem());
  }();
  EXPECT_EQ(copy.coefficients().size(), 144u);
  const Point p(0.37, 0.61);
  EXPECT_NEAR(copy.value(p), exact.u(p), 3e-4);
  EXPECT_NEAR((copy.gradient(p) - exact.gradient(p)).squared_length(), 0, 1e-3);
  const double h = 1e-6;
  EXPECT_NEAR(copy.gradient(p).x(),
              (copy.value(Point(p.x() + h, p.y())) - copy.value(Point(p.x() - h, p.y()))) / (2 * h), 1e-6);
  // against itself there is no error
  const auto none = copy.error([&](const Point& q) { return copy.value(q); },
                               [&](const Point& q) { return copy.gradient(q); });
  EXPECT_LT(none.h1, 1e-12);
  const auto& report = copy.report();
  EXPECT_EQ(report.number_of_nodes, 144u);
  EXPECT_EQ(report.number_of_gauss_points, 9 * report.number_of_cells);
  EXPECT_LT(report.residual, 1e-12);
  EXPECT_GT(report.condition_number, 10);
}

TEST(Solver, large_systems_are_iterated)
{
  Options o;
  o.support_factor = 1.6;
  o.gauss_points = 2;
  const Solution s = solve(square(), grid(72, 0.2), linear().problem(), o); // 5184 nodes
  EXPECT_EQ(s.report().condition_number, 0);
  EXPECT_LT(s.error(linear().u, linear().gradient).l2, 1e-9);
}

} // namespace test_element_free_galerkin
