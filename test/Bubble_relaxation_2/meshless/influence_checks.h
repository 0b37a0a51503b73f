// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_INFLUENCE_CHECKS_H
#define BUBBLE_RELAXATION_2_TEST_INFLUENCE_CHECKS_H

#include "random_seeds.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Influence_domain_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <vector>

/// What tests of influence domains share: points, and the comparison with a look at all nodes.
namespace influence_checks {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Points = std::vector<Point>;
using Influence = CGAL::Influence_domain_2<Kernel>;
using Numbers = std::vector<std::int32_t>;

const double pi = std::acos(-1.);

inline double squared_distance(const Point& p, const Point& q)
{
  return (p.x() - q.x()) * (p.x() - q.x()) + (p.y() - q.y()) * (p.y() - q.y());
}

inline Numbers brute_force(const Influence& influence, const Point& p, double factor)
{
  Numbers found;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(influence.size()); ++i)
    if (squared_distance(influence.point(i), p) < factor * influence.radius(i) * (factor * influence.radius(i)))
      found.push_back(i);
  return found;
}

/// points in `box` widened, near nodes, on nodes, and far away
inline Points places(const Points& nodes, std::size_t n)
{
  std::mt19937 random(random_seeds::seed(7));
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
inline std::size_t expect_exact(const Influence& influence, const Points& points, std::size_t number_of_places = 300)
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

/// compares with a look at all nodes at some points, and returns how many of them an expansion alone answered
inline std::size_t number_of_expansions(const Influence& influence, const Points& asked, double factor)
{
  Influence::Query query(influence);
  Numbers found;
  for (const Point& p : asked) {
    query(p, factor, found);
    EXPECT_EQ(found, brute_force(influence, p, factor)) << p << " factor " << factor;
  }
  return asked.size() - query.number_of_fallbacks();
}

inline Points random_points(std::size_t n, double width = 1, double x0 = 0)
{
  std::mt19937 random(random_seeds::seed(5));
  std::uniform_real_distribution<double> uniform(0, width);
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = uniform(random);
    points.emplace_back(x0 + x, x0 + uniform(random));
  }
  return points;
}

} // namespace influence_checks

#endif // BUBBLE_RELAXATION_2_TEST_INFLUENCE_CHECKS_H
