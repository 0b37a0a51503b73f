// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Outlines as they come: coasts, combs, stars, and graphs with pins, all at random. However sharp their corners and
// narrow their channels, what is not forced by a corner is good, and the simulation comes to an end.

#include "../../../benchmark/Bubble_relaxation_2/outline_judgement.h"
#include "counted_memory.h"
#include "domains.h"
#include "random_seeds.h"
#include "validation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_outlines {

namespace P = CGAL::Bubble_relaxation_parameters;
using CGAL::make_boolean_property_map;
using domains::CDT;
using domains::Outline;
using domains::Point;
using Pins = std::set<CDT::Vertex_handle>;

Pins pins_at(const CDT& cdt, const std::set<Point>& places)
{
  Pins result;
  for (auto v : cdt.finite_vertex_handles())
    if (places.count(v->point()) > 0)
      result.insert(v);
  return result;
}

constexpr double degrees = 57.29577951308232;

bool is_free(const domains::K::Triangle_2& t, const std::set<Point>& sharp)
{
  return sharp.count(t[0]) + sharp.count(t[1]) + sharp.count(t[2]) == 0;
}

double smallest_angle_of(const domains::K::Triangle_2& t)
{
  return (std::min)({angle_at(t[0], t[1], t[2]), angle_at(t[1], t[2], t[0]), angle_at(t[2], t[0], t[1])});
}

/// of the triangles without a vertex in a sharp corner
struct Free_triangles
{
  double smallest_angle = 60, mean_quality = 0;

  Free_triangles(const CDT& cdt, const std::set<Point>& sharp)
  {
    int number = 0;
    for (auto f : cdt.finite_face_handles()) {
      const auto t = cdt.triangle(f);
      if (!f->is_in_domain() || !is_free(t, sharp))
        continue;
      smallest_angle = (std::min)(smallest_angle, smallest_angle_of(t));
      mean_quality += CGAL::radius_ratio_2(t[0], t[1], t[2]);
      ++number;
    }
    mean_quality /= number;
  }
};

/// of the triangles of the domain at a vertex; 180 if there is no vertex in that place
double smallest_angle_at(const CDT& cdt, const Point& vertex)
{
  double smallest = 180;
  for (auto f : cdt.finite_face_handles())
    for (int i = 0; i < 3; ++i) {
      const auto t = cdt.triangle(f);
      if (f->is_in_domain() && t[i] == vertex)
        smallest = (std::min)(smallest, angle_at(t[i], t[i + 1], t[i + 2]));
    }
  return smallest;
}

/// a ring whose edges are broken at random places beside their middles, and again
Outline broken_ring(std::mt19937& random, int times)
{
  std::uniform_real_distribution<double> shift(-0.25, 0.25);
  Outline ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < times; ++k) {
    Outline next;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const double s = shift(random), dx = q.first - p.first, dy = q.second - p.second;
      next.push_back(p);
      next.push_back({0.5 * (p.first + q.first) - s * dy, 0.5 * (p.second + q.second) + s * dx});
    }
    ring = std::move(next);
  }
  return ring;
}

/// one that does not cross itself
Outline coast(unsigned seed, int times)
{
  for (std::mt19937 random(seed);;) {
    const Outline ring = broken_ring(random, times);
    const std::vector<Point> points = domains::points_of(ring);
    if (CGAL::is_simple_2(points.begin(), points.end()))
      return ring;
  }
}

/// a bar with teeth, whose gaps are as wide as they are or far narrower
Outline comb(unsigned seed, int teeth)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.01, 0.9), height(0.2, 1);
  Outline o{{0, -0.2}, {1, -0.2}};
  for (int k = teeth; k > 0; --k) {
    const double right = double(k) / teeth, gap = share(random) / teeth, h = height(random);
    o.push_back({right, 0});
    o.push_back({right - 0.5 * (1. / teeth - gap), h});
    o.push_back({right - (1. / teeth - gap), 0});
  }
  o.push_back({0, 0});
  return o;
}

/// a star with sharp tips
Outline star(unsigned seed, int tips)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.7, 1), inner(0.05, 0.3);
  Outline o;
  for (int k = 0; k < 2 * tips; ++k) {
    const double r = k % 2 == 0 ? radius(random) : inner(random), t = 3.14159265358979 * k / tips;
    o.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return o;
}

/// a square with edges of a Delaunay triangulation of random points inside, the rest of which are pins
CDT graph(unsigned seed, int points, double share_of_edges, std::set<Point>& pins)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0.02, 0.98), share(0, 1);
  CGAL::Delaunay_triangulation_2<domains::K> all;
  for (int k = 0; k < points; ++k) {
    const double x = coordinate(random);
    all.insert(Point(x, coordinate(random)));
  }
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  for (auto v : all.finite_vertex_handles())
    pins.insert(cdt.insert(v->point())->point());
  std::vector<std::pair<Point, Point>> edges; // CGAL lists them by addresses, so that runs would not be alike
  for (auto e : all.finite_edges())
    edges.push_back(std::minmax(Point(e.first->vertex(all.ccw(e.second))->point()),
                                Point(e.first->vertex(all.cw(e.second))->point())));
  std::sort(edges.begin(), edges.end());
  for (const auto& e : edges)
    if (share(random) < share_of_edges) {
      const auto u = cdt.insert(e.first), v = cdt.insert(e.second);
      cdt.insert_constraint(u, v);
      pins.erase(u->point());
      pins.erase(v->point());
    }
  return cdt;
}

class Outlines : public testing::Test
{
protected:
  /// meshes a domain by default, or with a constant size
  void mesh(CDT cdt, const std::set<Point>& places, double d)
  {
    const Pins pins = pins_at(cdt, places);
    const std::set<validation::Xy> fixed = validation::fixed_vertices(cdt, pins);
    const validation::Snapshot before = validation::snapshot(cdt);
    const std::set<Point> sharp = sharp_corners(cdt);
    const auto np = P::vertex_is_constrained_map(make_boolean_property_map(pins));
    const auto report = d > 0 ? CGAL::npbs_relax(cdt, np.sizing_function(d)) : CGAL::npbs_relax(cdt, np);
    validation::expect_valid_mesh(cdt);
    validation::expect_constraints_kept(before, validation::snapshot(cdt));
    validation::expect_vertices_kept(fixed, validation::snapshot(cdt));
    const Free_triangles free(cdt, sharp);
    EXPECT_GE(free.smallest_angle, 30);
    EXPECT_GE(free.mean_quality, least_mean_quality);
    EXPECT_EQ(report.number_of_small_angles, 0u);
    EXPECT_LE(report.number_of_forced_triangles, 20 * sharp.size());
    EXPECT_NEAR(report.quality.mean_length_ratio(), 1, d > 0 ? 0.06 : most_change_of_default);
    ++m_number;
    m_number_converged += report.converged;
  }

  void mesh(const Outline& outline)
  {
    for (double d : {0., 0.05})
      mesh(domains::make({outline}), {}, d);
  }

  /// of a dozen all but one
  void TearDown() override { EXPECT_GE(m_number_converged, m_number - 1); }

  double least_mean_quality = 0.955, most_change_of_default = 0.06;

private:
  int m_number = 0, m_number_converged = 0;
};

TEST_F(Outlines, coasts)
{
  for (unsigned k = 0; k < 6; ++k) {
    SCOPED_TRACE(k);
    mesh(coast(random_seeds::seed(k), 6));
  }
}

TEST_F(Outlines, combs)
{
  for (unsigned k = 0; k < 6; ++k) {
    SCOPED_TRACE(k);
    mesh(comb(random_seeds::seed(k), 8));
  }
}

TEST_F(Outlines, stars)
{
  least_mean_quality = 0.93; // they are hardly more than tips
  most_change_of_default = 0.09; // edges from a tip to its circle are far longer than the chord, for which the size is
  for (unsigned k = 0; k < 6; ++k) {
    SCOPED_TRACE(k);
    mesh(star(random_seeds::seed(k), 9));
  }
}

TEST_F(Outlines, graphs_with_pins)
{
  for (unsigned k = 0; k < 6; ++k)
    for (double d : {0., 0.05}) {
      SCOPED_TRACE(k);
      std::set<Point> pins;
      const CDT cdt = graph(random_seeds::seed(k), 40, 0.15, pins);
      for (auto f : cdt.finite_face_handles()) // edges may enclose pins, by nesting in a hole
        f->set_in_domain(true);
      mesh(cdt, pins, d);
    }
}

TEST_F(Outlines, one_circle_that_cannot_be_cut_off_spoils_no_other)
{
  // a pinned vertex inside of an edge by a rounding, beyond the edge once that is cut at the circle around its corner
  const Point pin(0.13566432279764751, 0.01962806838087696), other_pin(0.082261518729559627, 0.0061619418491649838),
    other_corner(0.0081653334396372956, 0.0037673175768303938);
  CDT cdt = domains::make({{{0.04954648268240832, -0.0020875278666718251},
                            {0.14348180894563436, 0.021599336734023301},
                            {other_corner.x(), other_corner.y()}}});
  cdt.insert(pin);
  cdt.insert(other_pin);
  const Pins pins = pins_at(cdt, {pin, other_pin});
  ASSERT_EQ(pins.size(), 2u);
  CGAL::npbs_relax(cdt, CGAL::parameters::vertex_is_constrained_map(make_boolean_property_map(pins)));
  // a circle leaves one triangle in a corner, with two sides that are equal
  int number = 0;
  for (auto f : cdt.finite_face_handles())
    for (int i = 0; i < 3; ++i)
      if (const auto t = cdt.triangle(f); f->is_in_domain() && t[i] == other_corner) {
        ++number;
        EXPECT_NEAR(CGAL::squared_distance(t[i], t[i + 1]), CGAL::squared_distance(t[i], t[i + 2]), 1e-14);
      }
  EXPECT_EQ(number, 1);
}

TEST_F(Outlines, a_crack_keeps_no_other_place_from_refinement)
{
  int number_without = 0, number_with = 0, number_beside_crack = 0; // of free triangles under 33 degrees
  for (unsigned k = 0; k < 40; ++k) {
    std::set<Point> places;
    CDT without = graph(random_seeds::seed(k), 40, 0.3, places), with(without), beside_crack(without);
    const std::set<Point> sharp = sharp_corners(without);
    const auto count = [&](CDT& cdt, double angle) {
      const Pins pins = pins_at(cdt, places);
      const auto np = P::number_of_rounds(1).size_growth(0.3).minimum_angle(angle);
      CGAL::npbs_relax(cdt, np.vertex_is_constrained_map(make_boolean_property_map(pins)));
      int number = 0;
      for (auto f : cdt.finite_face_handles())
        number += f->is_in_domain() && f->vertex(0)->point().x() < 2 && is_free(cdt.triangle(f), sharp) &&
                  smallest_angle_of(cdt.triangle(f)) < 33;
      return number;
    };
    domains::insert(beside_crack, {{3, 0}, {3.3, 0}, {3.3, 0.3}, {3, 0.3}}, true);
    domains::insert(beside_crack, {{3.05, 0.1}, {3.25, 0.1}}, false);
    domains::insert(beside_crack, {{3.05, 0.100000000001}, {3.25, 0.100000000001}}, false);
    number_without += count(without, 0);
    number_with += count(with, 33);
    number_beside_crack += count(beside_crack, 33);
  }
  EXPECT_LT(number_with, number_without);
  EXPECT_LT(number_beside_crack, number_without);
}

TEST_F(Outlines, corners_that_are_not_so_sharp_force_nothing)
{
  for (double opening : {30.5, 35., 40., 44.})
    for (double beside : {35., 58., 61., 65., 100.}) {
      const double a = opening / degrees, b = (opening + beside) / degrees;
      CDT cdt = domains::make({{{0, 0}, {1, 0}, {std::cos(a), std::sin(a)}, {std::cos(b), std::sin(b)}}});
      domains::insert(cdt, {{0, 0}, {std::cos(a), std::sin(a)}}, false);
      const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.05));
      EXPECT_EQ(report.number_of_forced_triangles, 0u) << opening << ' ' << beside;
      EXPECT_EQ(report.number_of_small_angles, 0u) << opening << ' ' << beside;
    }
}

TEST_F(Outlines, what_a_corner_forces_is_told)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {1, 0.1}}});
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.02));
  EXPECT_EQ(report.number_of_forced_triangles, 1u);
  EXPECT_EQ(report.number_of_small_angles, 0u);
  EXPECT_EQ(report.forced_x, 0);
  EXPECT_EQ(report.forced_y, 0);
  EXPECT_EQ(report.small_x, 0); // there is none
  EXPECT_NEAR(report.quality.minimum_angle(), degrees * std::atan(0.1), 1e-6);
}

TEST_F(Outlines, what_d_alone_asks_for_is_told)
{
  const auto report_of = [](const Outline& outline, double d) {
    CDT cdt = domains::make({outline});
    return CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  };
  const auto smooth = report_of(domains::square(0, 0, 1), 0.02);
  EXPECT_NEAR(double(smooth.number_of_wanted_vertices), double(smooth.number_of_vertices),
              0.01 * double(smooth.number_of_vertices));
  // the outline has pieces of about 1/100, and its corners do not count
  const auto fine = report_of(coast(random_seeds::seed(), 7), 0.2);
  EXPECT_LT(double(fine.number_of_wanted_vertices), 0.1 * double(fine.number_of_vertices));
  const auto same = report_of(domains::square(0, 0, 1), 0.2);
  EXPECT_NEAR(double(fine.number_of_wanted_vertices), double(same.number_of_wanted_vertices), 25);
}

TEST_F(Outlines, where_most_vertices_are_forced_is_told)
{
  CDT smooth = domains::make({domains::square(0, 0, 1)});
  EXPECT_EQ(CGAL::npbs_relax(smooth, 0.1).forced_places[0].number_of_vertices, 0u);
  using domains::polygon; // in the middle of a square of a sixteenth, and elsewhere
  CDT cdt = domains::make(
    {domains::square(0, 0, 1), polygon(0.71875, 0.21875, 0.02, 60), polygon(0.2, 0.7, 0.01, 8)});
  const auto report = CGAL::npbs_relax(cdt, 0.1);
  const auto &first = report.forced_places[0], &second = report.forced_places[1];
  EXPECT_NEAR(std::hypot(first.x - 0.71875, first.y - 0.21875), 0.02, 0.005);
  std::size_t number = 0; // of all that are there, near to the first hole
  for (auto v : cdt.finite_vertex_handles())
    number += std::hypot(v->point().x() - 0.71875, v->point().y() - 0.21875) < 0.05;
  EXPECT_GT(double(first.number_of_vertices), 0.5 * double(number));
  EXPECT_LE(second.number_of_vertices, first.number_of_vertices);
  bool is_second_hole_told = false;
  for (const auto& place : report.forced_places)
    is_second_hole_told |= place.number_of_vertices > 0 && std::hypot(place.x - 0.2, place.y - 0.7) < 0.02;
  EXPECT_TRUE(is_second_hole_told);
}

TEST_F(Outlines, the_report_says_why_there_are_many_more_than_wanted)
{
  const auto text_of = [](const auto& report) {
    std::ostringstream text;
    text << report;
    return text.str();
  };
  CDT smooth = domains::make({domains::square(0, 0, 1)});
  const auto as_wanted = CGAL::npbs_relax(smooth, 0.1);
  EXPECT_FALSE(as_wanted.is_forced_by_outline());
  EXPECT_EQ(text_of(as_wanted).find("forces"), std::string::npos);
  EXPECT_EQ(text_of(as_wanted).find("Gradation_limited"), std::string::npos);

  CDT jumping = domains::make({domains::square(0, 0, 1)});
  const auto jump = [](const Point& p) { return p.x() < 0.5 ? 0.02 : 0.1; };
  const std::string at_jump = text_of(CGAL::npbs_relax(jumping, CGAL::parameters::sizing_function(jump)));
  EXPECT_NE(at_jump.find("Gradation_limited_sizing_field_2"), std::string::npos) << at_jump;

  CDT cdt = domains::make({domains::square(0, 0, 1), domains::polygon(0.71875, 0.21875, 0.02, 60)});
  const auto report = CGAL::npbs_relax(cdt, 0.1);
  EXPECT_TRUE(report.is_forced_by_outline());
  const std::size_t wanted = report.number_of_wanted_vertices;
  const std::string text = text_of(report);
  std::ostringstream place;
  place << std::setprecision(10) << "most near (" << report.forced_places[0].x << ", " << report.forced_places[0].y << ')';
  for (const std::string& said :
       {"asks for about " + std::to_string(wanted) + " of",
        "forces " + std::to_string(report.number_of_vertices - wanted) + " more", place.str(),
        std::string("simplify_outline_2()"), std::string("size_growth")})
    EXPECT_NE(text.find(said), std::string::npos) << said << '\n' << text;

  // one more than twice as many is enough, and so is one more than a hundred on top
  CGAL::Bubble_relaxation_report_2<double> r;
  r.number_of_wanted_vertices = 100;
  for (std::size_t n : {200, 201}) {
    r.number_of_vertices = n;
    EXPECT_EQ(r.is_forced_by_outline(), n == 201);
  }
  r.number_of_wanted_vertices = 10;
  for (std::size_t n : {110, 111}) {
    r.number_of_vertices = n;
    EXPECT_EQ(r.is_forced_by_outline(), n == 111);
  }
}

TEST_F(Outlines, growth_trades_vertices_for_quality)
{
  std::size_t last = 0;
  double quality = 1;
  for (double growth : {0.2, 0.35, 0.6}) {
    CDT cdt = domains::make({coast(random_seeds::seed(), 7)});
    const auto np = CGAL::parameters::sizing_function(0.2).size_growth(growth);
    const auto report = CGAL::npbs_relax(cdt, np);
    if (last != 0) {
      EXPECT_LT(report.number_of_vertices, 0.85 * double(last));
      EXPECT_LT(report.quality.mean_quality(), quality);
    }
    last = report.number_of_vertices;
    quality = report.quality.mean_quality();
  }
}

/// beyond the triangulation; of copies for the case that a treatment or a refinement fails, there are few
TEST_F(Outlines, memory_is_bounded)
{
  std::set<Point> places;
  CDT cdt = graph(random_seeds::seed(), 1000, 0.3, places);
  const Pins pins = pins_at(cdt, places);
  counted_memory::most_memory = counted_memory::memory;
  const auto report =
    CGAL::npbs_relax(cdt, P::minimum_angle(33.).vertex_is_constrained_map(make_boolean_property_map(pins)));
  EXPECT_LE(double(counted_memory::most_memory - counted_memory::memory), 400 * double(report.number_of_vertices));
  EXPECT_GT(report.number_of_small_angles, 0u); // so refinement was tried
}

TEST_F(Outlines, small_angles_are_refined)
{
  // after one round where sizes grow fast there is something left to refine, if no less than about what can be had is
  // asked for
  constexpr double degrees = 33;
  std::size_t number_of_refined = 0, number_of_good = 0, obtuse_before = 0, obtuse_after = 0;
  for (unsigned k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    std::set<Point> places;
    CDT coarse = graph(random_seeds::seed(k), 40, 0.3, places), fine(coarse);
    const Pins pins = pins_at(coarse, places), pins_of_fine = pins_at(fine, places);
    const std::set<Point> sharp = sharp_corners(coarse);
    const auto relax = [](CDT& cdt, const Pins& pinned, double angle) {
      const auto np = P::number_of_rounds(1).size_growth(0.3).minimum_angle(angle);
      return CGAL::npbs_relax(cdt, np.vertex_is_constrained_map(make_boolean_property_map(pinned)));
    };
    const auto without = relax(coarse, pins, 0), with = relax(fine, pins_of_fine, degrees);
    EXPECT_TRUE(fine.is_valid());
    EXPECT_EQ(without.number_of_small_angles, 0u); // none is smaller than 0
    if (with.number_of_small_angles > 0) {
      const Point worst(with.small_x, with.small_y); // the promise was not kept there
      EXPECT_LT(smallest_angle_at(fine, worst), degrees);
    } else {
      ++number_of_good;
      EXPECT_GE(Free_triangles(fine, sharp).smallest_angle, degrees - 1e-9);
    }
    if (with.number_of_vertices > without.number_of_vertices) {
      ++number_of_refined;
      obtuse_before += without.quality.number_of_obtuse_triangles();
      obtuse_after += with.quality.number_of_obtuse_triangles();
      EXPECT_GE(Free_triangles(fine, sharp).smallest_angle, Free_triangles(coarse, sharp).smallest_angle);
    } else {
      EXPECT_EQ(validation::triangles(fine), validation::triangles(coarse)); // taken back if it does not end
    }
  }
  EXPECT_GT(number_of_refined, 0u);
  EXPECT_LE(obtuse_after, obtuse_before); // what refinement leaves is treated
  EXPECT_GE(number_of_good, 10u); // beyond 20.7 degrees refinement does not always end
}

TEST_F(Outlines, triangles_in_front_of_sharp_corners_are_acute)
{
  for (double angle : {3., 5., 8., 11., 14., 17., 20., 23.})
    for (double d : {0.03, 0.05, 0.1, 0.2}) {
      const double half = std::tan(0.5 * angle / degrees);
      CDT cdt = domains::make({{{0, 0}, {1, -half}, {1.5, -1}, {2.5, 0}, {1.5, 1}, {1, half}}});
      const auto report = CGAL::npbs_relax(cdt, d);
      EXPECT_EQ(report.quality.number_of_obtuse_triangles(), 0u) << angle << ' ' << d;
      EXPECT_TRUE(report.converged);
    }
}

TEST_F(Outlines, obtuse_triangles_are_counted)
{
  CDT cdt = domains::make({{{0, 0}, {1, 0}, {0.5, 0.1}}, {{2, 0}, {3, 0}, {2.5, 0.8}}});
  const auto quality = CGAL::mesh_quality_2(cdt);
  EXPECT_EQ(quality.number_of_obtuse_triangles(), 1u);
  EXPECT_FALSE(quality.is_well_centered());
  CDT acute = domains::make({{{2, 0}, {3, 0}, {2.5, 0.8}}});
  EXPECT_TRUE(CGAL::mesh_quality_2(acute).is_well_centered());
}

} // namespace test_outlines
