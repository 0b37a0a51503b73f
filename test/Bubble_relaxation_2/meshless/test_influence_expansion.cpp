// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Influence domains by expansion over neighbour sets: nothing is lost where the sets do not suffice.

#include "domains.h"
#include "expect_throw.h"
#include "influence_checks.h"
#include "random_seeds.h"

#include <CGAL/npbs_place_nodes.h>

#include <stdexcept>
#include <thread>
#include <utility>

namespace test_influence_expansion {

using namespace influence_checks;
using domains::CDT;
using Nodes = CGAL::Node_set_2<Point>;

const auto expansion = CGAL::parameters::influence_search(CGAL::Influence_search::EXPANSION);

CDT square() { return domains::make({domains::square(0, 0, 1)}); }

CDT square_with_hole() { return domains::make({domains::square(0, 0, 1), domains::polygon(0.5, 0.5, 0.15, 24)}); }

CDT notched() { return domains::make({{{0, 0}, {1, 0}, {1, 1}, {0.51, 1}, {0.5, 0.3}, {0.49, 1}, {0, 1}}}); }

template <class Size>
Nodes place(const CDT& cdt, const Size& d)
{
  return CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(d));
}

std::vector<double> radii(const Nodes& nodes, double factor)
{
  std::vector<double> result;
  for (double d : nodes.sizes)
    result.push_back(factor * d);
  return result;
}

const auto graded = [](const Point& p) { return 0.01 + 0.2 * std::abs(p.x() - 0.4); };

/// neighbour sets of any points, of those nearer than `reach(point, point)`
template <class Reach, class = decltype(std::declval<Reach>()(Point(), Point()))>
Nodes with_neighbors(const Points& points, const Reach& reach)
{
  Nodes nodes;
  nodes.points = points;
  nodes.neighbor_offsets.push_back(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j && squared_distance(points[i], points[j]) < std::pow(reach(points[i], points[j]), 2))
        nodes.neighbors.push_back(static_cast<std::int32_t>(j));
    nodes.neighbor_offsets.push_back(nodes.neighbors.size());
  }
  return nodes;
}

/// by one radius
Nodes with_neighbors(const Points& points, double radius)
{
  return with_neighbors(points, [radius](const Point&, const Point&) { return radius; });
}

/// expects expansions alone to find all nodes
void expect_complete(const Influence& influence, const Nodes& nodes)
{
  EXPECT_TRUE(influence.is_expansion_complete());
  EXPECT_EQ(number_of_expansions(influence, random_points(1000), 1), 1000u);
  EXPECT_GT(expect_exact(influence, nodes.points), 1000u);
}

/// expects the same nodes as by a look at all, by expansions in some places and from the lists in others
void expect_exact_and_some_expand(const Influence& influence, const Nodes& nodes)
{
  EXPECT_GT(expect_exact(influence, nodes.points, 30), 1000u);
  const Points asked = random_points(400);
  const std::size_t n = number_of_expansions(influence, asked, 1);
  EXPECT_GT(n, 0u);
  EXPECT_LT(n, asked.size());
}

TEST(Influence_expansion, expansion_in_a_convex_domain_is_complete)
{
  const Nodes nodes = place(square(), [](const Point&) { return 0.03; });
  const Influence influence(nodes, 2.5 * 0.03, expansion);
  EXPECT_FALSE(Influence(nodes, 2.5 * 0.03).is_expansion_complete()) << "it was not asked for";
  expect_complete(influence, nodes);
}

TEST(Influence_expansion, expansion_with_radii_of_graded_nodes)
{
  const Nodes nodes = place(square(), graded);
  const Influence influence(nodes, radii(nodes, 2.), expansion);
  expect_complete(influence, nodes);
}

TEST(Influence_expansion, expansion_near_a_hole)
{
  const CDT cdt = square_with_hole();
  const Nodes uniform = place(cdt, [](const Point&) { return 0.03; });
  // from no node are those beyond the hole in reach
  const Influence narrow(uniform, 0.05, expansion);
  EXPECT_EQ(number_of_expansions(narrow, random_points(1000), 1), 1000u);
  EXPECT_GT(expect_exact(narrow, uniform.points, 100), 1000u);
  for (double radius : {0.2, 0.5})
    expect_exact_and_some_expand(Influence(uniform, radius, expansion), uniform);
  const Nodes nodes = place(cdt, graded);
  expect_exact_and_some_expand(Influence(nodes, radii(nodes, 2.5), expansion), nodes);
}

TEST(Influence_expansion, expansion_near_a_notch)
{
  // so small that neighbour sets do not reach over the notch everywhere
  const Nodes uniform = place(notched(), [](const Point&) { return 0.01; });
  for (double radius : {0.03, 0.2})
    expect_exact_and_some_expand(Influence(uniform, radius, expansion), uniform);
  const Nodes nodes = place(notched(), [](const Point& p) { return 0.008 + 0.1 * std::abs(p.x() - 0.5); });
  expect_exact_and_some_expand(Influence(nodes, radii(nodes, 2.5), expansion), nodes);
}

TEST(Influence_expansion, a_notch_is_where_a_plain_expansion_would_miss_nodes)
{
  // without the nodes between, the neighbour sets do not reach over the notch
  const Nodes nodes = place(notched(), [](const Point&) { return 0.008; });
  const Influence influence(nodes, 0.06, expansion);
  EXPECT_FALSE(influence.is_expansion_complete());
  Influence::Query query(influence);
  Numbers found;
  query(Point(0.495, 0.9), 1, found);
  EXPECT_EQ(found, brute_force(influence, Point(0.495, 0.9), 1));
  EXPECT_EQ(query.number_of_fallbacks(), 1u);
  query(Point(0.1, 0.1), 1, found);
  EXPECT_EQ(query.number_of_fallbacks(), 1u) << "far from the notch";
}

TEST(Influence_expansion, expansion_where_neighbour_sets_do_not_suffice)
{
  // random nodes have voids, those of the second radius no neighbours at all
  const Points points = random_points(800);
  for (double radius : {0.08, 0.05, 0.03, 1e-9}) {
    const Nodes nodes = with_neighbors(points, radius);
    const Influence influence(nodes, 0.1, expansion);
    EXPECT_GT(expect_exact(influence, points), 1000u);
    EXPECT_EQ(influence.is_expansion_complete(), false);
  }
  // every second of a node's neighbours forgets it
  Nodes lame = with_neighbors(points, 0.12);
  for (std::size_t k = 0; k < lame.neighbors.size(); k += 2)
    lame.neighbors[k] = lame.neighbors[k + 1 < lame.neighbors.size() ? k + 1 : 0];
  EXPECT_GT(expect_exact(Influence(lame, 0.1, expansion), points), 1000u);
}

// A graded radius is a bound that nodes of large discs set for an expansion; what lies in its way matters for them too.
// These nodes are random, and so is each radius, and the neighbour sets are too short in about every place.
TEST(Influence_expansion, expansion_with_random_radii_where_neighbour_sets_do_not_suffice)
{
  std::size_t expanded = 0, asked = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(random_seeds::seed(seed));
    std::uniform_real_distribution<double> uniform(0, 1);
    Points points;
    std::vector<double> radii;
    for (int i = 0; i < 600; ++i) {
      const double x = uniform(random);
      points.emplace_back(x, uniform(random));
      radii.push_back((0.05 + 0.15 * x) * (0.6 + 0.8 * uniform(random)));
    }
    const auto reach = [](const Point& p, const Point& q) { return 0.05 + 0.025 * (p.x() + q.x()); };
    const Influence influence(with_neighbors(points, reach), radii, expansion);
    Points places;
    for (int k = 0; k < 1000; ++k) {
      const double x = uniform(random);
      places.emplace_back(x, uniform(random));
    }
    for (double factor : {1., 0.4}) {
      expanded += number_of_expansions(influence, places, factor);
      asked += places.size();
    }
  }
  EXPECT_GT(expanded, 100u);
  EXPECT_LT(expanded, asked);
}

TEST(Influence_expansion, in_any_unit_and_far_from_the_origin)
{
  const struct { double width, origin; } cases[] = {{1e-9, 0}, {1e9, 0}, {1, 1e6}, {1e-9, 1e-3}};
  for (const auto& c : cases) {
    const Points points = random_points(600, c.width, c.origin);
    const Influence influence(with_neighbors(points, 0.12 * c.width), 0.1 * c.width, expansion);
    EXPECT_GT(expect_exact(influence, points), 1000u) << c.width << ' ' << c.origin;
    std::vector<double> radii;
    for (std::size_t i = 0; i < points.size(); ++i)
      radii.push_back(c.width * (0.04 + 0.01 * static_cast<double>(i % 7)));
    const Influence other(with_neighbors(points, 0.2 * c.width), radii, expansion);
    EXPECT_GT(expect_exact(other, points), 1000u) << c.width << ' ' << c.origin;
    for (const Influence& asked : {influence, other})
      EXPECT_GT(number_of_expansions(asked, random_points(1000, c.width, c.origin), 1), 100u) << c.width;
  }
}

TEST(Influence_expansion, expansion_with_coincident_nodes_and_those_in_line)
{
  Points points = random_points(300);
  for (std::size_t k = 0; k < 100; ++k)
    points.push_back(points[3 * k]);
  const Influence influence(with_neighbors(points, 0.3), 0.1, expansion);
  EXPECT_GT(expect_exact(influence, points), 1000u);
  Points in_line;
  for (int k = 0; k < 50; ++k)
    in_line.emplace_back(0.1 * k, 0.);
  EXPECT_GT(expect_exact(Influence(with_neighbors(in_line, 0.15), 0.35, expansion), in_line), 100u);
  for (const Points& points : {Points{{0, 0}, {1, 3}}, Points{{0, 0}, {1, 3}, {-1, 1}}, Points{{0, 0}, {1, 3}, {2, 6}}})
    for (double reach : {1e-3, 4., 1e3})
      EXPECT_GT(expect_exact(Influence(with_neighbors(points, reach), 2., expansion), points), 0u);
  const Points one{{1, 1}};
  EXPECT_GT(expect_exact(Influence(with_neighbors(one, 1), 0.35, expansion), one), 0u);
  EXPECT_EQ(expect_exact(Influence(with_neighbors(Points(), 1), 0.35, expansion), Points()), 0u);
}

TEST(Influence_expansion, packed_bubbles_comply_with_the_condition_of_the_fill_distance)
{
  // R > 2 F, with F from a fine grid of points, is what the manual promises a convex domain
  const Nodes nodes = place(square(), [](const Point&) { return 0.05; });
  const Influence influence(nodes, 0.1, expansion);
  double fill_distance = 0;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j <= 200; ++j) {
      const Point p(i / 200., j / 200.);
      const Point& q = nodes.points[static_cast<std::size_t>(influence.nearest_node(p))];
      fill_distance = (std::max)(fill_distance, std::sqrt(squared_distance(p, q)));
    }
  EXPECT_GT(nodes.neighbor_radius * 0.05, 2 * fill_distance);
  EXPECT_LT(0.05, 2 * fill_distance) << "a grid of points that is finer than the nodes";
  EXPECT_TRUE(influence.is_expansion_complete());
}

/// asks by four threads, each in an order of its own, and returns how many queries an expansion alone answered
std::size_t expect_same_by_threads(const Influence& influence, const Points& asked, double factor)
{
  std::vector<std::vector<Numbers>> found(4);
  std::vector<std::size_t> fallbacks(found.size());
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < found.size(); ++t)
    threads.emplace_back([&, t] {
      Influence::Query query(influence);
      for (std::size_t k = 0; k < asked.size(); ++k) {
        Numbers result;
        query(asked[(k + t * asked.size() / 4) % asked.size()], factor, result);
        found[t].push_back(result);
      }
      fallbacks[t] = query.number_of_fallbacks();
    });
  for (std::thread& t : threads)
    t.join();
  for (std::size_t t = 0; t < found.size(); ++t)
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const std::size_t place = (k + t * asked.size() / 4) % asked.size();
      EXPECT_EQ(found[t][k], found[0][place]);
      EXPECT_EQ(fallbacks[t], fallbacks[0]);
      if (t == 0) {
        EXPECT_EQ(found[0][k], brute_force(influence, asked[k], factor));
      }
    }
  return asked.size() - fallbacks[0];
}

TEST(Influence_expansion, threads_find_the_same)
{
  const Nodes nodes = place(square_with_hole(), graded);
  const Points asked = places(nodes.points, 500);
  for (double factor : {1., 0.9}) {
    expect_same_by_threads(Influence(nodes, radii(nodes, 2.)), asked, factor);
    const std::size_t expanded = expect_same_by_threads(Influence(nodes, radii(nodes, 2.), expansion), asked, factor);
    EXPECT_GT(expanded, asked.size() / 4);
    EXPECT_LT(expanded, asked.size());
  }
  // larger than what neighbour sets were looked at for
  EXPECT_EQ(expect_same_by_threads(Influence(nodes, radii(nodes, 2.), expansion), asked, 1.3), 0u);
}

TEST(Influence_expansion, bad_neighbour_sets_are_told)
{
  using Invalid = std::invalid_argument;
  const Points points{{0, 0}, {1, 0}};
  Nodes nodes = with_neighbors(points, 2);
  expect_throw<Invalid>([&] { Influence(nodes, -3., expansion); }, {"parameter radius = -3"});
  nodes.neighbors[1] = 7;
  expect_throw<Invalid>([&] { Influence(nodes, 1., expansion); }, {"a neighbour set has the index 7, of 2 nodes"});
  nodes.neighbor_offsets.clear();
  expect_throw<Invalid>([&] { Influence(nodes, 1., expansion); },
                        {"the 2 nodes have no neighbour sets to expand over"});
  EXPECT_EQ(Influence(nodes, 1.).size(), 2u) << "which buckets do not need";
}

} // namespace test_influence_expansion
