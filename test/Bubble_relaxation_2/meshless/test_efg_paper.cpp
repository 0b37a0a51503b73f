// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The errors of the element-free Galerkin method on the paper's node sets (its Table 1), in the median of some seeds:
// one set of 144 random nodes may always be a bad one.

#include "../../../demo/Bubble_relaxation_2/efg_table.h"

#include <gtest/gtest.h>

namespace test_efg_paper {

constexpr std::size_t seeds = 7;

efg::Error_sample row(std::size_t steps)
{
  return efg::sample(seeds, efg::simulated(efg::large_then_less, steps), efg::paper_settings());
}

std::set<efg::Point> on_boundary(const efg::Nodes& nodes)
{
  std::set<efg::Point> points;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes.dimensions[i] < 2)
      points.insert(nodes.points[i]);
  return points;
}

/// how fast errors fall from d = 0.1 to 0.0125
efg::Errors orders(CGAL::Moving_least_squares_basis basis)
{
  std::vector<efg::Errors> errors;
  for (double d : {0.1, 0.0125}) {
    efg::CDT square = paper::triangulate({efg::square_outline()});
    const efg::Nodes nodes = CGAL::npbs_place_nodes(square, CGAL::parameters::sizing_function(d));
    square.insert(nodes.points.begin(), nodes.points.end());
    errors.push_back(efg::solve(square, nodes, CGAL::parameters::mls_basis(basis)));
  }
  return efg::Errors{std::log(errors[0].l2 / errors[1].l2) / std::log(8.),
                     std::log(errors[0].h1 / errors[1].h1) / std::log(8.), 0};
}

TEST(Efg_node_sets, bubbles_stay_as_many_for_exactly_so_many_steps_with_those_on_the_boundary_pinned)
{
  const std::vector<efg::Point> outline = efg::square_outline(11);
  const std::set<efg::Point> expected(outline.begin(), outline.end());
  ASSERT_EQ(expected.size(), 44u);
  const efg::Nodes start = efg::paper_nodes(5, efg::constant_size(0));
  for (std::size_t steps : {0, 1, 250}) {
    const efg::Nodes nodes = efg::paper_nodes(5, efg::constant_size(steps));
    EXPECT_EQ(nodes.size(), 144u);
    EXPECT_EQ(nodes.report.number_of_steps, steps);
    EXPECT_EQ(nodes.report.number_of_force_evaluations, 4 * steps);
    EXPECT_EQ(nodes.report.number_of_insertions + nodes.report.number_of_deletions, 0u);
    EXPECT_EQ(on_boundary(nodes), expected);
    EXPECT_EQ(nodes.points == start.points, steps == 0);
  }
}

TEST(Efg_paper, a_grid)
{
  // deterministic, and confirmed by a program that shares nothing with this one
  const auto grid = [](std::uint64_t) { return efg::grid_nodes(12); };
  const efg::Error_sample errors = efg::sample(1, grid, efg::paper_settings());
  EXPECT_NEAR(errors.l2()[0], 2.734e-4, 0.01e-4);
  EXPECT_NEAR(errors.h1()[0], 8.63e-3, 0.02e-3);
}

TEST(Efg_paper, each_simulation_gives_better_nodes)
{
  const efg::Error_sample a = row(0), b = row(250), c = row(500), d = row(1000);
  EXPECT_EQ(a.with_enlarged(), seeds);
  EXPECT_GT(efg::median(a.l2()), 3 * efg::median(b.l2()));
  EXPECT_GT(efg::median(a.h1()), 3 * efg::median(b.h1()));
  EXPECT_GT(efg::median(b.l2()), 1.5 * efg::median(c.l2()));
  EXPECT_GT(efg::median(c.l2()), efg::median(d.l2()));
  // twice the paper's
  EXPECT_LT(efg::median(b.l2()), 2 * 4.29e-3);
  EXPECT_LT(efg::median(b.h1()), 2 * 4.13e-2);
  EXPECT_LT(efg::median(c.l2()), 2 * 4.09e-4);
  EXPECT_LT(efg::median(c.h1()), 2 * 1.62e-2);
  EXPECT_LT(efg::median(d.l2()), 2 * efg::row_d.l2);
  EXPECT_LT(efg::median(d.h1()), 2 * efg::row_d.h1);
  EXPECT_LT(efg::minimum(d.h1()), efg::row_d.h1);
}

TEST(Efg_paper, three_gauss_points_beat_the_paper)
{
  const efg::Error_sample errors =
    efg::sample(seeds, efg::simulated(efg::large_then_less, 1000), efg::paper_settings(1e4, 3));
  EXPECT_LT(efg::median(errors.l2()), efg::row_d.l2);
  EXPECT_LT(efg::median(errors.h1()), efg::row_d.h1);
}

TEST(Efg_paper, random_nodes_are_as_bad_as_in_the_paper_if_singular_matrices_are_inverted)
{
  using CGAL::Deficient_support;
  const auto errors = [](Deficient_support way) {
    return efg::sample(seeds, efg::all_random(), efg::paper_settings().deficient_support(way));
  };
  const efg::Error_sample inverted = errors(Deficient_support::PSEUDO_INVERSE),
                          enlarged = errors(Deficient_support::ENLARGE);
  // the paper's: 0.390 and 2.93
  EXPECT_GT(efg::median(inverted.l2()), 0.390 / 3);
  EXPECT_LT(efg::median(inverted.l2()), 0.390 * 3);
  EXPECT_GT(efg::median(inverted.h1()), 2.93 / 3);
  EXPECT_LT(efg::median(inverted.h1()), 2.93 * 3);
  EXPECT_LT(efg::median(enlarged.l2()), 0.1 * efg::median(inverted.l2()));
}

TEST(Efg_paper, the_defaults_with_as_many_nodes)
{
  const efg::Error_sample errors = efg::sample(seeds, efg::simulated(efg::large_then_less, 1000), efg::Domain::MESH,
                                               CGAL::parameters::default_values());
  EXPECT_LT(efg::median(errors.l2()), 5e-5);
  EXPECT_LT(efg::median(errors.h1()), 3e-3);
}

TEST(Efg_convergence, linear_basis)
{
  const efg::Errors order = orders(CGAL::Moving_least_squares_basis::LINEAR);
  EXPECT_GT(order.l2, 1.9);
  EXPECT_GT(order.h1, 0.9);
}

TEST(Efg_convergence, quadratic_basis)
{
  const efg::Errors order = orders(CGAL::Moving_least_squares_basis::QUADRATIC);
  EXPECT_GT(order.l2, 2.8);
  EXPECT_GT(order.h1, 1.9);
}

} // namespace test_efg_paper
