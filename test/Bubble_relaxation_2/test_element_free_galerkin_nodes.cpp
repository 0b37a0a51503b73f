// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Nodes of meshes, and how fast the error of the element-free Galerkin method falls on bubbles.

#include "galerkin_problems.h"

#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <vector>

using namespace galerkin;

namespace {

CDT mesh(CDT cdt, double d)
{
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  return cdt;
}

} // namespace

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
    o.nitsche_factor = row.basis == Basis::LINEAR ? 10 : 30;
    for (bool on_mesh : {true, false}) {
      double l2[2], h1[2], n[2];
      for (int k = 0; k < 2; ++k) {
        const CDT cdt = mesh(square(), k == 0 ? 0.1 : 0.035);
        const Nodes nodes = CGAL::node_set_2(cdt);
        const auto e = error(on_mesh ? cdt : square(), nodes, paper(), o);
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
  const Solution s = solve(cdt, nodes, paper().problem(), Options());
  EXPECT_LT(s.error(paper().u, paper().gradient).l2, 1e-4);
  EXPECT_LT(s.error(paper().u, paper().gradient).h1, 1e-2);
  EXPECT_EQ(s.report().number_of_cells, CGAL::mesh_quality_2(cdt).number_of_triangles()); // none was cut
  EXPECT_LT(error(cdt, nodes, linear(), Options()).h1, 1e-11);
}
