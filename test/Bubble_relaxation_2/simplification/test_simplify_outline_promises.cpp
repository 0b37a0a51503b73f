// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What is promised of simplified outlines where rules, pins, constraints within and hierarchies of them meet, and when
// they cannot be written.

#include "counted_memory.h"
#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Filtered_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_simplify_outline_promises {

using namespace counted_memory;
using namespace domains;
using namespace rough_outlines;
using CGAL::parameters::sizing_function;
using validation::Segment;
using validation::Snapshot;
using validation::Xy;
using Ctp = CGAL::Constrained_triangulation_plus_2<CDT>;
using Report = CGAL::Outline_simplification_report_2;
using Pins = std::set<CDT::Vertex_handle>;
namespace parameters = CGAL::Bubble_relaxation_parameters;

template <class Cdt>
bool is_in_domain(const Cdt& cdt, typename Cdt::Vertex_handle v)
{
  bool is_inside = false;
  auto f = cdt.incident_faces(v), start = f;
  do
    is_inside |= !cdt.is_infinite(f) && f->is_in_domain();
  while (++f != start);
  return is_inside;
}

/// sides of a square, each in parts
Outline square_in_parts(double side, int n)
{
  Outline o;
  const Outline corners = square(0, 0, side);
  for (std::size_t k = 0; k < 4; ++k)
    for (int i = 0; i < n; ++i) {
      const auto &a = corners[k], &b = corners[(k + 1) % 4];
      o.push_back({a.first + i * (b.first - a.first) / n, a.second + i * (b.second - a.second) / n});
    }
  return o;
}

TEST(Simplify_outline_promises, a_vertex_may_come_into_the_place_of_one_that_is_dropped)
{
  const Outline shore = coast(0, 0, 10, 900, 1);
  const auto np = sizing_function(1.).minimum_island_area(0.01);
  CDT without = make({shore});
  CGAL::simplify_outline_2(without, np);
  const Snapshot wanted = validation::snapshot(without);
  const std::vector<Point> points = points_of(shore);
  int tried = 0;
  for (const Xy& p : wanted.vertices) {
    const Outline island{p, {p.first + 1e-4, p.second}, {p.first, p.second + 1e-4}};
    const auto is_in_water = [&points](const Xy& q) {
      return CGAL::bounded_side_2(points.begin(), points.end(), Point(q.first, q.second)) == CGAL::ON_BOUNDED_SIDE;
    };
    if (!std::all_of(island.begin(), island.end(), is_in_water))
      continue;
    CDT cdt = make({shore, island});
    const Report report = CGAL::simplify_outline_2(cdt, np);
    EXPECT_EQ(report.dropped_islands.size(), 1u);
    EXPECT_TRUE(cdt.is_valid());
    EXPECT_TRUE(validation::snapshot(cdt) == wanted);
    ++tried;
  }
  EXPECT_GT(tried, 3);
}

TEST(Simplify_outline_promises, a_closed_constraint_stays_one_wherever_it_starts)
{
  const Outline square = square_in_parts(10, 8);
  for (std::size_t start = 0; start < square.size(); ++start) {
    Outline o = square;
    std::rotate(o.begin(), o.begin() + static_cast<std::ptrdiff_t>(start), o.end());
    Ctp cdt;
    const auto id = insert(cdt, o);
    const Report report = CGAL::simplify_outline_2(cdt, sizing_function(1.));
    std::vector<Segment> pieces;
    for (const Report::Piece& p : report.pieces)
      pieces.push_back(segment(p.source, p.target));
    std::sort(pieces.begin(), pieces.end());
    EXPECT_EQ(segments_of(cdt, id), pieces);
    auto last = cdt.vertices_in_constraint_end(id);
    EXPECT_EQ(*cdt.vertices_in_constraint_begin(id), *--last);
    EXPECT_EQ(cdt.number_of_constraints(), 1u);
  }
}

// as if it were open: it goes on beyond its start
TEST(Simplify_outline_promises, a_constraint_may_overlap_itself)
{
  Ctp cdt;
  const auto id = insert(cdt, {{0, 0}, {10, 0}, {5, 9}, {0, 0}, {10, 0}}, false);
  CGAL::simplify_outline_2(cdt, sizing_function(1.));
  const auto segments = segments_of(cdt, id);
  EXPECT_EQ(std::set<Segment>(segments.begin(), segments.end()).size() + 10, segments.size());
}

/// the least of a few calls; of this process alone, whatever else the machine does
std::clock_t time_of_simplifying(const CDT& original, double d)
{
  std::clock_t least = (std::numeric_limits<std::clock_t>::max)();
  for (int k = 0; k < 3; ++k) {
    CDT cdt(original);
    const std::clock_t start = std::clock();
    CGAL::simplify_outline_2(cdt, d);
    least = (std::min)(least, std::clock() - start);
  }
  return least;
}

TEST(Simplify_outline_promises, long_straight_edges_take_no_square_of_the_time)
{
  for (double turn : {0.785398, 0.3}) { // the first has sides along the axes, up to roundings
    const CDT small = make({polygon(0, 0, 250, 4, turn)}), large = make({polygon(0, 0, 2000, 4, turn)});
    EXPECT_LE(time_of_simplifying(large, 1), 25 * time_of_simplifying(small, 1));
  }
}

/// each piece was tested with all in the box of what was left of its line
TEST(Simplify_outline_promises, long_slanted_edges_beside_each_other_take_no_square_of_the_time)
{
  const auto channels = [](int n) {
    Outline comb{{n, -1}, {0, -1}};
    for (int k = 0; k < n; ++k)
      comb.insert(comb.end(), {{k, 0.3 * k}, {k + 0.7 * n, 3. * n + 0.3 * k}, {k + 0.7 * n + 0.3, 3. * n + 0.3 * k},
                               {k + 0.3, 0.3 * k}});
    return make({comb});
  };
  EXPECT_LE(time_of_simplifying(channels(40), 1), 30 * time_of_simplifying(channels(10), 1)); // 16 times as many pieces
}

TEST(Simplify_outline_promises, rows_of_vertices_take_no_square_of_the_time)
{
  const auto lattice = [](int n) {
    CDT cdt = make({square(0, 0, n)});
    for (int i = 1; i < n; ++i)
      for (int j = 1; j < n; ++j)
        cdt.insert(Point(i + 0.2 * std::sin(1e4 * j), j + 0.2 * std::sin(1e4 * i)));
    return cdt;
  };
  EXPECT_LE(time_of_simplifying(lattice(160), 16), 50 * time_of_simplifying(lattice(40), 4)); // 16 times as many
}

TEST(Simplify_outline_promises, the_most_places_take_gigabytes_only)
{
  constexpr double radius = 2200, places = 16 * 6.283 * radius;
  CDT cdt = make({polygon(0, 0, radius, 2000)});
  const std::size_t before = memory;
  most_memory = memory;
  CGAL::simplify_outline_2(cdt, 1.);
  EXPECT_LE(static_cast<double>(most_memory - before), 120 * places);
}

TEST(Simplify_outline_promises, a_size_alone_is_the_sizing_function)
{
  CDT cdt = make({coast(0, 0, 10, 900, 1)}), same(cdt);
  CGAL::simplify_outline_2(cdt, 0.5);
  CGAL::simplify_outline_2(same, sizing_function(0.5));
  EXPECT_TRUE(validation::snapshot(cdt) == validation::snapshot(same));
}

TEST(Simplify_outline_promises, constraints_within_the_domain_make_it_no_narrower)
{
  const auto np = sizing_function(1.).minimum_gap(1.);
  CDT beside_shore = make({square(0, 0, 20)});
  insert(beside_shore, {{2, 0.4}, {18, 0.4}}, false);
  EXPECT_EQ(CGAL::simplify_outline_2(beside_shore, np).filled_gaps.size(), 0u);
  std::mt19937 random(random_seeds::seed());
  std::uniform_real_distribution<double> place(0.1, 9.9);
  for (int k = 0; k < 40; ++k) {
    CDT cdt = make({square(0, 0, 10)});
    insert(cdt, {{place(random), place(random)}, {place(random), place(random)}}, false);
    EXPECT_EQ(filled_area(CGAL::simplify_outline_2(cdt, np)), 0);
  }
  // a channel is filled up to a line across it, beside which a lake remains
  CDT channel = make({{{0, 0}, {10, 0}, {10, 4.6}, {30, 4.6}, {30, 0}, {40, 0}, {40, 10}, {30, 10}, {30, 5}, {10, 5},
                       {10, 10}, {0, 10}}});
  insert(channel, {{20, 4.6}, {20, 5}}, false);
  EXPECT_NEAR(filled_area(CGAL::simplify_outline_2(channel, np)), 8, 0.5);
  EXPECT_EQ(validation::snapshot(channel).vertices.count({20, 4.6}), 1u);
  EXPECT_EQ(validation::snapshot(channel).vertices.count({20, 5}), 1u);
}

TEST(Simplify_outline_promises, pins_stay_in_the_domain)
{
  // a lagoon behind a narrow channel
  const Outline lagoon{{0, 0}, {10, 0}, {10, 4.75}, {12, 4.75}, {12, 4}, {13.75, 4}, {13.75, 5.75}, {12, 5.75}, {12, 5},
                       {10, 5}, {10, 10}, {0, 10}};
  const auto np = parameters::sizing_function(1.).minimum_gap(1.);
  CDT empty = make({lagoon});
  EXPECT_NEAR(filled_area(CGAL::simplify_outline_2(empty, np)), 0.5 + 1.75 * 1.75, 1e-9);
  for (const Point& p : {Point(12.9, 4.9), Point(13.75, 4), Point(13.75, 5), Point(12.2, 4.9)}) {
    CDT cdt = make({lagoon});
    const Pins pins{cdt.insert(p)};
    const CGAL::Boolean_property_map<const Pins> map(pins);
    const Report report = CGAL::simplify_outline_2(cdt, np.vertex_is_constrained_map(map));
    EXPECT_NEAR(filled_area(report), 0.5, 1e-9); // the channel
    EXPECT_EQ((*pins.begin())->point(), p);
    EXPECT_TRUE(is_in_domain(cdt, *pins.begin()));
  }
}

TEST(Simplify_outline_promises, pins_make_the_domain_no_narrower)
{
  std::mt19937 random(random_seeds::seed(1));
  std::uniform_real_distribution<double> place(0.01, 0.99);
  double area = 0;
  for (int k = 0; k < 100; ++k) {
    CDT cdt = make({square(0, 0, 10)});
    const Pins pins{cdt.insert(Point(place(random), place(random)))};
    const CGAL::Boolean_property_map<const Pins> map(pins);
    area += filled_area(CGAL::simplify_outline_2(
      cdt, parameters::sizing_function(1.).minimum_gap(1.).vertex_is_constrained_map(map)));
  }
  EXPECT_LE(area, 0.5); // rarely a corner that a pin closes
}

TEST(Simplify_outline_promises, pins_on_shores_stay_in_the_domain)
{
  for (unsigned k = 0; k < 6; ++k) {
    CDT cdt = make(archipelago(random_seeds::seed(20 + k)));
    std::mt19937 random(random_seeds::seed(30 + k));
    Pins pins;
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
      if (random() % 20 == 0)
        pins.insert(v);
    const CGAL::Boolean_property_map<const Pins> map(pins);
    CGAL::simplify_outline_2(
      cdt,
      parameters::sizing_function(0.5).minimum_island_area(0.05).minimum_gap(0.9).vertex_is_constrained_map(map));
    EXPECT_TRUE(cdt.is_valid());
    for (CDT::Vertex_handle v : pins)
      EXPECT_TRUE(is_in_domain(cdt, v)) << v->point();
  }
}

TEST(Simplify_outline_promises, rules_do_not_look_at_ends_of_constraints)
{
  Ctp island = make<Ctp>({square(0, 0, 20)});
  const std::vector<Point> corners = points_of(square(8, 8, 0.5));
  for (std::size_t k = 0; k < 4; ++k)
    island.insert_constraint(corners[k], corners[(k + 1) % 4]);
  EXPECT_EQ(CGAL::simplify_outline_2(island, sizing_function(1.).minimum_island_area(1.)).dropped_islands.size(), 1u);
  EXPECT_EQ(island.number_of_constraints(), 1u);
  for (const Point& p : corners)
    EXPECT_EQ(validation::snapshot(island).vertices.count({p.x(), p.y()}), 0u);

  Ctp touching = make<Ctp>({square(0, 0, 20), {{5, 5}, {10, 10}, {5, 10}}, {{10, 10}, {15, 10}, {15, 15}}});
  CGAL::simplify_outline_2(touching, sizing_function(1.).minimum_gap(1.));
  EXPECT_TRUE(touching.is_valid());
  EXPECT_EQ(number_of_pinches(touching), 0u);
}

TEST(Simplify_outline_promises, rules_do_the_same_in_a_hierarchy)
{
  for (unsigned k = 0; k < 4; ++k) {
    const std::vector<Outline> outlines = archipelago(random_seeds::seed(40 + k));
    const auto np = sizing_function(0.5).minimum_island_area(0.05).minimum_gap(0.6);
    CDT plain = make(outlines);
    Ctp hierarchy = make<Ctp>(outlines);
    const Report report = CGAL::simplify_outline_2(plain, np), again = CGAL::simplify_outline_2(hierarchy, np);
    EXPECT_TRUE(hierarchy.is_valid());
    EXPECT_TRUE(validation::snapshot(plain) == validation::snapshot(hierarchy));
    EXPECT_EQ(filled_area(report), filled_area(again));
    EXPECT_EQ(report.dropped_islands.size(), again.dropped_islands.size());
    for (auto c = hierarchy.constraints_begin(); c != hierarchy.constraints_end(); ++c)
      for (const Segment& s : segments_of(hierarchy, *c))
        EXPECT_GT(validation::length(s), 0);
  }
}

TEST(Simplify_outline_promises, constraints_outside_of_the_domain_stay)
{
  const Outline pond = polygon(5, 5, 2, 90), line{{4, 5}, {4.5, 5.1}, {5, 5}, {5.2, 6}}, to_shore{pond[0], {6, 5.2}};
  for (double gap : {0., 1.}) {
    CDT cdt = make({square(0, 0, 10), pond});
    insert(cdt, line, false);
    insert(cdt, to_shore, false);
    CGAL::simplify_outline_2(cdt, sizing_function(1.).minimum_island_area(20.).minimum_gap(gap));
    const Snapshot after = validation::snapshot(cdt);
    for (const Outline& o : {line, to_shore})
      for (std::size_t k = 1; k < o.size(); ++k)
        EXPECT_EQ(std::count(after.constraints.begin(), after.constraints.end(),
                             Segment((std::min)(o[k - 1], o[k]), (std::max)(o[k - 1], o[k]))),
                  1);
    EXPECT_LT(validation::domain_area(cdt), 90); // the pond is no part of it
  }
}

/// two basins with a narrow channel between them, whose banks have vertices `step` apart
Outline basins_with_channel(double step)
{
  Outline o{{0, 0}, {10, 0}};
  const int n = static_cast<int>(std::lround(10 / step));
  for (int i = 0; i <= n; ++i)
    o.push_back({10 + 10. * i / n, 5});
  o.insert(o.end(), {{20, 0}, {30, 0}, {30, 10}, {20, 10}});
  for (int i = n; i >= 0; --i)
    o.push_back({10 + 10. * i / n, 5.08});
  o.insert(o.end(), {{10, 10}, {0, 10}});
  return o;
}

TEST(Simplify_outline_promises, a_channel_with_pinned_banks_is_not_filled)
{
  const double gap = 0.6;
  for (const bool is_pinned : {true, false}) {
    CDT cdt = make({basins_with_channel(gap / 3)});
    Pins pins;
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
      if (is_pinned && v->point().y() > 4 && v->point().y() < 6)
        pins.insert(v);
    const CGAL::Boolean_property_map<const Pins> map(pins);
    const auto np = sizing_function(1.).minimum_gap(gap).vertex_is_constrained_map(map);
    const Report report = CGAL::simplify_outline_2(cdt, np);
    EXPECT_EQ(report.filled_gaps.empty(), is_pinned);
  }
}

/// of two edges of the boundary, in degrees
double least_corner(const CDT& cdt)
{
  std::map<Xy, std::vector<Xy>> next;
  for (const Segment& s : validation::snapshot(cdt).constraints) {
    next[s.first].push_back(s.second);
    next[s.second].push_back(s.first);
  }
  double largest_cosine = -1;
  for (const auto& [p, ends] : next) {
    const Point v(p.first, p.second);
    const auto a = Point(ends[0].first, ends[0].second) - v, b = Point(ends[1].first, ends[1].second) - v;
    largest_cosine = (std::max)(largest_cosine, a * b / std::sqrt(a.squared_length() * b.squared_length()));
  }
  return std::acos(largest_cosine) * 180 / CGAL_PI;
}

TEST(Simplify_outline_promises, fills_have_no_sharp_ends_if_wider_than_three_tolerances)
{
  for (double degrees : {8., 15., 25.}) // an island with a side that leaves a shore at this angle
    for (double gap : {1.2, 1.6, 2.}) {
      const double c = std::cos(degrees * CGAL_PI / 180), s = std::sin(degrees * CGAL_PI / 180);
      CDT cdt = make({{{0, 0}, {60, 0}, {60, 30}, {0, 30}},
                      {{20, 0.05}, {20 + 12 * c, 0.05 + 12 * s}, {20 + 12 * c - 4 * s, 0.05 + 12 * s + 4 * c},
                       {20 - 4 * s, 0.05 + 4 * c}}});
      const Report report = CGAL::simplify_outline_2(cdt, sizing_function(4.).outline_tolerance(0.4).minimum_gap(gap));
      EXPECT_EQ(report.filled_gaps.size(), 1u);
      EXPECT_GT(least_corner(cdt), 60);
    }
}

TEST(Simplify_outline_promises, corners_are_kept_up_to_the_angle)
{
  const auto corners = [](int n, double angle) {
    CDT cdt = make({polygon(0, 0, 20, n)});
    return CGAL::simplify_outline_2(cdt, sizing_function(1.).corner_angle(angle)).number_of_corners;
  };
  EXPECT_EQ(corners(6, 121), 6u);
  EXPECT_EQ(corners(6, 119), 0u);
  EXPECT_EQ(corners(3, 61), 3u);
  EXPECT_EQ(corners(3, 59), 0u);
  EXPECT_EQ(corners(3, 0), 0u);
}

TEST(Simplify_outline_promises, of_two_tolerances_the_smaller_one_counts)
{
  const Outline shore = coast(0, 0, 10, 900, 1);
  const auto simplified = [&](const auto& np) {
    CDT cdt = make({shore});
    CGAL::simplify_outline_2(cdt, np.sizing_function([](const Point& p) { return p.x() < 0 ? 0.5 : 2; }));
    return validation::snapshot(cdt);
  };
  const auto length = [](double l) { return parameters::outline_tolerance(l); };
  const auto share = [](double s) { return parameters::relative_outline_tolerance(s); };
  EXPECT_TRUE(simplified(length(0.04).relative_outline_tolerance(0.1)) == simplified(length(0.04)));
  EXPECT_TRUE(simplified(length(0.3).relative_outline_tolerance(0.1)) == simplified(share(0.1)));
  const Snapshot both = simplified(length(0.1).relative_outline_tolerance(0.1)); // each in a part
  EXPECT_FALSE(both == simplified(length(0.1)));
  EXPECT_FALSE(both == simplified(share(0.1)));
}

TEST(Simplify_outline_promises, scaling_by_a_power_of_two_changes_no_bit)
{
  const std::vector<Outline> outlines = archipelago(random_seeds::seed(50));
  for (const bool has_rules : {false, true})
    for (const double scale : {std::ldexp(1., -40), std::ldexp(1., -70)}) {
      const auto np = [&](double s) {
        return sizing_function(0.5 * s).minimum_island_area(has_rules ? 0.05 * s * s : 0.)
          .minimum_gap(has_rules ? 0.4 * s : 0.);
      };
      CDT cdt = make(outlines), small = make(scaled(outlines, scale));
      const Report report = CGAL::simplify_outline_2(cdt, np(1)), again = CGAL::simplify_outline_2(small, np(scale));
      std::vector<Segment> expected = validation::snapshot(cdt).constraints;
      for (Segment& s : expected)
        s = {{scale * s.first.first, scale * s.first.second}, {scale * s.second.first, scale * s.second.second}};
      EXPECT_EQ(validation::snapshot(small).constraints, expected);
      EXPECT_EQ(filled_area(again), scale * scale * filled_area(report));
      EXPECT_EQ(again.dropped_islands.size(), report.dropped_islands.size());
      EXPECT_EQ(report.filled_gaps.empty(), !has_rules);
    }
}

TEST(Simplify_outline_promises, gaps_that_are_roundings)
{
  constexpr double step = 1. / 524288; // of numbers there
  CDT cdt = make({square(1e10, 1e10, 0.0078125), square(1e10 + 2 * step, 1e10 + 0.00390625, 0.001953125)});
  const Snapshot before = validation::snapshot(cdt);
  expect_invalid([&] { CGAL::simplify_outline_2(cdt, sizing_function(1.).minimum_gap(4e-6)); },
                 {"minimum_gap = 4e-06", "roundings"});
  EXPECT_TRUE(validation::snapshot(cdt) == before);
}

using Float = CGAL::Filtered_kernel<CGAL::Simple_cartesian<float>>;
template <class Tag>
using Float_cdt = Cdt_of<Float, Tag>;

/// expects the error of numbers that are too coarse, and the same content as before
template <class Cdt>
void expect_too_coarse(Cdt cdt, double d, const std::string& where)
{
  const Snapshot before = validation::snapshot(cdt);
  expect_throw<std::runtime_error>([&] { CGAL::simplify_outline_2(cdt, sizing_function(d).outline_tolerance(0.01)); },
                                   {"too coarse", where});
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_TRUE(validation::snapshot(cdt) == before);
}

template <class Cdt>
void test_coarse_numbers()
{
  constexpr double far = 16000000; // where floats are 1 apart
  expect_too_coarse(make<Cdt>({square(far, far, 64)}), 0.5, "vertex (");
  // pieces that are nearer to each other than that
  const Outline slanted{{far, far}, {far + 570, far + 188}, {far + 572, far + 189}, {far + 4, far + 2}};
  expect_too_coarse(make<Cdt>({slanted}), 9, "segment from");
}

TEST(Simplify_outline_promises, numbers_that_are_too_coarse)
{
  test_coarse_numbers<Float_cdt<CGAL::No_constraint_intersection_tag>>();
  test_coarse_numbers<Float_cdt<CGAL::No_constraint_intersection_requiring_constructions_tag>>();
  test_coarse_numbers<Float_cdt<CGAL::Exact_predicates_tag>>();
  test_coarse_numbers<CGAL::Constrained_triangulation_plus_2<Float_cdt<CGAL::Exact_predicates_tag>>>();
}

/// lets memory end after more and more allocations
template <class Cdt>
void expect_content_kept(const std::vector<Outline>& outlines)
{
  const auto np = sizing_function(0.5).minimum_island_area(0.05).minimum_gap(0.4);
  Cdt cdt = make<Cdt>(outlines);
  const Snapshot before = validation::snapshot(cdt);
  int failures = 0;
  for (long n = 100;; n = n + n / 8) {
    allocations_left = n;
    try {
      CGAL::simplify_outline_2(cdt, np);
      allocations_left = -1;
      break;
    } catch (const std::bad_alloc&) {
      allocations_left = -1;
      ++failures;
    }
    EXPECT_TRUE(cdt.is_valid());
    EXPECT_TRUE(validation::snapshot(cdt) == before);
  }
  EXPECT_GT(failures, 20);
  Cdt fresh = make<Cdt>(outlines);
  CGAL::simplify_outline_2(fresh, np);
  EXPECT_TRUE(validation::snapshot(cdt) == validation::snapshot(fresh));
}

TEST(Simplify_outline_promises, without_memory_all_stays)
{
  std::vector<Outline> outlines = archipelago(random_seeds::seed(60));
  outlines.resize(8);
  expect_content_kept<CDT>(outlines);
  expect_content_kept<Ctp>(outlines);
}

} // namespace test_simplify_outline_promises
