// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Sizing fields: limited in their gradation, interpolated, and the minimum of several.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Constant_sizing_field_2.h>
#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/Minimum_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <functional>
#include <string>
#include <thread>

namespace test_sizing_fields {

namespace P = CGAL::parameters;
using domains::CDT;
using domains::Point;
using Size = std::function<double(const Point&)>;

double distance(const Point& p, double x, double y) { return std::hypot(p.x() - x, p.y() - y); }

/// points in the unit square, the same in every run, on a grid of its boundary and anywhere inside
std::vector<Point> probes(int n)
{
  std::mt19937 random(random_seeds::seed(7));
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Point> points;
  for (int k = 0; k < n; ++k) {
    points.emplace_back(uniform(random), uniform(random));
    points.emplace_back(k % 2, uniform(random));
    points.emplace_back(uniform(random), k % 2);
  }
  return points;
}

/// the largest slope of a field between points of the unit square that are near to each other
template <class Field>
double steepest(const Field& h, double reach)
{
  double largest = 0;
  double angle = 0;
  for (const Point& p : probes(20000)) {
    angle += 2.399963; // all directions
    const Point q(p.x() + reach * std::cos(angle), p.y() + reach * std::sin(angle));
    if (q.x() >= 0 && q.y() >= 0 && q.x() <= 1 && q.y() <= 1)
      largest = (std::max)(largest, std::abs(h(q) - h(p)) / distance(q, p.x(), p.y()));
  }
  return largest;
}

CDT square() { return domains::make({domains::square(0, 0, 1)}); }

struct Case
{
  const char* name;
  Size d;
  std::function<double(const Point&, double)> limited; // by g, by hand
};

const std::vector<Case> cases{
  {"jump across a circle", [](const Point& p) { return distance(p, 0.4, 0.55) < 0.25 ? 0.01 : 0.5; },
   [](const Point& p, double g) { return 0.01 + g * (std::max)(0., distance(p, 0.4, 0.55) - 0.25); }},
  {"one corner only", [](const Point& p) { return distance(p, 0, 0) < 1e-6 ? 1e-4 : 1.; },
   [](const Point& p, double g) { return 1e-4 + g * distance(p, 0, 0); }},
  {"one edge only", [](const Point& p) { return p.x() == 0 ? 0.002 : 1.; },
   [](const Point& p, double g) { return 0.002 + g * p.x(); }},
  {"two dips", [](const Point& p) {
     return (std::min)(0.02 + 2 * distance(p, 0.3, 0.3), 0.005 + distance(p, 0.7, 0.6));
   },
   [](const Point& p, double g) {
     return (std::min)(0.02 + g * distance(p, 0.3, 0.3), 0.005 + g * distance(p, 0.7, 0.6));
   }}};

TEST(Gradation_limited_sizing_field, is_no_steeper_than_g_anywhere)
{
  for (const Case& c : cases)
    for (double g : {0.1, 0.3, 1.}) {
      const CGAL::Gradation_limited_sizing_field_2 h(square(), g, P::sizing_function(c.d));
      for (double reach : {1e-4, 0.01, 0.2})
        EXPECT_LE(steepest(h, reach), g * (1 + 1e-6)) << c.name << ", g = " << g << ", reach " << reach;
    }
}

TEST(Gradation_limited_sizing_field, is_near_to_the_largest_one)
{
  for (const Case& c : cases)
    for (double g : {0.1, 0.2, 0.3}) {
      const CGAL::Gradation_limited_sizing_field_2 h(square(), g, P::sizing_function(c.d));
      EXPECT_TRUE(h.is_resolved());
      EXPECT_LE(h.number_of_vertices(), 30000u) << c.name;
      double sum = 0;
      for (const Point& p : probes(2000)) {
        const double ratio = h(p) / c.limited(p, g);
        EXPECT_GT(ratio, 0.75) << c.name << " at " << p << ", g = " << g;
        EXPECT_LT(ratio, 1.5) << c.name << " at " << p << ", g = " << g; // in the dips
        sum += ratio / 6000;
      }
      EXPECT_NEAR(sum, 0.95, 0.08) << c.name << ", g = " << g;
    }
}

TEST(Gradation_limited_sizing_field, leaves_a_gentle_size_alone)
{
  const auto d = [](const Point& p) { return 0.02 + 0.05 * p.x() + 0.03 * p.y(); };
  const CGAL::Gradation_limited_sizing_field_2 h(square(), 0.2, P::sizing_function(d));
  for (const Point& p : probes(1000))
    EXPECT_NEAR(h(p), d(p), 1e-12);
}

TEST(Gradation_limited_sizing_field, does_not_reach_through_a_slot)
{
  // a slot from above: the way from its left to its right leads around its end, in (0.51, 0.1)
  const CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 1}, {0.52, 1}, {0.52, 0.1}, {0.5, 0.1}, {0.5, 1}, {0, 1}}});
  const auto d = [](const Point& p) { return p.x() <= 0.5 ? 0.02 : 1.; };
  const CGAL::Gradation_limited_sizing_field_2 h(cdt, 0.2, P::sizing_function(d));
  EXPECT_NEAR(h(Point(0.5, 0.9)), 0.02, 1e-12);
  EXPECT_GT(h(Point(0.52, 0.9)), 0.02 + 0.2 * 0.8 * 0.8);
  EXPECT_LT(h(Point(0.52, 0.9)), 0.02 + 0.2 * 0.85);
}

TEST(Gradation_limited_sizing_field, sees_a_dip_at_a_vertex)
{
  CDT cdt = square();
  const Point well(0.4137, 0.2711);
  const auto d = [&](const Point& p) { return 1e-3 + distance(p, well.x(), well.y()); };
  cdt.insert(well);
  const CGAL::Gradation_limited_sizing_field_2 h(
    cdt, 0.2, P::sizing_function([&](const Point& p) { return p == well ? 1e-3 : 0.3; }));
  EXPECT_EQ(h(well), 1e-3);
  const CGAL::Gradation_limited_sizing_field_2 steep(cdt, 0.2, P::sizing_function(d));
  EXPECT_EQ(steep(well), 1e-3);
  EXPECT_NEAR(steep(Point(0.8, 0.8)), 1e-3 + 0.2 * distance(well, 0.8, 0.8), 0.03);
}

TEST(Gradation_limited_sizing_field, answers_outside_with_the_nearest_size)
{
  const CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(0.25, 0.25, 0.5)});
  const auto d = [](const Point& p) { return 0.05 + 0.1 * p.x(); };
  const CGAL::Gradation_limited_sizing_field_2 h(cdt, 0.2, P::sizing_function(d));
  EXPECT_NEAR(h(Point(0.26, 0.5)), d(Point(0.25, 0.5)), 1e-12); // in the hole
  EXPECT_NEAR(h(Point(0.6, 0.74)), d(Point(0.6, 0.75)), 1e-12);
  EXPECT_NEAR(h(Point(0.5, 7)), d(Point(0.5, 1)), 1e-12);
  EXPECT_NEAR(h(Point(-3, -7)), d(Point(0, 0)), 1e-12);
  EXPECT_NEAR(h(Point(1e6, 0.3)), d(Point(1, 0)), 1e-12);
  EXPECT_TRUE(std::isnan(h(Point(std::nan(""), 0))));
}

TEST(Gradation_limited_sizing_field, has_the_same_bits_in_any_order_and_thread)
{
  const std::vector<domains::Outline> outlines = domains::random_star(random_seeds::seed());
  const auto d = [](const Point& p) { return p.x() > 0.3 ? 0.3 : 0.01; };
  const CDT cdt = domains::make(outlines), other = domains::make({outlines[1], outlines[0]});
  const CGAL::Gradation_limited_sizing_field_2 h(cdt, 0.2, P::sizing_function(d));
  const CGAL::Gradation_limited_sizing_field_2 k(other, 0.2, P::sizing_function(d));
  std::vector<Point> points = probes(2000);
  for (auto v : cdt.finite_vertex_handles())
    points.push_back(v->point());
  std::vector<double> forward(points.size()), backward(points.size());
  std::thread a([&] { std::transform(points.begin(), points.end(), forward.begin(), h); });
  std::thread b([&] { std::transform(points.rbegin(), points.rend(), backward.rbegin(), k); });
  a.join();
  b.join();
  EXPECT_TRUE(forward == backward);
}

TEST(Gradation_limited_sizing_field, scales)
{
  const auto d = [](const Point& p) { return p.x() > 0.3 ? 0.5 : 0.02; };
  const CGAL::Gradation_limited_sizing_field_2 h(square(), 0.2, P::sizing_function(d));
  for (int exponent : {-40, -280, 280}) { // fourth powers of the last two are none
    const double scale = std::ldexp(1., exponent);
    const CGAL::Gradation_limited_sizing_field_2 scaled(
      domains::make({domains::square(0, 0, scale)}), 0.2,
      P::sizing_function([&](const Point& p) { return scale * d(Point(p.x() / scale, p.y() / scale)); }));
    for (const Point& p : probes(500))
      EXPECT_EQ(scaled(Point(scale * p.x(), scale * p.y())), scale * h(p)) << exponent;
  }
}

TEST(Gradation_limited_sizing_field, limits_the_default_sizes_too)
{
  const CDT cdt = domains::make({{{0, 0}, {0.01, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const CGAL::Gradation_limited_sizing_field_2 h(cdt, 0.05);
  EXPECT_EQ(h(Point(0.01, 0)), 0.01);
  EXPECT_LE(steepest(h, 0.01), 0.05 * (1 + 1e-6));
  CDT mesh = cdt;
  CGAL::npbs_relax(mesh, P::sizing_function([](const Point& p) { return 0.01 + 0.15 * p.y(); }));
  const CGAL::Gradation_limited_sizing_field_2 of_mesh(mesh, 0.05);
  EXPECT_LE(steepest(of_mesh, 0.01), 0.05 * (1 + 1e-6));
}

TEST(Gradation_limited_sizing_field, of_an_exact_kernel_and_by_seeds)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact = CGAL::Constrained_Delaunay_triangulation_2<K>;
  const Exact cdt = domains::make<Exact>({domains::square(0, 0, 1), domains::square(0.25, 0.25, 0.5)});
  const std::vector<K::Point_2> seeds{K::Point_2(0.5, 0.5)};
  const auto d = [](const K::Point_2& p) { return p.x() < 0.3 ? K::FT(0.01) : K::FT(1); };
  const CGAL::Gradation_limited_sizing_field_2 h(
    cdt, 0.2, CGAL::Bubble_relaxation_parameters::sizing_function(d).seeds(seeds).seeds_are_in_domain(true));
  EXPECT_NEAR(h(K::Point_2(0.7, 0.5)), 0.01 + 0.2 * 0.4, 0.015);
  EXPECT_NEAR(h(K::Point_2(0.0, 0.5)), 0.01, 1e-12); // the ring is not in the domain
}

TEST(Gradation_limited_sizing_field, of_vertices_that_coincide_in_double)
{
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact = CGAL::Constrained_Delaunay_triangulation_2<K>;
  K::FT tiny = 1;
  for (int k = 0; k < 140; ++k)
    tiny /= 1000;
  const K::Point_2 middle(0.5, 0.5), near_to_it(0.5 + tiny, 0.5), near_to_a_side(0.5, tiny);
  for (const auto& points : {std::vector<K::Point_2>{middle, near_to_it}, std::vector<K::Point_2>{near_to_a_side}}) {
    Exact cdt = domains::make<Exact>({domains::square(0, 0, 1)});
    cdt.insert(points.begin(), points.end());
    const CGAL::Gradation_limited_sizing_field_2<Exact> h(cdt, 0.2, P::sizing_function(0.1));
    EXPECT_TRUE(h.is_resolved());
    EXPECT_NEAR(h(middle), 0.1, 1e-12);
  }
}

TEST(Gradation_limited_sizing_field, of_a_needle)
{
  // triangles whose long sides are all the same lower each other's sizes by less each time: that took minutes
  domains::Outline needle;
  const int n = 12;
  for (int k = 0; k < n; ++k)
    needle.emplace_back(double(k) / n, -1e-5 * (1 + k * 5 % 7));
  for (int k = n; k > 0; --k)
    needle.emplace_back((k - 0.4) / n, 1e-5 * (1 + k * 3 % 11));
  const CDT cdt = domains::make({needle});
  const CGAL::Gradation_limited_sizing_field_2<CDT> field(cdt, 0.2);
  for (double x = 0.01; x < 0.9; x += 0.01)
    EXPECT_LE(std::abs(field(Point(x + 0.001, 0)) - field(Point(x, 0))), 1.001 * 0.2 * 0.001) << x;
}

TEST(Gradation_limited_sizing_field, makes_a_good_mesh_of_a_jump)
{
  CDT abrupt = square(), limited = square();
  const Size d = [](const Point& p) { return distance(p, 0.4, 0.55) < 0.25 ? 0.01 : 0.1; };
  const auto bad = CGAL::npbs_relax(abrupt, P::sizing_function(d));
  const CGAL::Gradation_limited_sizing_field_2 h(limited, 0.2, P::sizing_function(d));
  const auto good = CGAL::npbs_relax(limited, P::sizing_function(h));
  EXPECT_GT(bad.largest_size_gradient, 0.9); // what edges across the jump see of it
  EXPECT_GT(bad.steep_share, 0.01);
  EXPECT_NEAR(distance(Point(bad.steepest_x, bad.steepest_y), 0.4, 0.55), 0.25, 0.2);
  EXPECT_LE(good.largest_size_gradient, 0.2 * (1 + 1e-6));
  EXPECT_EQ(good.steep_share, 0);
  EXPECT_LT(bad.quality.mean_quality(), good.quality.mean_quality());
  EXPECT_GT(good.quality.minimum_quality(), 0.6);
  EXPECT_GT(good.quality.mean_quality(), 0.98);
}

TEST(Gradation_limited_sizing_field, refuses_bad_input)
{
  const auto make = [](double g, const auto& np) {
    return [=] { CGAL::Gradation_limited_sizing_field_2<CDT>(square(), g, np); };
  };
  expect_invalid(make(0, P::sizing_function(0.1)), {"gradation", " 0 "});
  expect_invalid(make(-1, P::sizing_function(0.1)), {"gradation", "-1"});
  expect_invalid(make(std::nan(""), P::sizing_function(0.1)), {"gradation", "nan"});
  expect_invalid(make(INFINITY, P::sizing_function(0.1)), {"gradation", "inf"});
  expect_invalid(make(0.2, P::maximum_number_of_vertices(0)), {"maximum_number_of_vertices", "0"});
  const auto hole = [](const Point& p) { return p.x() > 0.4 && p.x() < 0.6 ? -1. : 1.; };
  expect_invalid(make(0.2, P::sizing_function(hole)), {"sizing_function", "= -1"});
  expect_invalid([] { CGAL::Gradation_limited_sizing_field_2<CDT>(CDT(), 0.2); }, {"bounds no domain"});
}

TEST(Gradation_limited_sizing_field, says_when_it_had_no_room)
{
  const CGAL::Gradation_limited_sizing_field_2 h(square(), 0.2,
                                                 P::sizing_function(cases[0].d).maximum_number_of_vertices(500));
  EXPECT_FALSE(h.is_resolved());
  EXPECT_LE(h.number_of_vertices(), 500u);
  EXPECT_LE(steepest(h, 0.01), 0.2 * (1 + 1e-6));
}

TEST(Gradation_limited_sizing_field, can_be_stopped)
{
  std::vector<double> told;
  const CGAL::Gradation_limited_sizing_field_2 whole(
    square(), 0.2, P::sizing_function(cases[0].d).callback([&](double share) { told.push_back(share); return true; }));
  EXPECT_TRUE(whole.is_resolved());
  ASSERT_GT(told.size(), 5u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
  const CGAL::Gradation_limited_sizing_field_2 h(
    square(), 0.2, P::sizing_function(cases[0].d).callback([](double share) { return share < 0.5; }));
  EXPECT_FALSE(h.is_resolved());
  EXPECT_LT(h.number_of_vertices(), whole.number_of_vertices());
  EXPECT_LE(steepest(h, 0.01), 0.2 * (1 + 1e-6));
}

TEST(Minimum_sizing_field, is_the_smallest_of_functions_and_numbers)
{
  const auto d = [](const Point& p) { return p.x(); };
  const CGAL::Minimum_sizing_field_2 least(d, 0.5, CGAL::Constant_sizing_field_2(0.4), 1);
  EXPECT_EQ(least(Point(0.3, 0)), 0.3);
  EXPECT_EQ(least(Point(0.7, 0)), 0.4);
  EXPECT_EQ(CGAL::Minimum_sizing_field_2(INFINITY, d)(Point(0.3, 0)), 0.3);
}

TEST(Minimum_sizing_field, hides_nothing)
{
  const auto d = [](const Point& p) { return p.x(); };
  EXPECT_TRUE(std::isnan(CGAL::Minimum_sizing_field_2(d, std::nan(""))(Point(0.3, 0))));
  EXPECT_TRUE(std::isnan(CGAL::Minimum_sizing_field_2(std::nan(""), d)(Point(0.3, 0))));
  EXPECT_EQ(CGAL::Minimum_sizing_field_2(1., d)(Point(-2, 0)), -2);
  CDT cdt = square();
  const CGAL::Minimum_sizing_field_2 bad(0.1, d); // zero on the left
  EXPECT_THROW(CGAL::npbs_relax(cdt, P::sizing_function(bad)), std::invalid_argument);
}

TEST(Constant_sizing_field, is_a_size)
{
  CDT cdt = square();
  const auto report = CGAL::npbs_relax(cdt, P::sizing_function(CGAL::Constant_sizing_field_2(0.1)));
  EXPECT_NEAR(double(report.number_of_vertices), 130, 30);
  EXPECT_EQ(report.largest_size_gradient, 0);
  expect_invalid([] { CGAL::Constant_sizing_field_2(0.); }, {"size", " 0 "});
}

} // namespace test_sizing_fields
