// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Influence domains: what is found are the very nodes that a look at all of them finds.

#include "influence_checks.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <limits>
#include <memory>

using namespace influence_checks;

TEST(Influence_domain, random_nodes_with_one_radius)
{
  const Points points = random_points(2000);
  for (double radius : {0.001, 0.05, 0.4, 10.})
    EXPECT_GT(expect_exact(Influence(points, radius), points, 100), 100u);
}

TEST(Influence_domain, radii_of_huge_ratio)
{
  const Points points = random_points(1500);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-9, 0.5);
  std::vector<double> r;
  for (std::size_t i = 0; i < points.size(); ++i)
    r.push_back(std::pow(10, exponent(random)));
  EXPECT_GT(expect_exact(Influence(points, r), points), 10000u);
}

TEST(Influence_domain, graded_towards_a_point)
{
  Points points;
  std::vector<double> r;
  for (int ring = 0; ring < 60; ++ring)
    for (int k = 0; k < 30; ++k) {
      const double distance = std::pow(0.7, ring), angle = 2 * pi * (k + 0.5 * (ring % 2)) / 30;
      points.emplace_back(distance * std::cos(angle), distance * std::sin(angle));
      r.push_back(0.5 * distance);
    }
  const Influence influence(points, r);
  EXPECT_GT(expect_exact(influence, points), 10000u);
  // as many near the centre as far from it
  for (int ring : {10, 30, 50}) {
    Numbers found;
    influence.nodes_at(Point(std::pow(0.7, ring), 0), std::back_inserter(found));
    EXPECT_GT(found.size(), 5u);
    EXPECT_LT(found.size(), 60u);
  }
}

TEST(Influence_domain, clusters_and_coincident_nodes)
{
  Points points;
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (double spread : {1., 1e-3, 1e-9, 0.})
    for (int k = 0; k < 200; ++k)
      points.emplace_back(spread * normal(random), 1 + spread * normal(random));
  for (double radius : {1e-10, 1e-3, 0.1})
    EXPECT_GT(expect_exact(Influence(points, radius), points, 100), 1000u);
}

/// what a set of nodes costs: lists are to take memory for each node, and to have few nodes that are not found
void expect_short_lists(const Points& points, const std::vector<double>& r)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  std::vector<Influence_disc_2> discs;
  for (std::size_t i = 0; i < points.size(); ++i)
    discs.push_back(Influence_disc_2{points[i].x(), points[i].y(), r[i]});
  const Disc_lists_2 lists(discs);
  EXPECT_LT(lists.number_of_entries(), 20 * points.size());
  EXPECT_LT(lists.number_of_cells(), 20 * points.size());
  std::size_t candidates = 0, found = 0;
  Numbers result;
  for (std::size_t i = 0; i < discs.size(); i += 10) {
    lists.for_each_candidate(discs[i].x, discs[i].y, [&candidates](std::int32_t) { ++candidates; });
    lists.find(discs, discs[i].x, discs[i].y, 1, result);
    found += result.size();
  }
  EXPECT_LT(candidates, 4 * found);
}

TEST(Influence_domain, no_mixture_of_radii_makes_long_lists)
{
  const Points points = random_points(20000);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> any, few_large, all_large(points.size(), 5.);
  for (std::size_t i = 0; i < points.size(); ++i) {
    any.push_back(std::pow(10, -1 - 3 * uniform(random)));
    few_large.push_back(i % 200 == 0 ? 0.5 : 0.01);
  }
  expect_short_lists(points, any);
  expect_short_lists(points, few_large);
  expect_short_lists(points, all_large);
  Points clusters;
  for (std::size_t i = 0; i < points.size(); ++i)
    clusters.emplace_back(points[i / 100].x() + 1e-6 * uniform(random), points[i / 100].y() + 1e-6 * uniform(random));
  expect_short_lists(clusters, std::vector<double>(clusters.size(), 2e-7));
}

TEST(Influence_domain, any_scale_and_place)
{
  const Points points = random_points(500);
  const Influence influence(points, 0.1);
  for (double scale : {1e-200, 1e-30, 1e30, 1e150}) {
    Points scaled;
    for (const Point& p : points)
      scaled.emplace_back(scale * p.x(), scale * p.y());
    const Influence other(scaled, scale * 0.1);
    for (const Point& p : random_points(100, 1.2, -0.1)) {
      Numbers found, expected;
      other.nodes_at(Point(scale * p.x(), scale * p.y()), std::back_inserter(found));
      influence.nodes_at(p, std::back_inserter(expected));
      EXPECT_EQ(found, expected) << scale;
    }
  }
  const Points far = random_points(500, 1, 1e9);
  EXPECT_GT(expect_exact(Influence(far, 0.1), far), 1000u);
}

TEST(Influence_domain, few_nodes)
{
  EXPECT_EQ(expect_exact(Influence(Points(), 1.), Points()), 0u);
  const Points one{{2, 3}};
  EXPECT_GT(expect_exact(Influence(one, 1.), one), 0u);
  const Points in_line{{0, 0}, {1, 0}, {2, 0}, {1e9, 0}};
  EXPECT_GT(expect_exact(Influence(in_line, 1.5), in_line), 0u);
}

TEST(Influence_domain, a_radius_exactly_met_is_outside)
{
  const Influence influence(Points{{0, 0}, {3, 4}, {6, 8}}, 5.);
  Numbers found;
  influence.nodes_at(Point(3, 4), std::back_inserter(found));
  EXPECT_EQ(found, Numbers{1});
  found.clear();
  influence.nodes_at(Point(3, 4), std::back_inserter(found), 2.);
  EXPECT_EQ(found, (Numbers{0, 1, 2}));
}

TEST(Influence_domain, copies_and_queries_outlive_it)
{
  auto influence = std::make_unique<Influence>(Points{{0, 0}, {1, 0}}, 0.8);
  const Influence copy = *influence;
  Influence::Query query(*influence);
  influence.reset();
  Numbers found;
  query(Point(0.5, 0), 1, found);
  EXPECT_EQ(found, (Numbers{0, 1}));
  EXPECT_EQ(copy.nearest_node(Point(0.6, 0)), 1);
  EXPECT_EQ(copy.radius(1), 0.8);
}

TEST(Influence_domain, exact_kernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<Exact::Point_2> points;
  for (const Point& p : random_points(200))
    points.emplace_back(p.x(), p.y());
  const CGAL::Influence_domain_2<Exact> influence(points, 0.2);
  const Influence other(random_points(200), 0.2);
  Numbers found;
  influence.nodes_at(Exact::Point_2(0.3, 0.6), std::back_inserter(found));
  EXPECT_EQ(found, brute_force(other, Point(0.3, 0.6), 1));
}

TEST(Influence_domain, bad_input_is_told)
{
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Points points{{0, 0}, {1, 0}};
  EXPECT_TELLS(Influence(points, -1.), "parameter radius = -1 must be positive and finite");
  EXPECT_TELLS(Influence(points, 0.), "parameter radius = 0 must be");
  EXPECT_TELLS(Influence(points, nan), "parameter radius = nan must be");
  EXPECT_TELLS(Influence(Points(), infinity), "parameter radius = inf must be");
  EXPECT_TELLS(Influence(points, std::vector<double>{1}), "parameter radii has 1 numbers for 2 nodes");
  EXPECT_TELLS(Influence(points, (std::vector<double>{1, -2.5})), "parameter radii: the radius -2.5 of node 1 must");
  EXPECT_TELLS(Influence(points, (std::vector<double>{nan, 1})), "parameter radii: the radius nan of node 0 must");
  EXPECT_TELLS(Influence((Points{{0, 0}, {0, infinity}}), 1.), "parameter points: node 1 at (0, inf) must be finite");
  const Influence influence(points, 1.);
  Numbers found;
  EXPECT_TELLS(influence.nodes_at(Point(nan, 1), std::back_inserter(found)), "parameter p = (nan, 1) must be finite");
  EXPECT_TELLS(influence.nearest_node(Point(1, -infinity)), "parameter p = (1, -inf) must be finite");
  for (double factor : {0., -1., nan, infinity})
    EXPECT_TELLS(influence.nodes_at(Point(0, 0), std::back_inserter(found), factor), "parameter factor = ");
}
