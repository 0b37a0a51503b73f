// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The element-free Galerkin method on nodes of meshes, and how fast its error falls there; what it says about bad
// input; the callback, and threads.

#include "expect_throw.h"
#include "galerkin_problems.h"

#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_element_free_galerkin_nodes {

using namespace galerkin;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

void expect_invalid(const Options& o, const std::vector<std::string>& words)
{
  expect_throw<std::invalid_argument>([&] { Solver(square(), grid(4), o.parameters()); }, words);
}

void expect_failure(const Nodes& nodes, const Options& o, const std::vector<std::string>& words)
{
  expect_throw<std::runtime_error>([&] { solve(square(), nodes, paper_problem().problem(), o); }, words);
}

CDT mesh(CDT cdt, double d)
{
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  return cdt;
}

TEST(Node_set, has_the_vertices_of_the_domain_with_the_mean_length_of_their_edges)
{
  CDT cdt = mesh(square_with_hole(), 0.08);
  cdt.insert(Point(0.5, 0.4));   // in the hole: no node
  cdt.insert(Point(-0.5, -0.5)); // outside
  const Nodes nodes = CGAL::node_set_2(cdt);
  ASSERT_EQ(nodes.size() + 2, cdt.number_of_vertices());
  std::map<Point, std::pair<double, int>> lengths;
  std::map<Point, bool> is_on_edge;
  for (auto e : cdt.finite_edges()) {
    const auto f = e.first, g = f->neighbor(e.second);
    const bool in_f = !cdt.is_infinite(f) && f->is_in_domain(), in_g = !cdt.is_infinite(g) && g->is_in_domain();
    if (!in_f && !in_g)
      continue;
    const Point a = f->vertex(cdt.ccw(e.second))->point(), b = f->vertex(cdt.cw(e.second))->point();
    for (const Point& p : {a, b}) {
      lengths[p].first += std::sqrt(CGAL::squared_distance(a, b));
      ++lengths[p].second;
      is_on_edge[p] = is_on_edge[p] || in_f != in_g;
    }
  }
  int corners = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& l = lengths.at(nodes.points[i]);
    EXPECT_NEAR(nodes.sizes[i], l.first / l.second, 1e-14);
    EXPECT_EQ(nodes.dimensions[i] < 2, is_on_edge[nodes.points[i]]);
    corners += nodes.dimensions[i] == 0;
  }
  EXPECT_EQ(corners, 8);
}

TEST(Node_set, has_the_neighbor_sets_of_brute_force)
{
  const Nodes nodes = CGAL::node_set_2(mesh(square(), 0.1), CGAL::parameters::neighbor_radius(2.));
  EXPECT_EQ(nodes.neighbor_radius, 2);
  ASSERT_EQ(nodes.neighbor_offsets.size(), nodes.size() + 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::vector<std::int32_t> all;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (i != j && std::sqrt(CGAL::squared_distance(nodes.points[i], nodes.points[j])) <
                      2 * (nodes.sizes[i] + nodes.sizes[j]) / 2)
        all.push_back(static_cast<std::int32_t>(j));
    const auto first = nodes.neighbors.begin();
    EXPECT_EQ(all, std::vector<std::int32_t>(first + static_cast<std::ptrdiff_t>(nodes.neighbor_offsets[i]),
                                             first + static_cast<std::ptrdiff_t>(nodes.neighbor_offsets[i + 1])));
  }
}

TEST(Node_set, of_bad_meshes)
{
  EXPECT_THROW(CGAL::node_set_2(CDT()), std::invalid_argument);
  EXPECT_THROW(CGAL::node_set_2(square(), CGAL::parameters::neighbor_radius(1.)), std::invalid_argument);
}

TEST(Convergence, on_bubbles)
{
  struct Row
  {
    Basis basis;
    double l2_order, h1_order;
  };
  for (const Row& row : {Row{Basis::LINEAR, 1.7, 0.8}, Row{Basis::QUADRATIC, 2.7, 1.7}}) {
    Options o;
    o.basis = row.basis;
    for (bool on_mesh : {true, false}) {
      double l2[2], h1[2], n[2];
      for (int k = 0; k < 2; ++k) {
        const CDT cdt = mesh(square(), k == 0 ? 0.1 : 0.035);
        const Nodes nodes = CGAL::node_set_2(cdt);
        const auto e = error(on_mesh ? cdt : square(), nodes, paper_problem(), o);
        l2[k] = e.l2;
        h1[k] = e.h1;
        n[k] = static_cast<double>(nodes.size());
      }
      const double refinement = 0.5 * std::log(n[1] / n[0]); // of the logarithm of h
      EXPECT_GT(std::log(l2[0] / l2[1]) / refinement, row.l2_order) << l2[0] << ' ' << l2[1];
      EXPECT_GT(std::log(h1[0] / h1[1]) / refinement, row.h1_order) << h1[0] << ' ' << h1[1];
    }
  }
}

TEST(Convergence, of_graded_nodes)
{
  // smaller nodes in the corner (1, 1), where the solution is steepest
  CDT cdt = square();
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function([](const Point& p) {
    return 0.03 + 0.1 * std::hypot(1 - p.x(), 1 - p.y());
  }));
  const Nodes nodes = CGAL::node_set_2(cdt);
  const Solution s = solve(cdt, nodes, paper_problem().problem(), Options());
  EXPECT_LT(s.error(paper_problem().u, paper_problem().gradient).l2, 1e-4);
  EXPECT_LT(s.error(paper_problem().u, paper_problem().gradient).h1, 1e-2);
  EXPECT_EQ(s.report().number_of_cells, CGAL::mesh_quality_2(cdt).number_of_triangles()); // none was cut
  EXPECT_LT(error(cdt, nodes, linear(), Options()).h1, 1e-11);
}

TEST(Bad_parameter, is_named_with_its_value)
{
  for (double bad : {0., -1., not_a_number, infinity}) {
    Options o;
    o.support_factor = bad;
    expect_invalid(o, {"support_factor"});
    o = Options();
    o.penalty_factor = bad;
    expect_invalid(o, {"penalty_factor"});
    o = Options();
    o.nitsche_factor = bad;
    expect_invalid(o, {"nitsche_factor"});
    o = Options();
    o.residual_tolerance = bad;
    expect_invalid(o, {"residual_tolerance"});
    o = Options();
    o.gauss_points = bad;
    expect_invalid(o, {"number_of_gauss_points"});
  }
  Options o;
  o.gauss_points = 2.5;
  expect_invalid(o, {"number_of_gauss_points", "2.5"});
  o.gauss_points = 65;
  expect_invalid(o, {"number_of_gauss_points", "65", "64"});
  o = Options();
  for (int bad : {0, -3}) {
    o.grid_cells = bad;
    expect_invalid(o, {"grid_cells", std::to_string(bad)});
  }
  namespace P = CGAL::parameters;
  expect_throw<std::invalid_argument>([] { Solver(square(), grid(4), P::support_radius(-0.5)); },
                                      {"support_radius", "-0.5"});
  expect_throw<std::invalid_argument>([] { Solver(square(), grid(4), P::grid_cells(3, 0)); }, {"grid_cells", "0"});
}

TEST(Bad_nodes, are_named)
{
  const auto expect = [](const Nodes& nodes, const std::vector<std::string>& words) {
    expect_throw<std::invalid_argument>([&] { Solver(square(), nodes, Options().parameters()); }, words);
  };
  expect(Nodes(), {"nodes", "no node"});
  Nodes nodes = grid(4);
  nodes.sizes.pop_back();
  expect(nodes, {"nodes", "15 sizes", "16 points"});
  nodes = grid(4);
  nodes.sizes[3] = -0.25;
  expect(nodes, {"nodes", "-0.25", "node 3"});
  nodes = grid(4);
  nodes.points[5] = Point(not_a_number, 1);
  expect(nodes, {"nodes", "node 5", "(nan, 1)"});
  nodes = grid(4);
  nodes.points.push_back(nodes.points[6]);
  nodes.sizes.push_back(nodes.sizes[6]);
  expect(nodes, {"nodes", "node 6 and node 16", "in one place"});
  nodes.sizes[16] *= 1.2; // then they have different shape functions
  EXPECT_LT(error(square(), nodes, linear(), Options()).h1, 1e-11);
}

TEST(Bad_domain, is_named)
{
  expect_throw<std::invalid_argument>([] { Solver(CDT(), grid(4), Options().parameters()); }, {"dimension"});
  CDT open;
  domains::insert(open, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false);
  expect_throw<std::invalid_argument>([&] { Solver(open, grid(4), Options().parameters()); }, {"no face"});
}

TEST(Bad_problem, the_function_and_the_point_are_named)
{
  const auto expect = [](const Problem& p, const std::vector<std::string>& words) {
    expect_throw<std::invalid_argument>([&] { solve(square(), grid(8), p, Options()); }, words);
  };
  Problem p = paper_problem().problem();
  p.source = [](const Point& q) { return q.x() > 0.9 ? infinity : 0.; };
  expect(p, {"source", "inf", " at (0.9"});
  p = paper_problem().problem();
  p.dirichlet = [](const Point& q) { return q.y() == 1 ? not_a_number : 0.; };
  expect(p, {"dirichlet", "nan", ", 1)"});
  p = paper_problem().problem([](const Point& q) { return q.x() < 1; });
  p.neumann = [](const Point&, const Vector& n) { return n.x() > 0.5 ? not_a_number : 0.; };
  expect(p, {"neumann", "nan", "(1, "});
}

TEST(Bad_problem, exceptions_of_functions_pass_through)
{
  struct My_error
  {};
  Problem p = paper_problem().problem();
  p.source = [](const Point& q) { return q.x() > 0.5 ? throw My_error() : 0.; };
  EXPECT_THROW(solve(square(), grid(8), p, Options()), My_error);
}

TEST(Problem, functions_that_are_not_set_are_zero)
{
  const Solution s = solve(square(), grid(8), Problem(), Options());
  for (double c : s.coefficients())
    EXPECT_EQ(c, 0);
}

TEST(Singular, a_node_without_gauss_points)
{
  Nodes nodes = grid(8);
  nodes.points.push_back(Point(3, 3));
  nodes.sizes.push_back(0.1);
  expect_failure(nodes, Options(), {"no Gauss point", "node 64 at (3, 3)"});
}

TEST(Singular, two_nodes_nearly_in_one_place)
{
  Nodes nodes = grid(8);
  nodes.points.push_back(nodes.points[20] + Vector(1e-12, 0));
  nodes.sizes.push_back(nodes.sizes[20]);
  for (bool consistent : {false, true})
    for (Dirichlet dirichlet : {Dirichlet::NITSCHE, Dirichlet::PENALTY, Dirichlet::LAGRANGE_MULTIPLIERS}) {
      Options o;
      o.consistent = consistent;
      o.dirichlet = dirichlet;
      expect_failure(nodes, o, {"system of", "is singular"});
    }
}

TEST(Singular, fewer_gauss_points_than_unknowns)
{
  Options o;
  o.cells = Cells::GRID;
  o.grid_cells = 3;
  o.gauss_points = 2;
  o.consistent = false;
  expect_failure(grid(12), o, {"system of 144 equations", "is singular"});
}

TEST(Residual, a_tolerance_that_cannot_be_reached)
{
  Options o;
  o.residual_tolerance = 1e-40;
  expect_failure(grid(8), o, {"residual", "64 equations", "does not reach 1e-40", "residual_tolerance"});
}

TEST(Deficient_support, is_enlarged_and_counted_or_reported)
{
  // a void in the middle, wider than the supports there
  const auto is_void = [](const Point& p) { return std::hypot(p.x() - 0.5, p.y() - 0.5) < 0.3; };
  Options o;
  o.support_factor = 1.6;
  const Nodes nodes = grid(12, 0, is_void);
  const auto report = solve(square(), nodes, paper_problem().problem(), o).report();
  EXPECT_GT(report.number_of_enlarged_points, 0u);
  EXPECT_GE(report.largest_enlargement, 1.1);
  EXPECT_EQ(solve(square(), grid(12), paper_problem().problem(), o).report().number_of_enlarged_points, 0u);
  o.deficient_support = CGAL::Deficient_support::REPORT;
  EXPECT_THROW(solve(square(), nodes, paper_problem().problem(), o), CGAL::Deficient_support_error_2);
}

TEST(Callback, progress_rises_to_one_and_may_stop_at_any_call)
{
  std::vector<double> fractions;
  Options o;
  o.callback = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  solve(square(), grid(24), paper_problem().problem(), o);
  ASSERT_GT(fractions.size(), 4u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  const std::size_t calls = fractions.size();
  for (std::size_t at : {std::size_t(1), std::size_t(2), calls / 2, calls - 1}) {
    std::size_t left = at;
    o.callback = [&](double) { return --left > 0; };
    const Solution s = solve(square(), grid(24), paper_problem().problem(), o);
    EXPECT_EQ(left, 0u) << "called again after it said stop";
    EXPECT_TRUE(s.report().is_stopped_by_callback);
    EXPECT_TRUE(s.coefficients().empty());
    EXPECT_THROW(s.value(Point(0.5, 0.5)), std::logic_error);
    EXPECT_THROW(s.gradient(Point(0.5, 0.5)), std::logic_error);
    EXPECT_THROW(s.error(paper_problem().u, paper_problem().gradient), std::logic_error);
  }
}

TEST(Report, is_printed)
{
  std::ostringstream out;
  out << solve(square(), grid(8), paper_problem().problem(), Options()).report();
  EXPECT_NE(out.str().find("64 nodes"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("residual"), std::string::npos) << out.str();
}

TEST(Order, of_the_triangulation_does_not_matter)
{
  const Nodes nodes = grid(12, 0.2);
  CDT forth = square(), back = square();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    forth.insert(nodes.points[i]);
    back.insert(nodes.points[nodes.size() - 1 - i]);
  }
  EXPECT_EQ(solve(forth, nodes, paper_problem().problem(), Options()).coefficients(),
            solve(back, nodes, paper_problem().problem(), Options()).coefficients());
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Threads, give_the_same_bits)
{
  const auto expect_same = [](const Nodes& nodes, const Options& o) {
    const Solution one = solve(square(), nodes, paper_problem().problem(), o);
    const auto a = one.error(paper_problem().u, paper_problem().gradient);
    for (std::size_t threads : {1, 2, 5}) {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      const Solution many = Solver(square(), nodes, o.parameters().concurrency_tag(CGAL::Parallel_tag()))
                              .solve(paper_problem().problem());
      EXPECT_EQ(one.coefficients(), many.coefficients()) << threads;
      const auto b = many.error(paper_problem().u, paper_problem().gradient);
      EXPECT_EQ(a.l2, b.l2) << threads;
      EXPECT_EQ(a.h1, b.h1) << threads;
    }
  };
  Options o;
  for (Basis basis : {Basis::LINEAR, Basis::QUADRATIC}) {
    o.basis = basis;
    expect_same(grid(24, 0.2), o);
  }
  o = Options();
  o.support_factor = 1.6;
  o.gauss_points = 2;
  expect_same(grid(72, 0.2), o); // 5184 nodes: more than are factorized
}

TEST(Threads, name_the_first_bad_point)
{
  const Nodes nodes = grid(24, 0.2);
  // of several points the message names the first, whichever thread finds its own first
  Problem p = paper_problem().problem();
  p.source = [](const Point&) { return not_a_number; };
  std::string messages[2];
  for (int k = 0; k < 2; ++k)
    try {
      if (k == 0)
        solve(square(), nodes, p, Options());
      else
        Solver(square(), nodes, Options().parameters().concurrency_tag(CGAL::Parallel_tag())).solve(p);
    } catch (const std::invalid_argument& e) {
      messages[k] = e.what();
    }
  EXPECT_NE(messages[0], "");
  EXPECT_EQ(messages[0], messages[1]);
}
#endif

} // namespace test_element_free_galerkin_nodes
