// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Moving least squares on awkward nodes: few of them, along a line, in tiny and huge units, far from the origin, and
// with coordinates that no `double` is. And who keeps the nodes.

#include "expect_throw.h"
#include "random_seeds.h"
#include "shape_functions.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <random>

namespace test_moving_least_squares_nodes {

using namespace shape_functions;
namespace P = CGAL::parameters;
using Error = CGAL::Deficient_support_error_2;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

std::vector<Point> random_points(std::size_t n, unsigned k)
{
  std::mt19937 random(random_seeds::seed(k));
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = uniform(random);
    points.push_back(Point(x, uniform(random)));
  }
  return points;
}

std::vector<Point> moved(std::vector<Point> points, double scale, double offset)
{
  for (Point& p : points)
    p = Point(scale * (p.x() + offset), scale * (p.y() + offset));
  return points;
}

/// expects polynomials of the basis at all points, with two derivatives: but for rounding errors, which the condition
/// number multiplies, and each derivative by its root again
void expect_reproduction(const Influence& influence, Basis basis, const std::vector<Point>& points)
{
  const Mls mls(influence, P::mls_basis(basis));
  Shapes s;
  for (const Point& p : points) {
    mls(p, 2, s);
    const double bound = 16 * std::numeric_limits<double>::epsilon() * s.condition_number;
    EXPECT_LT(reproduction_error(influence, p, s, basis, true, 0), bound) << p;
    if (basis != Basis::CONSTANT) { // whose derivatives are differences of large numbers next to the rim of a lone disc
      EXPECT_LT(reproduction_error(influence, p, s, basis, true), bound * s.condition_number) << p;
    }
  }
}

TEST(Awkward_nodes, enlargement_does_not_depend_on_the_unit_or_the_origin)
{
  const std::vector<Point> nodes = random_points(200, 1), points = random_points(400, 2);
  const struct { double scale, offset; } cases[] = {{1e-9, 0}, {1e9, 0}, {1, 1e6}, {1e-9, 1e6}, {1e9, 1e6}};
  for (Basis basis : bases) {
    const Influence influence(nodes, 0.07);
    const Mls mls(influence, P::mls_basis(basis));
    for (const auto& c : cases) {
      const Influence other(moved(nodes, c.scale, c.offset), 0.07 * c.scale);
      const Mls other_mls(other, P::mls_basis(basis));
      const std::vector<Point> others = moved(points, c.scale, c.offset);
      expect_reproduction(other, basis, others);
      int enlarged = 0, differ = 0;
      Shapes s, t;
      for (std::size_t i = 0; i < points.size(); ++i) {
        mls(points[i], 1, s);
        other_mls(others[i], 1, t);
        enlarged += s.enlargement > 1;
        differ += s.nodes != t.nodes || std::abs(s.enlargement / t.enlargement - 1) > 1e-9;
      }
      EXPECT_GT(enlarged, 10) << c.scale << ' ' << c.offset;
      EXPECT_LE(differ, c.offset > 0 ? 1 : 0) << "but for a node that rounding moves over the rim of a disc";
    }
  }
}

TEST(Awkward_nodes, as_few_as_the_basis_has_polynomials)
{
  const std::vector<Point> points = random_points(50, 3);
  const std::vector<Point> one{Point(0.3, 0.4)}, three{Point(0, 0), Point(1, 0.2), Point(0.3, 1)},
    six{Point(0, 0), Point(1, 0), Point(0, 1), Point(0.5, 0), Point(0, 0.5), Point(0.5, 0.6)};
  for (double radius : {0.1, 0.7, 2.}) {
    expect_reproduction(Influence(one, radius), Basis::CONSTANT, points);
    expect_reproduction(Influence(three, radius), Basis::LINEAR, points);
    expect_reproduction(Influence(six, radius), Basis::QUADRATIC, points);
  }
  const std::vector<double> values{5, 6, 7};
  const Influence influence(three, 2);
  const Mls mls(influence);
  for (std::size_t i = 0; i < 3; ++i) // one polynomial has these values
    EXPECT_NEAR(mls.value(three[i], values), values[i], 1e-12);
}

TEST(Awkward_nodes, fewer_than_polynomials_or_along_a_line_are_refused)
{
  const std::vector<Point> one{Point(0.3, 0.4)}, two{Point(0, 0), Point(1, 2)},
    in_line{Point(0, 0), Point(1, 2), Point(2, 4), Point(0.1, 0.2), Point(0.7, 1.4), Point(-3, -6)};
  for (double scale : {1e-9, 1., 1e9})
    for (const auto& nodes : {one, two, in_line}) {
      const Influence influence(moved(nodes, scale, 0), 1.5 * scale);
      const std::vector<double> values(nodes.size(), 4);
      const std::vector<Point> points = moved(random_points(20, 4), scale, 0);
      for (auto policy : {Deficient_support::ENLARGE, Deficient_support::REPORT})
        for (Basis basis : {Basis::LINEAR, Basis::QUADRATIC}) {
          const Mls mls(influence, P::mls_basis(basis).deficient_support(policy));
          expect_throw<Error>([&] { mls.evaluate(points, values); }, {"would not help all of 20 such points"});
          expect_throw<Error>([&] { mls.value(points[1], values); }, {"would not help"});
        }
      const auto constants = Mls(influence, P::mls_basis(Basis::CONSTANT)).evaluate(points, values);
      for (double v : constants.values)
        EXPECT_NEAR(v, 4, 1e-14);
    }
}

// The results of a kernel with exact constructions are those of the rounded points: nodes are thirds, which no double
// is, and so are the points.
TEST(Awkward_nodes, with_exact_constructions)
{
  std::vector<Exact::Point_2> nodes, points;
  std::vector<Point> rounded_nodes, rounded_points;
  const auto add = [](const std::vector<Point>& from, auto& exact, auto& rounded) {
    for (const Point& p : from) {
      exact.push_back(Exact::Point_2(Exact::FT(p.x()) / 3, Exact::FT(p.y()) / 3));
      rounded.push_back(Point(CGAL::to_double(exact.back().x()), CGAL::to_double(exact.back().y())));
    }
  };
  add(random_points(200, 5), nodes, rounded_nodes);
  add(random_points(100, 6), points, rounded_points);
  std::vector<double> values;
  for (const Point& p : rounded_nodes)
    values.push_back(std::sin(9 * p.x()) + p.y());
  const CGAL::Influence_domain_2<Exact> exact_influence(nodes, 0.06);
  const Influence influence(rounded_nodes, 0.06);
  for (Basis basis : bases) {
    const CGAL::Moving_least_squares_2<Exact> exact_mls(exact_influence, P::mls_basis(basis));
    const Mls mls(influence, P::mls_basis(basis));
    const auto exact = exact_mls.evaluate(points, values, 2);
    const auto expected = mls.evaluate(rounded_points, values, 2);
    EXPECT_EQ(exact.values, expected.values);
    EXPECT_EQ(exact.dxy, expected.dxy);
    EXPECT_EQ(exact.number_of_enlarged_supports, expected.number_of_enlarged_supports);
    EXPECT_EQ(exact_mls.gradient(points[3], values).y(), expected.dy[3]);
  }
}

TEST(Awkward_nodes, are_kept_by_who_needs_them)
{
  const std::vector<Point> nodes = random_points(100, 7);
  const std::vector<double> values(100, 3);
  const Mls of_temporary(Influence(nodes, 0.4));
  EXPECT_NEAR(of_temporary.value(Point(0.5, 0.5), values), 3, 1e-13);
  auto influence = std::make_unique<Influence>(nodes, 0.4);
  auto mls = std::make_unique<Mls>(*influence);
  EXPECT_EQ(&mls->influence().point(5), &influence->point(5)) << "the nodes are not copied";
  influence.reset();
  EXPECT_NEAR(mls->value(Point(0.5, 0.5), values), 3, 1e-13);
  const Mls copy = *mls;
  mls.reset();
  EXPECT_NEAR(copy.value(Point(0.5, 0.5), values), 3, 1e-13);
}

} // namespace test_moving_least_squares_nodes
