// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Shape functions of moving least squares where the nodes suffice: what they reproduce, their derivatives, their
// smoothness, and that bits do not depend on the order of questions or on threads.

#include "domains.h"
#include "random_seeds.h"
#include "shape_functions.h"

#include <CGAL/npbs_place_nodes.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace test_moving_least_squares {

using namespace shape_functions;
namespace P = CGAL::parameters;

/// nodes of a graded square with a hole, and points in it
struct Nodes
{
  std::vector<Point> nodes;
  std::vector<double> sizes;
  std::vector<Point> points;
};

const Nodes& graded()
{
  static const Nodes made = [] {
    const domains::CDT cdt = domains::make({domains::square(-1, -1, 2), domains::polygon(0.1, 0, 0.4, 24)});
    const auto d = [](const Point& p) { return 0.02 + 0.1 * std::hypot(p.x() - 0.1, p.y()); };
    const auto set = CGAL::npbs_place_nodes(cdt, P::sizing_function(d));
    Nodes n{set.points, set.sizes, {}};
    std::mt19937 random(random_seeds::seed(5));
    std::uniform_real_distribution<double> uniform(-1., 1.);
    while (n.points.size() < 3000) {
      const Point p(uniform(random), uniform(random));
      if (std::hypot(p.x() - 0.1, p.y()) > 0.4)
        n.points.push_back(p);
    }
    // corners, edges, nodes
    for (double x : {-1., 0.3, 1.})
      n.points.push_back(Point(x, -1));
    n.points.insert(n.points.end(), n.nodes.begin(), n.nodes.end());
    return n;
  }();
  return made;
}

std::vector<double> times(std::vector<double> v, double factor)
{
  for (double& x : v)
    x *= factor;
  return v;
}

std::vector<Point> moved(std::vector<Point> points, double scale, double x, double y)
{
  for (Point& p : points)
    p = Point(scale * p.x() + x, scale * p.y() + y);
  return points;
}

Influence influence_of(const Nodes& n, double factor = 2.5) { return Influence(n.nodes, times(n.sizes, factor)); }

/// as many of the points, all over the domain
std::vector<Point> some(const std::vector<Point>& points, std::size_t n)
{
  return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n)};
}

TEST(Moving_least_squares, weights_are_the_documented_functions)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  for (int i = 0; i < 1000; ++i) {
    const double q = i / 1000., s = q * q, b = 6.25;
    EXPECT_NEAR(quartic_spline_weight(q).w, 1 - 6 * s + 8 * s * q - 3 * s * s, 1e-14);
    EXPECT_NEAR(cubic_spline_weight(q).w, q < 0.5 ? 2. / 3 - 4 * s + 4 * s * q : 4. / 3 * std::pow(1 - q, 3),
                1e-14);
    EXPECT_NEAR(gaussian_weight(q).w,
                std::exp(-b * s) - std::exp(-b) * (1 - b * (s - 1) + b * b * (s - 1) * (s - 1) / 2), 1e-14);
    // next to the rim too they are positive and decrease
    for (const Radial_weight& w : {quartic_spline_weight(q), cubic_spline_weight(q),
                                   gaussian_weight(q), gaussian_weight(1 - q * 1e-6 - 1e-9)}) {
      EXPECT_GT(w.w, 0);
      EXPECT_LT(w.g, 0);
    }
  }
}

TEST(Moving_least_squares, reproduces_its_basis_with_two_derivatives)
{
  const Influence influence = influence_of(graded());
  for (Basis basis : bases)
    for (Weight weight : weights) {
      const Mls mls(influence, P::mls_basis(basis).mls_weight(weight));
      Shapes s;
      double worst = 0;
      for (const Point& p : graded().points) {
        mls(p, 2, s);
        EXPECT_TRUE(std::is_sorted(s.nodes.begin(), s.nodes.end()));
        EXPECT_EQ(s.enlargement, 1);
        worst = (std::max)(worst, reproduction_error(influence, p, s, basis));
      }
      EXPECT_LT(worst, 1e-12) << int(basis) << ' ' << int(weight);
      EXPECT_GT(worst, 0) << "what is compared must not be empty";
    }
}

TEST(Moving_least_squares, in_any_unit_of_length_and_far_from_the_origin)
{
  const struct { double scale, x, y; } cases[] = {{1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e6, -3e5}, {1e-9, -1e-4, 1e-5},
                                                  {1e-150, 0, 0}, {1e150, 0, 0}};
  for (const auto& c : cases) {
    const Influence influence(moved(graded().nodes, c.scale, c.x, c.y), times(graded().sizes, 2.5 * c.scale));
    const std::vector<Point> points = moved(some(graded().points, 500), c.scale, c.x, c.y);
    for (Basis basis : bases) {
      const Mls mls(influence, P::mls_basis(basis));
      Shapes s;
      double worst = 0;
      for (const Point& p : points) {
        mls(p, 2, s);
        worst = (std::max)(worst, reproduction_error(influence, p, s, basis));
      }
      EXPECT_LT(worst, 1e-12) << c.scale << ' ' << int(basis);
    }
  }
}

TEST(Moving_least_squares, a_power_of_two_as_unit_changes_no_bit)
{
  const double unit = std::ldexp(1., -40);
  const Influence one = influence_of(graded());
  const Influence other(moved(graded().nodes, unit, 0, 0), times(graded().sizes, 2.5 * unit));
  const Mls mls(one, P::mls_basis(Basis::QUADRATIC)), other_mls(other, P::mls_basis(Basis::QUADRATIC));
  Shapes s, t;
  for (const Point& p : some(graded().points, 300)) {
    mls(p, 2, s);
    other_mls(Point(p.x() * unit, p.y() * unit), 2, t);
    EXPECT_EQ(s.nodes, t.nodes);
    EXPECT_EQ(s.values, t.values);
    EXPECT_EQ(s.dx, times(t.dx, unit));
    EXPECT_EQ(s.dxy, times(times(t.dxy, unit), unit));
  }
}

TEST(Moving_least_squares, values_and_gradients_of_polynomials)
{
  const Influence influence = influence_of(graded(), 3);
  const Mls mls(influence, P::mls_basis(Basis::QUADRATIC));
  std::vector<double> values;
  for (const Point& p : graded().nodes)
    values.push_back(1 - 2 * p.x() + p.y() + 3 * p.x() * p.x() - p.x() * p.y() + 0.5 * p.y() * p.y());
  for (const Point& p : some(graded().points, 200)) {
    const double x = p.x(), y = p.y();
    EXPECT_NEAR(mls.value(p, values), 1 - 2 * x + y + 3 * x * x - x * y + 0.5 * y * y, 1e-12);
    EXPECT_NEAR(mls.gradient(p, values).x(), -2 + 6 * x - y, 1e-11);
    EXPECT_NEAR(mls.gradient(p, values).y(), 1 - x + y, 1e-11);
  }
  const auto all = mls.evaluate(some(graded().points, 200), values, 2);
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    EXPECT_NEAR(all.dxx[i], 6, 1e-9);
    EXPECT_NEAR(all.dxy[i], -1, 1e-9);
    EXPECT_NEAR(all.dyy[i], 1, 1e-9);
  }
}

// Differences over h and h/2, extrapolated, miss a derivative by O(h^4) where no node's support ends and no
// spline changes its formula; these points are few and are left out.
TEST(Moving_least_squares, derivatives_are_those_of_the_shape_functions)
{
  const Influence influence = influence_of(graded());
  for (Basis basis : bases)
    for (Weight weight : weights) {
      const Mls mls(influence, P::mls_basis(basis).mls_weight(weight));
      Shapes s;
      std::array<Shapes, 4> around;
      double worst = 0;
      int compared = 0;
      for (const Point& p : some(graded().points, 300)) {
        mls(p, 2, s);
        const double h = 0.003 * unit(influence, s);
        const bool is_smooth = std::all_of(s.nodes.begin(), s.nodes.end(), [&](auto i) {
          const double r = std::sqrt(CGAL::squared_distance(p, influence.point(i)));
          return std::abs(r - influence.radius(i)) > 2 * h && std::abs(r - influence.radius(i) / 2) > 2 * h &&
                 r > 20 * h;
        });
        if (!is_smooth)
          continue;
        for (int direction = 0; direction < 2; ++direction) {
          const double steps[] = {h, -h, h / 2, -h / 2};
          for (int k = 0; k < 4; ++k)
            mls(direction == 0 ? Point(p.x() + steps[k], p.y()) : Point(p.x(), p.y() + steps[k]), 1, around[k]);
          if (around[0].nodes != s.nodes || around[1].nodes != s.nodes)
            continue; // a support ends near enough to be crossed
          ++compared;
          const auto difference = [&](std::vector<double> Shapes::*a, std::size_t i) {
            const double wide = ((around[0].*a)[i] - (around[1].*a)[i]) / (2 * h);
            const double near = ((around[2].*a)[i] - (around[3].*a)[i]) / h;
            return (4 * near - wide) / 3;
          };
          const double u = unit(influence, s);
          for (std::size_t i = 0; i < s.nodes.size(); ++i) {
            const auto& first = direction == 0 ? s.dx : s.dy;
            worst = (std::max)(worst, std::abs(difference(&Shapes::values, i) - first[i]) * u);
            const auto& x_second = direction == 0 ? s.dxx : s.dxy;
            worst = (std::max)(worst, std::abs(difference(&Shapes::dx, i) - x_second[i]) * u * u);
            const auto& y_second = direction == 0 ? s.dxy : s.dyy;
            worst = (std::max)(worst, std::abs(difference(&Shapes::dy, i) - y_second[i]) * u * u);
          }
        }
      }
      EXPECT_GT(compared, 200);
      EXPECT_LT(worst, 2e-7) << int(basis) << ' ' << int(weight);
    }
}

// Across the rim of a support nothing jumps: at points 2 delta apart values and both orders of derivatives differ by
// O(delta) only.
TEST(Moving_least_squares, are_smooth_across_the_rim_of_a_support)
{
  const Influence influence = influence_of(graded());
  for (Basis basis : bases)
    for (Weight weight : weights) {
      const Mls mls(influence, P::mls_basis(basis).mls_weight(weight));
      Shapes in, out;
      int crossed = 0;
      for (std::int32_t node = 0; node < 400; node += 7) {
        const Point c = influence.point(node);
        for (double angle : {0.3, 2., 4.}) {
          const double r = influence.radius(node), delta = 1e-8 * r;
          const auto at = [&](double q) { return Point(c.x() + q * std::cos(angle), c.y() + q * std::sin(angle)); };
          if (std::abs(at(r).x()) > 1 || std::abs(at(r).y()) > 1 || std::hypot(at(r).x() - 0.1, at(r).y()) < 0.4)
            continue;
          mls(at(r - delta), 2, in);
          mls(at(r + delta), 2, out);
          ASSERT_EQ(std::count(in.nodes.begin(), in.nodes.end(), node), 1);
          ASSERT_EQ(std::count(out.nodes.begin(), out.nodes.end(), node), 0);
          ++crossed;
          const double u = unit(influence, in);
          for (auto i : in.nodes)
            for (int k = 0; k < 6; ++k) {
              const double length = k == 0 ? 1 : k < 3 ? u : u * u;
              EXPECT_NEAR(of_node(in, *arrays(in)[k], i) * length, of_node(out, *arrays(out)[k], i) * length, 1e-5)
                << int(basis) << ' ' << int(weight) << ' ' << k;
            }
        }
      }
      EXPECT_GT(crossed, 50);
    }
}

TEST(Moving_least_squares, bits_depend_on_the_point_alone)
{
  const Influence influence = influence_of(graded());
  const Mls mls(influence, P::mls_basis(Basis::QUADRATIC));
  const std::vector<Point> points = some(graded().points, 1000);
  std::vector<double> values;
  for (const Point& p : graded().nodes)
    values.push_back(std::sin(3 * p.x()) * p.y());
  const auto all = mls.evaluate(points, values, 2);
  Mls::Query query(influence);
  Shapes s, fresh;
  for (std::size_t i = points.size(); i-- > 0;) { // from the last, by one search
    mls(points[i], 2, query, s);
    Shapes other;
    mls(points[i], 0, other);
    EXPECT_EQ(s.nodes, other.nodes);
    EXPECT_EQ(s.values, other.values);
    EXPECT_TRUE(other.dx.empty() && other.dyy.empty());
    EXPECT_EQ(mls.value(points[i], values), all.values[i]);
    EXPECT_EQ(mls.gradient(points[i], values).y(), all.dy[i]);
  }
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto parallel = mls.evaluate(points, values, 2, P::concurrency_tag(CGAL::Parallel_tag()));
    EXPECT_EQ(parallel.values, all.values);
    EXPECT_EQ(parallel.dx, all.dx);
    EXPECT_EQ(parallel.dxy, all.dxy);
    EXPECT_EQ(parallel.dyy, all.dyy);
  }
#endif
}

TEST(Moving_least_squares, bits_do_not_depend_on_how_nodes_are_searched)
{
  const domains::CDT cdt = domains::make({domains::square(0, 0, 1)});
  const auto nodes = CGAL::npbs_place_nodes(cdt, P::sizing_function(0.08));
  const Influence buckets(nodes, times(nodes.sizes, 2.5));
  const Influence expansion(nodes, times(nodes.sizes, 2.5),
                            P::influence_search(CGAL::Influence_search::EXPANSION));
  const Mls one(buckets), other(expansion);
  Shapes s, t;
  for (int i = 0; i <= 30; ++i)
    for (int j = 0; j <= 30; ++j) {
      one(Point(i / 30., j / 30.), 1, s);
      other(Point(i / 30., j / 30.), 1, t);
      EXPECT_EQ(s.nodes, t.nodes);
      EXPECT_EQ(s.values, t.values);
      EXPECT_EQ(s.dx, t.dx);
    }
}

} // namespace test_moving_least_squares
