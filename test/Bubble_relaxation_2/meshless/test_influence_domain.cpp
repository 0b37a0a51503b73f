// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Influence domains: what is found are the very nodes that a look at all of them finds.

#include "expect_throw.h"
#include "influence_checks.h"
#include "random_seeds.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/node_set_2.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>

namespace test_influence_domain {

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
  std::mt19937 random(random_seeds::seed(3));
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
  std::mt19937 random(random_seeds::seed(11));
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
  std::mt19937 random(random_seeds::seed(3));
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
  const struct { double width, origin; } cases[] = {{1e-9, 0}, {1e9, 0}, {1, 1e6}, {1e-9, 1e-3}, {1, 1e9}};
  for (const auto& c : cases) {
    const Points moved = random_points(500, c.width, c.origin);
    EXPECT_GT(expect_exact(Influence(moved, 0.1 * c.width), moved), 1000u) << c.width << ' ' << c.origin;
    std::vector<double> radii;
    for (std::size_t i = 0; i < moved.size(); ++i)
      radii.push_back(c.width * (0.01 + 0.3 * static_cast<double>(i % 7)));
    EXPECT_GT(expect_exact(Influence(moved, radii), moved), 1000u) << c.width << ' ' << c.origin;
  }
}

TEST(Influence_domain, few_nodes)
{
  EXPECT_EQ(expect_exact(Influence(Points(), 1.), Points()), 0u);
  const Points one{{2, 3}};
  EXPECT_GT(expect_exact(Influence(one, 1.), one), 0u);
  const Points in_line{{0, 0}, {1, 0}, {2, 0}, {1e9, 0}};
  EXPECT_GT(expect_exact(Influence(in_line, 1.5), in_line), 0u);
  for (const Points& points : {Points{{0, 0}, {1, 3}}, Points{{0, 0}, {1, 3}, {-1, 1}}, Points{{0, 0}, {1, 3}, {2, 6}}})
    for (double radius : {1e-3, 2., 1e3})
      EXPECT_GT(expect_exact(Influence(points, radius), points), 0u);
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

TEST(Influence_domain, a_factor_makes_radii_of_sizes)
{
  CGAL::Node_set_2<Point> nodes;
  nodes.points = random_points(300);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes.sizes.push_back(0.01 + 1e-4 * static_cast<double>(i));
  const auto np = CGAL::parameters::support_factor(3.7);
  const Influence influence(nodes, np), by_default(nodes);
  for (std::int32_t i = 0; i < 300; ++i) {
    EXPECT_EQ(influence.radius(i), 3.7 * nodes.sizes[static_cast<std::size_t>(i)]);
    EXPECT_EQ(by_default.radius(i), 2.5 * nodes.sizes[static_cast<std::size_t>(i)]);
  }
  EXPECT_GT(expect_exact(influence, nodes.points), 1000u);
  // a plain number is a radius still
  EXPECT_EQ(Influence(nodes, 3).radius(7), 3);
  EXPECT_FALSE((std::is_convertible<CGAL::Node_set_2<Point>, Influence>::value)) << "nobody told the radii";
  using Invalid = std::invalid_argument;
  const auto search = CGAL::parameters::influence_search(CGAL::Influence_search::EXPANSION);
  expect_throw<Invalid>([&] { Influence(nodes, np.influence_search(CGAL::Influence_search::EXPANSION)); },
                        {"the 300 nodes have no neighbour sets"});
  expect_throw<Invalid>([&] { Influence(nodes, search.support_factor(0.)); }, {"support_factor = 0 must be positive"});
  nodes.sizes[5] = -2;
  expect_throw<Invalid>([&] { Influence other(nodes); }, {"parameter nodes.sizes: the size -2 of node 5 must be"});
  nodes.sizes.pop_back();
  expect_throw<Invalid>([&] { Influence other(nodes); }, {"parameter nodes.sizes has 299 numbers for 300 nodes"});
}

TEST(Influence_domain, copies_share_what_they_hold)
{
  const Influence influence(random_points(100), 0.2), copy = influence;
  EXPECT_EQ(&copy.point(42), &influence.point(42));
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

// Points that are constructed have coordinates that no double is: these are rounded once, to the very same numbers for
// the search and for who asks.
TEST(Influence_domain, exact_kernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  CGAL::Node_set_2<Exact::Point_2> nodes;
  const Points random = random_points(200);
  for (std::size_t i = 0; i < random.size(); ++i) {
    const Point& p = random[i], & q = random[(i * i) % 50];
    nodes.points.push_back(CGAL::centroid(Exact::Point_2(p.x(), p.y()), Exact::Point_2(p.x(), q.y()),
                                          Exact::Point_2(q.x(), p.y())));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.neighbor_offsets.push_back(nodes.neighbors.size());
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(nodes.size()); ++j)
      if (j != static_cast<std::int32_t>(i))
        nodes.neighbors.push_back(j);
  }
  nodes.neighbor_offsets.push_back(nodes.neighbors.size());
  Points rounded;
  for (const Exact::Point_2& p : nodes.points)
    rounded.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  const Influence expected(rounded, 0.2);
  for (auto search : {CGAL::Influence_search::BUCKETS, CGAL::Influence_search::EXPANSION}) {
    const CGAL::Influence_domain_2<Exact> influence(nodes, 0.2, CGAL::parameters::influence_search(search));
    EXPECT_EQ(influence.point(7), nodes.points[7]) << "all digits";
    CGAL::Influence_domain_2<Exact>::Query query(influence);
    Numbers found;
    for (const Point& p : random_points(100, 1.2, -0.1)) {
      query(Exact::Point_2(p.x(), p.y()), 1, found);
      EXPECT_EQ(found, brute_force(expected, p, 1));
      EXPECT_EQ(influence.nearest_node(Exact::Point_2(p.x(), p.y())), expected.nearest_node(p));
    }
    EXPECT_EQ(query.number_of_fallbacks(), 0u);
  }
}

TEST(Influence_domain, bad_input_is_told)
{
  using Invalid = std::invalid_argument;
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const Points points{{0, 0}, {1, 0}};
  expect_throw<Invalid>([&] { Influence(points, -1.); }, {"parameter radius = -1 must be positive and finite"});
  expect_throw<Invalid>([&] { Influence(points, 0.); }, {"parameter radius = 0 must be"});
  expect_throw<Invalid>([&] { Influence(points, nan); }, {"parameter radius = nan must be"});
  expect_throw<Invalid>([&] { Influence(Points(), infinity); }, {"parameter radius = inf must be"});
  expect_throw<Invalid>([&] { Influence(points, std::vector<double>{1}); },
                        {"parameter radii has 1 numbers for 2 nodes"});
  expect_throw<Invalid>([&] { Influence(points, (std::vector<double>{1, -2.5})); },
                        {"parameter radii: the radius -2.5 of node 1 must"});
  expect_throw<Invalid>([&] { Influence(points, (std::vector<double>{nan, 1})); },
                        {"parameter radii: the radius nan of node 0 must"});
  expect_throw<Invalid>([&] { Influence((Points{{0, 0}, {0, infinity}}), 1.); },
                        {"parameter points: node 1 at (0, inf) must be finite"});
  const Influence influence(points, 1.);
  Numbers found;
  expect_throw<Invalid>([&] { influence.nodes_at(Point(nan, 1), std::back_inserter(found)); },
                        {"parameter p = (nan, 1) must be finite"});
  expect_throw<Invalid>([&] { influence.nearest_node(Point(1, -infinity)); },
                        {"parameter p = (1, -inf) must be finite"});
  for (double factor : {0., -1., nan, infinity})
    expect_throw<Invalid>([&] { influence.nodes_at(Point(0, 0), std::back_inserter(found), factor); },
                          {"parameter factor = "});
}

TEST(Influence_domain, radii_and_places_of_other_orders)
{
  Points points;
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      points.push_back(Point(0.1 * i, 0.1 * j));
  std::vector<double> radii(points.size(), 0.15);
  radii[7] = 1e13; // all points lie in it
  const Influence influence(points, radii);
  for (const Point& p : {points[500], Point(2.93, 0.01)}) {
    Numbers found;
    influence.nodes_at(p, std::back_inserter(found));
    EXPECT_EQ(found, brute_force(influence, p, 1));
    EXPECT_GT(found.size(), 2u);
  }
  EXPECT_EQ(influence.nearest_node(points[123]), 123);
  for (double radius : {1e17, 1e25, 1e200}) {
    radii[7] = radius;
    expect_throw<std::invalid_argument>([&] { Influence(points, radii); }, {"node 7", "median radius, 0.15"});
  }
  radii[7] = 0.15;
  points[7] = Point(1e50, 0);
  expect_throw<std::invalid_argument>([&] { Influence(points, radii); }, {"node 7", "1e+50"});
  expect_throw<std::invalid_argument>([] { Influence(Points{{0, 0}, {1e180, 0}}, 1e180); }, {"at most 1e153"});
}

} // namespace test_influence_domain
