// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A sizing field that is given by sizes at the vertices of another triangulation.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

namespace test_interpolated_sizing_field {

namespace P = CGAL::parameters;
using domains::CDT;
using domains::K;
using domains::Point;
using Delaunay = CGAL::Delaunay_triangulation_2<K>;

/// sizes at the vertices of a triangulation, by a function of their points
template <class Triangulation>
struct Sizes
{
  using Handle = typename Triangulation::Vertex_handle;
  using Map = boost::associative_property_map<std::map<Handle, double>>;

  template <class Function>
  Sizes(const Triangulation& t, const Function& f)
  {
    for (Handle v : t.finite_vertex_handles())
      values[v] = f(v->point());
  }

  Map map() { return Map(values); }

  std::map<Handle, double> values;
};

template <class Triangulation, class Function>
CGAL::Interpolated_sizing_field_2<Triangulation> field(const Triangulation& t, const Function& f)
{
  return {t, Sizes<Triangulation>(t, f).map()};
}

std::vector<Point> random_points(int n, unsigned seed)
{
  std::mt19937 random(random_seeds::seed(seed));
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < n; ++k)
    points.emplace_back(uniform(random), uniform(random));
  return points;
}

double linear(const Point& p) { return 0.1 + 0.2 * p.x() + 0.3 * p.y(); }

CDT graded_mesh(const std::vector<domains::Outline>& outlines)
{
  return domains::mesh(outlines, [](const Point& p) { return 0.03 + 0.1 * p.x(); });
}

TEST(Interpolated_sizing_field, is_linear_inside_and_nearest_outside)
{
  const std::vector<Point> points = random_points(1000, 0);
  const Delaunay t(points.begin(), points.end());
  const auto d = field(t, linear);
  for (const Point& p : random_points(1000, 3))
    EXPECT_NEAR(d(p), linear(p), 1e-12);
  for (const Point& p : points)
    EXPECT_EQ(d(p), linear(p));
  EXPECT_NEAR(d(Point(0.3, -5)), linear(Point(0.3, 0)), 1e-12);
  EXPECT_NEAR(d(Point(3, 0.7)), linear(Point(1, 0.7)), 1e-12);
  EXPECT_EQ(d(Point(4, 5)), linear(Point(1, 1)));
  EXPECT_EQ(d(Point(-1e9, -1)), linear(Point(0, 0)));
}

TEST(Interpolated_sizing_field, finds_the_nearest_point_of_any_hull)
{
  std::vector<Point> points;
  for (const auto& p : domains::polygon(0, 0, 1, 50))
    points.emplace_back(p.first, 0.2 * p.second);
  const Delaunay t(points.begin(), points.end());
  const auto x = field(t, [](const Point& p) { return 2 + p.x(); });
  const auto y = field(t, [](const Point& p) { return 2 + p.y(); });
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int k = 0; k < 2000; ++k) {
    const Point q(uniform(random), uniform(random));
    const Point nearest(x(q) - 2, y(q) - 2); // where it is tells how far
    double least = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i)
      least = (std::min)(least, CGAL::squared_distance(q, K::Segment_2(points[i], points[(i + 1) % 50])));
    if (t.is_infinite(t.locate(q))) {
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(q, nearest)), std::sqrt(least), 1e-12) << q;
    }
  }
}

TEST(Interpolated_sizing_field, counts_marked_faces_only)
{
  CDT cdt = graded_mesh({domains::square(0, 0, 1), domains::square(0.3, 0.3, 0.4)});
  cdt.insert(Point(0.5, 0.5)); // in the hole; its size is none
  for (auto f : cdt.finite_face_handles()) {
    const Point c = CGAL::centroid(cdt.triangle(f));
    f->set_in_domain(std::abs(c.x() - 0.5) > 0.2 || std::abs(c.y() - 0.5) > 0.2);
  }
  const auto d = field(cdt, [](const Point& p) { return p == Point(0.5, 0.5) ? -1. : linear(p); });
  EXPECT_NEAR(d(Point(0.32, 0.5)), linear(Point(0.3, 0.5)), 1e-12);
  EXPECT_NEAR(d(Point(0.55, 0.65)), linear(Point(0.55, 0.7)), 1e-12);
}

/// a grid of n x n squares, of which those are marked for whose centre something holds
template <class Is_marked>
CDT grid(int n, const Is_marked& is_marked)
{
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      points.emplace_back(double(i) / n, double(j) / n);
  CDT cdt;
  cdt.insert(points.begin(), points.end());
  for (auto f : cdt.finite_face_handles())
    f->set_in_domain(is_marked(CGAL::centroid(cdt.triangle(f))));
  return cdt;
}

TEST(Interpolated_sizing_field, finds_the_nearest_point_of_what_is_marked)
{
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(0, 1);
  const CDT cdt = grid(30, [&](const Point& c) { return uniform(random) < (c.x() < 0.5 ? 0.5 : 0.02); });
  std::vector<K::Segment_2> sides; // of triangles that are marked
  for (auto f : cdt.finite_face_handles())
    for (int i = 0; i < 3 && f->is_in_domain(); ++i)
      sides.emplace_back(f->vertex(cdt.ccw(i))->point(), f->vertex(cdt.cw(i))->point());
  const auto x = field(cdt, [](const Point& p) { return 1 + p.x(); });
  const auto y = field(cdt, [](const Point& p) { return 1 + p.y(); });
  int outside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Point q(uniform(random), uniform(random)), nearest(x(q) - 1, y(q) - 1);
    double least = 0;
    if (!cdt.locate(q)->is_in_domain()) {
      least = CGAL::squared_distance(q, sides[0]);
      for (const auto& s : sides)
        least = (std::min)(least, CGAL::squared_distance(q, s));
      ++outside;
    }
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(q, nearest)), std::sqrt(least), 1e-12) << q;
  }
  EXPECT_GT(outside, 1000);
}

TEST(Interpolated_sizing_field, takes_no_time_of_all_that_is_not_marked)
{
  // 80 000 faces that were all looked at in each of so many places: minutes
  const int n = 200, places = 200000;
  const CDT cdt = grid(n, [](const Point& c) { return c.x() < 1. / n; });
  const auto d = field(cdt, [](const Point& p) { return 1 + p.y(); });
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int k = 0; k < places; ++k) {
    const Point q(0.3 + 0.7 * uniform(random), uniform(random));
    ASSERT_NEAR(d(q), 1 + q.y(), 1e-12) << q;
  }
}

TEST(Interpolated_sizing_field, takes_no_time_of_the_whole_hull)
{
  // 200 000 sides of the hull, many of which were walked along in each of so many places: minutes
  const int n = 200000, places = 500000;
  std::vector<Point> points{{0, 0}};
  for (const auto& p : domains::polygon(0, 0, 1, n))
    points.emplace_back(p.first, p.second);
  const Delaunay t(points.begin(), points.end());
  const auto d = field(t, [](const Point& p) { return 2 + p.x(); });
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> uniform(-10, 10);
  for (int k = 0; k < places; ++k) {
    const Point q(uniform(random), uniform(random));
    const double r = std::sqrt(q.x() * q.x() + q.y() * q.y());
    if (r > 1) {
      ASSERT_NEAR(d(q), 2 + q.x() / r, 1e-4) << q; // up to a side
    }
  }
}

TEST(Interpolated_sizing_field, finds_the_nearest_point_from_afar)
{
  // all sides of the wall are equally far away, up to roundings
  const int n = 1000;
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i)
    for (const Point& p : {Point(0, double(i) / n), Point(1, double(i) / n)})
      points.push_back(p);
  const Delaunay t(points.begin(), points.end());
  const auto d = field(t, [](const Point& p) { return 1 + p.y(); });
  for (double x : {1.5, 30., 1e3, 1e6, 1e9, 1e12, 1e100})
    for (double y : {0.0123, 0.5, 0.98765}) {
      EXPECT_NEAR(d(Point(x, y)), 1 + y, 1e-12) << x << ", " << y;
      EXPECT_NEAR(d(Point(-x, y)), 1 + y, 1e-12) << x << ", " << y;
    }
  for (double x : {3., 1e6, 1e100, 1e200, 1.7e308}) { // corners
    EXPECT_EQ(d(Point(x, x)), 2);
    EXPECT_EQ(d(Point(-x, -x)), 1);
  }
}

TEST(Interpolated_sizing_field, finds_the_nearest_point_of_a_slanted_wall_from_afar)
{
  // a square turned by an angle of tangent 2, with points on its walls; far places whose perpendiculars meet the middles
  // of sides, all in integers and halves, so without roundings
  std::vector<Point> points;
  for (int i = 0; i <= 10; ++i)
    for (int j : {0, 10}) {
      points.emplace_back(i - 2 * j, 2 * i + j);
      points.emplace_back(j - 2 * i, 2 * j + i);
    }
  const Delaunay t(points.begin(), points.end());
  const auto d = field(t, [](const Point& p) { return 100 + p.x(); });
  for (double far = 10; far < 1e12; far = std::floor(far * 3.7))
    for (int i = 0; i < 10; ++i) {
      const double x = i + 0.5, y = 2 * x;
      EXPECT_NEAR(d(Point(x + 2 * far, y - far)), 100 + x, 1e-9) << far;
    }
}

TEST(Interpolated_sizing_field, has_the_same_bits_in_any_order_and_thread)
{
  std::vector<Point> points = random_points(500, 0);
  const Delaunay t(points.begin(), points.end());
  std::reverse(points.begin(), points.end());
  Delaunay other;
  for (const Point& p : points)
    other.insert(p);
  const auto size = [](const Point& p) { return 0.1 + p.x() * p.y() / 3; };
  const auto d = field(t, size), e = field(other, size);
  std::vector<Point> probes = random_points(5000, 4);
  for (auto edge = t.finite_edges_begin(); edge != t.finite_edges_end(); ++edge)
    probes.push_back(CGAL::midpoint(t.segment(*edge).source(), t.segment(*edge).target()));
  std::vector<double> forward(probes.size()), backward(probes.size());
  std::thread a([&] { std::transform(probes.begin(), probes.end(), forward.begin(), d); });
  std::thread b([&] { std::transform(probes.rbegin(), probes.rend(), backward.rbegin(), e); });
  a.join();
  b.join();
  EXPECT_TRUE(forward == backward);
}

TEST(Interpolated_sizing_field, limits_the_gradient)
{
  const CDT cdt = graded_mesh({domains::square(0, 0, 1)});
  const auto jump = [](const Point& p) { return p.x() + p.y() < 0.6 ? 0.01 : 0.6; };
  Sizes<CDT> sizes(cdt, jump);
  for (double g : {0.1, 0.5}) {
    const CGAL::Interpolated_sizing_field_2<CDT> d(cdt, sizes.map(), g);
    double steepest = 0, largest = 0;
    std::vector<Point> points = random_points(20000, 5);
    for (std::size_t k = 4; k < points.size(); ++k) {
      const Point p = points[k], q(0.999 * p.x() + 0.0005, 0.998 * p.y() + 0.001);
      steepest = (std::max)(steepest, std::abs(d(p) - d(q)) / std::sqrt(CGAL::squared_distance(p, q)));
      EXPECT_LE(d(p), 0.6 * (1 + 1e-12));
      EXPECT_GE(d(p), 0.01 * (1 - 1e-12));
      largest = (std::max)(largest, d(p));
    }
    EXPECT_LE(steepest, g * (1 + 1e-6));
    EXPECT_GT(largest, (std::min)(0.59, 0.01 + 0.85 * g)); // 0.99 away from where it is small
  }
}

/// How much steeper the sizes of the vertices of a triangulation are than `g`, as a share of it.
double excess_over(double g, const std::map<Point, double>& given)
{
  Delaunay dt;
  std::map<Delaunay::Vertex_handle, double> sizes;
  for (const auto& [p, size] : given)
    sizes[dt.insert(p)] = size;
  const CGAL::Interpolated_sizing_field_2<Delaunay> d(dt, boost::make_assoc_property_map(sizes), g);
  long double steepest = 0;
  for (const auto f : dt.finite_face_handles()) {
    const Point &p = f->vertex(0)->point(), &q = f->vertex(1)->point(), &r = f->vertex(2)->point();
    const long double ux = q.x() - (long double)(p.x()), uy = q.y() - (long double)(p.y()),
                      vx = r.x() - (long double)(p.x()), vy = r.y() - (long double)(p.y()), a = d(q) - d(p),
                      b = d(r) - d(p);
    steepest = (std::max)(steepest, std::hypot(a * vx - b * ux, a * vy - b * uy) / (ux * vy - uy * vx));
  }
  return double(steepest / g - 1);
}

TEST(Interpolated_sizing_field, limits_the_gradient_in_needles)
{
  for (double e : {1e-6, 1e-8, 3e-9, 1e-10, 1e-12}) {
    EXPECT_LE(excess_over(0.2, {{Point(0, 0), 0.01}, {Point(1, 0), 1.}, {Point(1 - e, e), 1.}}), 1e-6) << e;
    std::mt19937 random(random_seeds::seed(3));
    std::uniform_real_distribution<double> uniform(0, 1);
    std::map<Point, double> pairs;
    for (int k = 0; k < 200; ++k) {
      const double x = uniform(random), y = uniform(random), size = uniform(random) < 0.05 ? 0.01 : 1;
      const double dx = e * uniform(random), dy = e * uniform(random);
      pairs[Point(x, y)] = pairs[Point(x + dx, y + dy)] = size;
    }
    EXPECT_LE(excess_over(0.2, pairs), e < 1e-10 ? 1e-3 : 1e-5) << e; // coordinates have no more digits
  }
  EXPECT_LE(excess_over(0.1, {{Point(0, 0), 1e12}, {Point(1, 0), 1e12 + 50}, {Point(0, 1), 1e12}}), 1e-3);
}

TEST(Interpolated_sizing_field, adapts_the_very_mesh_it_was_made_of)
{
  CDT cdt = graded_mesh({domains::square(0, 0, 1)});
  const auto wanted = [](const Point& p) { return 0.01 + 0.2 * std::abs(p.x() + p.y() - 1); };
  Sizes<CDT> sizes(cdt, wanted);
  const CGAL::Interpolated_sizing_field_2<CDT> d(cdt, sizes.map(), 0.2);
  const auto report = CGAL::npbs_relax(cdt, P::sizing_function(d));
  EXPECT_GT(report.quality.mean_quality(), 0.95);
  EXPECT_NEAR(report.quality.mean_length_ratio(), 1, 0.05);
  EXPECT_LE(report.largest_size_gradient, 0.2 * (1 + 1e-6));
}

TEST(Interpolated_sizing_field, refuses_bad_input)
{
  CDT cdt = graded_mesh({domains::square(0, 0, 1)});
  for (double bad : {0., -1., std::nan(""), double(INFINITY)})
    expect_invalid([&] { field(cdt, [=](const Point& p) { return p == Point(1, 0) ? bad : 0.1; }); },
                   {"size", "(1, 0)", "positive"});
  Sizes<CDT> sizes(cdt, linear);
  for (double bad : {0., -1., std::nan(""), double(INFINITY)})
    expect_invalid([&] { CGAL::Interpolated_sizing_field_2<CDT>(cdt, sizes.map(), bad); }, {"gradation"});
  Delaunay line;
  line.insert(Point(0, 0));
  line.insert(Point(1, 0));
  expect_invalid([&] { field(line, linear); }, {"dimension 1"});
}

TEST(Interpolated_sizing_field, refuses_what_roundings_turn_over)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Triangulation = CGAL::Delaunay_triangulation_2<Exact>;
  const Exact::FT tiny = Exact::FT(1) / Exact::FT(1e40);
  int refused = 0; // the corners are in a line but for something tiny, to the left or to the right
  for (const Exact::FT& beside : {tiny, -tiny}) {
    Triangulation t;
    for (int k : {0, 1, 3})
      t.insert(Exact::Point_2(Exact::FT(k) / 7, Exact::FT(k) / 13 + (k == 3 ? beside : 0)));
    ASSERT_EQ(t.number_of_faces(), 1u);
    try {
      field(t, [](const auto&) { return 1.; });
    } catch (const std::invalid_argument& e) {
      ++refused;
      const std::string words = e.what();
      EXPECT_NE(words.find("Interpolated_sizing_field_2 has a triangle"), std::string::npos) << words;
      EXPECT_NE(words.find("turned over"), std::string::npos) << words;
    }
  }
  EXPECT_EQ(refused, 1);
}

} // namespace test_interpolated_sizing_field
