// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Influence domains: both ways of searching find the very nodes that a look at all of them finds.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/npbs_place_nodes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points = std::vector<Point>;
using Influence = CGAL::Influence_domain_2<Kernel>;
using Nodes = CGAL::Node_set_2<Point>;
using Numbers = std::vector<std::int32_t>;

const double pi = std::acos(-1.);
const auto expansion = CGAL::parameters::influence_search(CGAL::Influence_search::EXPANSION);

double squared_distance(const Point& p, const Point& q)
{
  return (p.x() - q.x()) * (p.x() - q.x()) + (p.y() - q.y()) * (p.y() - q.y());
}

Numbers brute_force(const Influence& influence, const Point& p, double factor)
{
  Numbers found;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(influence.size()); ++i)
    if (squared_distance(influence.point(i), p) < factor * influence.radius(i) * (factor * influence.radius(i)))
      found.push_back(i);
  return found;
}

/// points in `box` widened, near nodes, on nodes, and far away
Points places(const Points& nodes, std::size_t n)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  CGAL::Bbox_2 box;
  for (const Point& p : nodes)
    box += p.bbox();
  const double w = nodes.empty() ? 1 : (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), 1e-300});
  const double x0 = nodes.empty() ? 0 : box.xmin(), y0 = nodes.empty() ? 0 : box.ymin();
  Points result{Point(x0 + 1e6 * w, y0), Point(x0, y0 - 1e12 * w), Point(x0 + 3 * w, y0 + 3 * w)};
  for (std::size_t k = 0; k < n; ++k) {
    result.emplace_back(x0 + w * (1.4 * uniform(random) - 0.2), y0 + w * (1.4 * uniform(random) - 0.2));
    if (!nodes.empty()) {
      const Point& p = nodes[random() % nodes.size()];
      const double distance = w * std::pow(10, -6 * uniform(random)), angle = 2 * pi * uniform(random);
      result.push_back(p);
      result.emplace_back(p.x() + distance * std::cos(angle), p.y() + distance * std::sin(angle));
    }
  }
  return result;
}

/// compares with a look at all nodes, and returns how many nodes were found
std::size_t expect_exact(const Influence& influence, const Points& points, std::size_t number_of_places = 300)
{
  Influence::Query query(influence);
  Numbers found;
  std::size_t total = 0;
  for (const Point& p : places(points, number_of_places)) {
    for (double factor : {1., 0.37, 1.1, 2.9, 1000.}) {
      const Numbers expected = brute_force(influence, p, factor);
      query(p, factor, found);
      EXPECT_EQ(found, expected) << p << " factor " << factor;
      if (testing::Test::HasFailure())
        return total;
      total += found.size();
    }
    Numbers stateless;
    influence.nodes_at(p, std::back_inserter(stateless));
    EXPECT_EQ(stateless, brute_force(influence, p, 1)) << p;
    const std::int32_t nearest = influence.nearest_node(p);
    std::int32_t expected = -1;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (expected < 0 ||
          squared_distance(points[i], p) < squared_distance(points[static_cast<std::size_t>(expected)], p))
        expected = static_cast<std::int32_t>(i);
    EXPECT_EQ(nearest, expected) << p;
  }
  return total;
}

Points random_points(std::size_t n, double width = 1, double x0 = 0)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, width);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform(random);
    points.emplace_back(x0 + x, x0 + uniform(random));
  }
  return points;
}

using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

CDT square()
{
  CDT cdt;
  const Points outline{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  return cdt;
}

CDT square_with_hole()
{
  CDT cdt = square();
  Points hole;
  for (int k = 0; k < 24; ++k)
    hole.emplace_back(0.5 + 0.15 * std::cos(k * pi / 12), 0.5 + 0.15 * std::sin(k * pi / 12));
  cdt.insert_constraint(hole.begin(), hole.end(), true);
  return cdt;
}

/// with a notch that is narrower than a neighbour set
CDT notched()
{
  CDT cdt;
  const Points outline{{0, 0}, {1, 0}, {1, 1}, {0.51, 1}, {0.5, 0.3}, {0.49, 1}, {0, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  return cdt;
}

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

template <class Call>
std::string message_of(const Call& call)
{
  try {
    call();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "no exception";
}

#define EXPECT_TELLS(call, text) \
  EXPECT_NE(message_of([&] { call; }).find(text), std::string::npos) << message_of([&] { call; })

} // namespace

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

TEST(Influence_domain, expansion_in_a_convex_domain_is_complete)
{
  const Nodes nodes = place(square(), [](const Point&) { return 0.03; });
  const Influence influence(nodes, 2.5 * 0.03, expansion);
  EXPECT_TRUE(influence.is_expansion_complete());
  EXPECT_FALSE(Influence(nodes, 2.5 * 0.03).is_expansion_complete()) << "it was not asked for";
  Influence::Query query(influence);
  Numbers found;
  for (const Point& p : random_points(1000)) {
    query(p, 1, found);
    EXPECT_EQ(found, brute_force(influence, p, 1));
  }
  EXPECT_EQ(query.number_of_fallbacks(), 0u);
  EXPECT_GT(expect_exact(influence, nodes.points), 1000u);
}

TEST(Influence_domain, expansion_with_radii_of_graded_nodes)
{
  const Nodes nodes = place(square(), graded);
  const Influence influence(nodes, radii(nodes, 2.), expansion);
  EXPECT_TRUE(influence.is_expansion_complete());
  Influence::Query query(influence);
  Numbers found;
  for (const Point& p : random_points(1000)) {
    query(p, 1, found);
    EXPECT_EQ(found, brute_force(influence, p, 1));
  }
  EXPECT_EQ(query.number_of_fallbacks(), 0u);
  EXPECT_GT(expect_exact(influence, nodes.points), 1000u);
}

TEST(Influence_domain, expansion_near_a_hole_and_a_notch)
{
  for (const CDT& cdt : {square_with_hole(), notched()}) {
    const Nodes uniform = place(cdt, [](const Point&) { return 0.03; });
    // so wide that nodes beyond the hole, or the notch, are in reach
    for (double radius : {0.05, 0.2, 0.5})
      EXPECT_GT(expect_exact(Influence(uniform, radius, expansion), uniform.points, 100), 1000u);
    const Nodes nodes = place(cdt, graded);
    EXPECT_GT(expect_exact(Influence(nodes, radii(nodes, 2.5), expansion), nodes.points, 100), 1000u);
  }
}

TEST(Influence_domain, a_notch_is_where_a_plain_expansion_would_miss_nodes)
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

/// neighbour sets of any points, by one radius
Nodes with_neighbors(const Points& points, double radius)
{
  Nodes nodes;
  nodes.points = points;
  nodes.neighbor_offsets.push_back(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j)
      if (i != j && squared_distance(points[i], points[j]) < radius * radius)
        nodes.neighbors.push_back(static_cast<std::int32_t>(j));
    nodes.neighbor_offsets.push_back(nodes.neighbors.size());
  }
  return nodes;
}

TEST(Influence_domain, expansion_where_neighbour_sets_do_not_suffice)
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

TEST(Influence_domain, expansion_with_coincident_nodes_and_those_in_line)
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
  const Points one{{1, 1}};
  EXPECT_GT(expect_exact(Influence(with_neighbors(one, 1), 0.35, expansion), one), 0u);
  EXPECT_EQ(expect_exact(Influence(with_neighbors(Points(), 1), 0.35, expansion), Points()), 0u);
}

TEST(Influence_domain, packed_bubbles_comply_with_the_condition_of_the_fill_distance)
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

TEST(Influence_domain, threads_find_the_same)
{
  const Nodes nodes = place(square_with_hole(), graded);
  const Points asked = places(nodes.points, 500);
  for (const Influence& influence :
       {Influence(nodes, radii(nodes, 2.)), Influence(nodes, radii(nodes, 2.), expansion)}) {
    std::vector<std::vector<Numbers>> found(4);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < found.size(); ++t)
      threads.emplace_back([&, t] {
        Influence::Query query(influence);
        for (std::size_t k = 0; k < asked.size(); ++k) {
          Numbers result;
          // each in an order of its own
          query(asked[(k + t * asked.size() / 4) % asked.size()], 1.3, result);
          found[t].push_back(result);
        }
      });
    for (std::thread& t : threads)
      t.join();
    for (std::size_t t = 1; t < found.size(); ++t)
      for (std::size_t k = 0; k < asked.size(); ++k)
        ASSERT_EQ(found[t][k], found[0][(k + t * asked.size() / 4) % asked.size()]);
  }
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
  Nodes nodes = with_neighbors(points, 2);
  EXPECT_TELLS(Influence(nodes, -3., expansion), "parameter radius = -3");
  nodes.neighbors[1] = 7;
  EXPECT_TELLS(Influence(nodes, 1., expansion), "a neighbour set has the index 7, of 2 nodes");
  nodes.neighbor_offsets.clear();
  EXPECT_TELLS(Influence(nodes, 1., expansion), "the 2 nodes have no neighbour sets to expand over");
  EXPECT_EQ(Influence(nodes, 1.).size(), 2u) << "which buckets do not need";
}
