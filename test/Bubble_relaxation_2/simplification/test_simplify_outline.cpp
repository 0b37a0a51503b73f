// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Properties of the outlines that simplify_outline_2() makes.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_simplify_outline {

using namespace domains;
using namespace rough_outlines;
using validation::Segment;
using validation::Snapshot;
using validation::Xy;
using Report = CGAL::Outline_simplification_report_2;
using Pins = std::set<CDT::Vertex_handle>;

Outline comb(int teeth, double gap)
{
  Outline o{{0, 0}};
  for (int i = 0; i < teeth; ++i) {
    o.push_back({i + 0.5 - gap / 2, 0.07 * (i % 3)});
    o.push_back({i + 0.5 - gap / 2, 2});
    o.push_back({i + 0.5 + gap / 2, 2.03});
    o.push_back({i + 0.5 + gap / 2, 0.05 * (i % 2)});
  }
  o.push_back({static_cast<double>(teeth), 0});
  o.push_back({static_cast<double>(teeth), 3});
  o.push_back({0, 3});
  return o;
}

Outline star(int tips, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.3, 3);
  Outline o;
  for (int i = 0; i < 2 * tips; ++i) {
    const double t = 3.141592653589793 * i / tips, r = i % 2 == 0 ? 3 + radius(random) : 0.3 * radius(random);
    o.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return o;
}

/// a square with some edges of a triangulation of random points, and isolated pins
CDT random_graph(unsigned seed, Pins& pins)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.3, 9.7), chance(0, 1);
  CGAL::Delaunay_triangulation_2<K> dt;
  for (int i = 0; i < 60; ++i)
    dt.insert(Point(place(random), place(random)));
  CDT cdt = make({square(0, 0, 10)});
  std::vector<std::pair<Point, Point>> edges;
  for (const auto& e : dt.finite_edges())
    edges.emplace_back((dt.segment(e).min)(), (dt.segment(e).max)());
  std::sort(edges.begin(), edges.end());
  for (const auto& e : edges)
    if (chance(random) < 0.4)
      cdt.insert_constraint(e.first, e.second);
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
    if (chance(random) < 0.1)
      pins.insert(v);
  for (int i = 0; i < 5; ++i)
    pins.insert(cdt.insert(Point(place(random), place(random))));
  return cdt;
}

/// what a simplification must keep
struct Topology
{
  std::size_t components, regions, domain_regions;
  friend bool operator==(const Topology& a, const Topology& b)
  {
    return a.components == b.components && a.regions == b.regions && a.domain_regions == b.domain_regions;
  }
};

void PrintTo(const Topology& t, std::ostream* out)
{
  *out << t.components << " components, " << t.regions << " regions, " << t.domain_regions << " of the domain";
}

template <class Cdt>
Topology topology(const Cdt& cdt)
{
  std::map<Xy, Xy> parent;
  const auto root = [&](Xy v) {
    while (parent.emplace(v, v).first->second != v)
      v = parent[v];
    return v;
  };
  for (const Segment& s : validation::snapshot(cdt).constraints) {
    const Xy a = root(s.first), b = root(s.second);
    parent[a] = b;
  }
  Topology t{0, 0, 0};
  for (const auto& p : parent)
    t.components += p.first == p.second;
  const CGAL::Bubble_relaxation_2::internal::Domain_marks_2<Cdt> marks(cdt, CGAL::parameters::default_values());
  std::set<typename Cdt::Face_handle> seen;
  for (auto f : cdt.all_face_handles()) {
    if (!seen.insert(f).second)
      continue;
    ++t.regions;
    t.domain_regions += !cdt.is_infinite(f) && marks(f);
    std::vector<typename Cdt::Face_handle> region{f};
    while (!region.empty()) {
      const auto g = region.back();
      region.pop_back();
      for (int i = 0; i < 3; ++i)
        if (!g->is_constrained(i) && seen.insert(g->neighbor(i)).second)
          region.push_back(g->neighbor(i));
    }
  }
  return t;
}

/// of the domain, as nesting tells it
double area_of_domain(const CDT& cdt)
{
  const CGAL::Bubble_relaxation_2::internal::Domain_marks_2<CDT> marks(cdt, CGAL::parameters::default_values());
  double sum = 0;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    sum += marks(f) ? cdt.triangle(f).area() : 0;
  return sum;
}

double distance(const Xy& p, const Segment& s)
{
  const double dx = s.second.first - s.first.first, dy = s.second.second - s.first.second;
  const double t = ((p.first - s.first.first) * dx + (p.second - s.first.second) * dy) / (dx * dx + dy * dy);
  const double u = (std::max)(0., (std::min)(1., t));
  return std::hypot(p.first - s.first.first - u * dx, p.second - s.first.second - u * dy);
}

/// from sampled points of some segments
double largest_distance(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  double largest = 0;
  for (const Segment& s : from)
    for (int i = 0; i <= 16; ++i) {
      const double t = i / 16.;
      const Xy p{s.first.first + t * (s.second.first - s.first.first),
                 s.first.second + t * (s.second.second - s.first.second)};
      double least = 1e300;
      for (const Segment& other : to)
        least = (std::min)(least, distance(p, other));
      largest = (std::max)(largest, least);
    }
  return largest;
}

/// simplifies with all checks; a fraction of d is the tolerance
Report simplify_and_check(CDT& cdt, double d, double share, const Pins& pins = {})
{
  const Snapshot before = validation::snapshot(cdt);
  const Topology old_topology = topology(cdt);
  const double old_area = area_of_domain(cdt);
  std::map<Xy, int> degree;
  for (const Segment& s : before.constraints)
    for (const Xy& p : {s.first, s.second})
      ++degree[p];
  std::vector<std::pair<CDT::Vertex_handle, Xy>> pinned;
  for (CDT::Vertex_handle v : pins)
    pinned.emplace_back(v, validation::xy(v));

  const CGAL::Boolean_property_map<const Pins> map(pins);
  const Report report = CGAL::simplify_outline_2(
    cdt,
    CGAL::Bubble_relaxation_parameters::sizing_function(d).relative_outline_tolerance(share).vertex_is_constrained_map(
      map));

  EXPECT_TRUE(cdt.is_valid());
  const Snapshot after = validation::snapshot(cdt);
  EXPECT_EQ(after.constraints.size(), report.pieces.size());
  EXPECT_LE(report.number_of_segments, report.pieces.size()); // some may be outside of the domain
  EXPECT_EQ(topology(cdt), old_topology);
  double extent = 0;
  for (const Xy& p : before.vertices)
    extent = (std::max)({extent, std::abs(p.first), std::abs(p.second)});
  EXPECT_NEAR(report.old_area, old_area, 1e-12 * extent * extent);
  EXPECT_NEAR(report.area, area_of_domain(cdt), 1e-12 * extent * extent);
  const double measured = (std::max)(largest_distance(before.constraints, after.constraints),
                                     largest_distance(after.constraints, before.constraints));
  EXPECT_LE(report.hausdorff_distance, share * d);
  EXPECT_LE(measured, report.hausdorff_distance + 1e-9 * d);
  EXPECT_GE(measured, 0.9 * report.hausdorff_distance); // sampled
  EXPECT_LE(report.largest_share_of_tolerance, 1);
  for (const auto& p : degree)
    EXPECT_TRUE(p.second == 2 || after.vertices.count(p.first) == 1);
  for (const auto& p : pinned)
    EXPECT_EQ(validation::xy(p.first), p.second);
  for (const Segment& s : after.constraints)
    if (std::count(before.constraints.begin(), before.constraints.end(), s) == 0) // those outside of the domain stay
      EXPECT_LE(validation::length(s), 1.5 * d * (1 + 1e-9) + share * d);
  return report;
}

TEST(Simplify_outline, coasts)
{
  for (unsigned k = 0; k < 4; ++k) {
    CDT cdt = make({coast(0, 0, 10, 1500, random_seeds::seed(k))});
    const Report report = simplify_and_check(cdt, 1, 0.1);
    EXPECT_GE(report.share_of_fitting_pieces, 0.9);
    EXPECT_LE(report.number_of_segments, 160u);
  }
}

TEST(Simplify_outline, archipelagos)
{
  for (unsigned k = 0; k < 4; ++k)
    for (double share : {0.02, 0.1, 0.3}) {
      CDT cdt = make(archipelago(random_seeds::seed(10 + k)));
      simplify_and_check(cdt, 0.5, share);
    }
}

TEST(Simplify_outline, combs_and_stars)
{
  for (double gap : {0.01, 0.1, 0.4})
    for (double d : {0.3, 1., 4.}) {
      CDT cdt = make({comb(7, gap)});
      simplify_and_check(cdt, d, 0.1);
      CDT wide = make({comb(7, gap)});
      simplify_and_check(wide, d, 0.5);
    }
  for (unsigned k = 0; k < 4; ++k) {
    CDT cdt = make({star(9 + static_cast<int>(k), random_seeds::seed(k))});
    simplify_and_check(cdt, 0.7, 0.15);
  }
}

TEST(Simplify_outline, random_graphs_with_pins)
{
  for (unsigned k = 0; k < 10; ++k)
    for (double d : {0.4, 1.5, 6.}) {
      Pins pins;
      CDT cdt = random_graph(random_seeds::seed(20 + k), pins);
      simplify_and_check(cdt, d, 0.15, pins);
    }
}

TEST(Simplify_outline, a_fine_outline_has_pieces_that_fit)
{
  CDT cdt = make({polygon(0, 0, 10, 5000)});
  const Report report = simplify_and_check(cdt, 1, 0.1);
  EXPECT_EQ(report.share_of_fitting_pieces, 1);
  EXPECT_NEAR(static_cast<double>(report.number_of_segments), 63, 5);
}

TEST(Simplify_outline, vertices_a_thousand_times_denser_than_pieces)
{
  CDT cdt = make({polygon(0, 0, 2, 20000)});
  const Report report = simplify_and_check(cdt, 1, 0.1);
  EXPECT_EQ(report.share_of_fitting_pieces, 1);
  EXPECT_LE(report.number_of_segments, 15u);
  // something beside each vertex, nearer than what a row of them may be off
  CDT narrow = make({polygon(0, 0, 2, 1000), polygon(0, 0, 2 - 2e-5, 1000)});
  simplify_and_check(narrow, 1, 0.1);
}

TEST(Simplify_outline, corners_of_a_square_stay)
{
  CDT cdt = make({square(0, 0, 10), square(3.3, 4.4, 2.71)});
  const Report report = simplify_and_check(cdt, 1, 0.1);
  EXPECT_EQ(report.number_of_corners, 8u);
  EXPECT_LE(report.hausdorff_distance, 1e-14); // nothing but cuts of straight edges
  const Snapshot after = validation::snapshot(cdt);
  for (const Outline& o : {square(0, 0, 10), square(3.3, 4.4, 2.71)})
    for (const auto& p : o)
      EXPECT_EQ(after.vertices.count(p), 1u);
}

TEST(Simplify_outline, order_and_start_do_not_matter)
{
  const std::vector<Outline> outlines = archipelago(random_seeds::seed(3));
  CDT cdt = make(outlines);
  const auto simplify = [](CDT& t) {
    return CGAL::simplify_outline_2(t,
                                    CGAL::parameters::sizing_function(0.5).minimum_island_area(0.01).minimum_gap(0.3));
  };
  const Report report = simplify(cdt);
  std::mt19937 random(random_seeds::seed(4));
  for (int k = 0; k < 3; ++k) {
    CDT other = make(shuffled(outlines, random));
    const Report again = simplify(other);
    EXPECT_TRUE(validation::snapshot(cdt) == validation::snapshot(other));
    EXPECT_EQ(report.hausdorff_distance, again.hausdorff_distance);
    EXPECT_EQ(report.old_area, again.old_area);
    EXPECT_EQ(report.area, again.area);
    EXPECT_EQ(report.filled_gaps.size(), again.filled_gaps.size());
  }
}

TEST(Simplify_outline, small_islands_are_dropped)
{
  CDT cdt = make({square(0, 0, 20), square(4, 4, 3), square(12, 4, 0.5), square(12, 12, 4), square(13, 13, 1)});
  const Report report =
    CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.).minimum_island_area(0.5));
  ASSERT_EQ(report.dropped_islands.size(), 1u); // the one of 1 is a lake on an island
  EXPECT_EQ(report.dropped_islands[0].place, (Report::Place{12, 4}));
  EXPECT_EQ(report.dropped_islands[0].area, 0.25);
  EXPECT_NEAR(report.area, report.old_area + 0.25, 1e-12);
  EXPECT_EQ(topology(cdt).components, 4u);
}

TEST(Simplify_outline, channels_are_filled)
{
  // two basins with a channel between them, and two islands near to each other
  CDT cdt = make(
    {{{0, 0}, {10, 0}, {10, 4.8}, {14, 4.8}, {14, 0}, {24, 0}, {24, 10}, {14, 10}, {14, 5}, {10, 5}, {10, 10}, {0, 10}},
     square(3, 3, 2),
     square(5.3, 3, 2)});
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.).minimum_gap(0.8));
  EXPECT_EQ(report.filled_gaps.size(), 2u);
  EXPECT_EQ(number_of_pinches(cdt), 0u);
  EXPECT_EQ(topology(cdt).components, 3u);
  EXPECT_EQ(topology(cdt).domain_regions, 2u);
  const auto mesh = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(1.));
  EXPECT_GT(mesh.quality.mean_quality(), 0.97);
}

TEST(Simplify_outline, dropped_islands_leave_nothing_to_fill)
{
  CDT cdt = make({square(0, 0, 20), coast(5, 5, 0.2, 40, 1), coast(12, 12, 0.3, 60, 2)});
  const Report report =
    CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.).minimum_island_area(0.5).minimum_gap(1.));
  EXPECT_EQ(report.dropped_islands.size(), 2u);
  EXPECT_EQ(report.filled_gaps.size(), 0u);
  EXPECT_EQ(report.number_of_segments, 80u); // the square
}

TEST(Simplify_outline, vertices_of_a_mesh_do_not_count)
{
  const std::vector<Outline> outlines = archipelago(random_seeds::seed(8));
  const auto np = CGAL::Bubble_relaxation_parameters::sizing_function(0.5).minimum_gap(0.3);
  CDT cdt = make(outlines), meshed = make(outlines);
  CGAL::npbs_relax(meshed, CGAL::parameters::sizing_function(0.1));
  // what was cut by the mesher is as good as whole
  const Report report = CGAL::simplify_outline_2(cdt, np), again = CGAL::simplify_outline_2(meshed, np);
  EXPECT_TRUE(meshed.is_valid());
  EXPECT_NEAR(filled_area(again), filled_area(report), 0.1 * filled_area(report));
  EXPECT_LE(filled_area(report), 5); // of a hundred
}

TEST(Simplify_outline, corners_of_the_domain_are_not_gaps)
{
  CDT cdt = make({square(0, 0, 10), square(3, 3, 4)});
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.).minimum_gap(1.));
  EXPECT_EQ(report.filled_gaps.size(), 0u);
  EXPECT_EQ(report.number_of_corners, 8u);
}

TEST(Simplify_outline, corners_of_finely_sampled_walls_are_not_gaps)
{
  for (double degrees : {90., 100., 115., 130.}) // of the blunt corners of a rhombus
    for (int pieces = 10; pieces <= 100; pieces += 3) { // a side of 20
      const double sine = std::sin(degrees * CGAL_PI / 180), cosine = std::cos(degrees * CGAL_PI / 180);
      const Xy corners[] = {{0, 0}, {20, 0}, {20 - 20 * cosine, 20 * sine}, {-20 * cosine, 20 * sine}};
      Outline walls;
      for (int i = 0; i < 4; ++i)
        for (int k = 0; k < pieces; ++k) {
          const double t = k / double(pieces);
          const Xy &p = corners[i], &q = corners[(i + 1) % 4];
          walls.emplace_back(p.first + t * (q.first - p.first), p.second + t * (q.second - p.second));
        }
      CDT cdt = make({walls});
      const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(2.).minimum_gap(1.));
      EXPECT_LE(report.filled_gaps.size(), degrees == 90 ? 0u : 2u) << degrees << " degrees, " << pieces << " pieces";
      for (const Report::Gap& gap : report.filled_gaps) // the sharp corners, as far as they are narrower
        EXPECT_LT((std::min)(std::hypot(gap.place[0], gap.place[1]),
                             std::hypot(gap.place[0] - corners[2].first, gap.place[1] - corners[2].second)), 2)
          << degrees << " degrees, " << pieces << " pieces";
    }
}

TEST(Simplify_outline, long_walls_stay_straight)
{
  // an island beside a wall, where the domain would widen
  CDT cdt = make({square(0, 0, 50), {{2, 20}, {3, 19}, {4, 20}, {3, 22}}});
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(5.));
  std::size_t on_wall = 0;
  for (const Report::Piece& piece : report.pieces)
    if (piece.source[0] < 1 && piece.target[0] < 1) {
      ++on_wall;
      EXPECT_EQ(piece.source[0], 0);
      EXPECT_EQ(piece.target[0], 0);
    }
  EXPECT_EQ(on_wall, 10u);
  EXPECT_GT(report.hausdorff_distance, 0.2); // the island gives way
}

/// wherever vertices stay on them, where rings begin, and however text files have rounded them
TEST(Simplify_outline, walls_go_on_beyond_vertices_that_stay_and_roundings)
{
  const Outline island{{2, 20}, {3, 19}, {4, 20}, {3, 22}};
  CDT marked = make({square(0, 0, 50), island});
  const CGAL::Constraint_marker_map_2<CDT> markers;
  const auto middle = marked.insert(Point(0, 25)), corner = marked.insert(Point(0, 0));
  markers.set(middle, corner, 7);
  const auto np = CGAL::parameters::sizing_function(4.).edge_marker_map(markers);
  for (const Report::Piece& piece : CGAL::simplify_outline_2(marked, np).pieces)
    EXPECT_EQ(piece.source[0] < 1, piece.source[0] == 0);

  // a slanted wall, in places of 3 decimals
  const auto on_wall = [](double x, double y) { return std::abs(-0.6 * x + 0.8 * y); };
  Outline box;
  for (int k = 0; k < 500; ++k)
    box.push_back({std::round(1e3 * 0.8 * 0.1 * k) / 1e3, std::round(1e3 * 0.6 * 0.1 * k) / 1e3});
  for (const auto& p : Outline{{40, 30}, {10, 70}, {-30, 40}})
    box.push_back(p);
  CDT slanted = make({box, {{15.4, 12.3}, {16.4, 13}, {15.2, 14}}});
  std::size_t on_it = 0;
  for (const Report::Piece& piece : CGAL::simplify_outline_2(slanted, 1.).pieces)
    if (on_wall(piece.source[0], piece.source[1]) < 0.5) {
      ++on_it;
      EXPECT_LT(on_wall(piece.source[0], piece.source[1]), 0.001);
    }
  EXPECT_GT(on_it, 45u);
}

/// d between the ends of a long segment counts, too
TEST(Simplify_outline, pieces_are_what_d_is_between_corners)
{
  const auto d = [](const Point& p) { return 1 + 0.2 * std::abs(p.x() - 30); };
  for (double gap : {0., 1.}) {
    CDT cdt = make({square(0, 0, 100)});
    const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(d).minimum_gap(gap));
    for (const Report::Piece& p : report.pieces) {
      const double length = std::hypot(p.source[0] - p.target[0], p.source[1] - p.target[1]);
      EXPECT_LT(length, 1.5 * d(Point((p.source[0] + p.target[0]) / 2, (p.source[1] + p.target[1]) / 2)));
    }
    EXPECT_GT(report.share_of_fitting_pieces, 0.98);
  }
}

TEST(Simplify_outline, islands_and_narrows_force_vertices)
{
  const auto forced = [](const std::vector<Outline>& outlines, double d) {
    CDT cdt = make(outlines);
    const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(d));
    const auto mesh = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
    EXPECT_LE(report.wanted_vertices + report.forced_vertices, static_cast<double>(mesh.number_of_vertices));
    return report.forced_vertices;
  };
  const Outline sea = square(0, 0, 20);
  EXPECT_EQ(forced({sea}, 1), 0);
  EXPECT_EQ(forced({sea, square(9, 9, 2)}, 1), 0); // not smaller than d
  const double one = forced({sea, square(9, 9, 0.2)}, 1), two = forced({sea, square(5, 9, 0.2), square(14, 9, 0.2)}, 1);
  EXPECT_NEAR(one, 8, 0.8); // the integral around a point where the size is 0.557, from which it grows by 0.2
  EXPECT_NEAR(two, 2 * one, 0.1 * one);
  EXPECT_GT(forced({sea, square(4, 4, 5.9), square(10, 4, 5.9)}, 1), 10); // a channel of 0.1 between them
}

TEST(Simplify_outline, rough_sizes_in_the_interior_are_not_counted_forever)
{
  CDT cdt = make({square(0, 0, 1000), square(500, 500, 1)});
  double calls = 0;
  const auto rough_off_shore = [&](const Point& p) {
    ++calls;
    const bool is_at_shore =
      (std::min)({p.x(), p.y(), 1000 - p.x(), 1000 - p.y()}) < 1 || std::hypot(p.x() - 500, p.y() - 500) < 2;
    return is_at_shore ? 10 : 1e-4 * (2 + std::sin(1e6 * p.x()) * std::sin(1e6 * p.y()));
  };
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(rough_off_shore));
  EXPECT_LE(calls, 5e7);
  EXPECT_EQ(report.wanted_vertices, 0);
  EXPECT_EQ(report.forced_vertices, 0);
  EXPECT_GE(report.number_of_segments, 400u);
}

TEST(Simplify_outline, gaps_leave_no_vertex_with_more_than_two_edges)
{
  for (unsigned k = 0; k < 6; ++k) {
    CDT cdt = make(archipelago(random_seeds::seed(40 + k)));
    const Report report = CGAL::simplify_outline_2(
      cdt, CGAL::parameters::sizing_function(0.5).minimum_island_area(0.05).minimum_gap(0.9));
    EXPECT_TRUE(cdt.is_valid());
    EXPECT_EQ(number_of_pinches(cdt), 0u);
    EXPECT_GT(report.filled_gaps.size(), 0u);
  }
}

TEST(Simplify_outline, without_islands_and_narrows_meshes_are_good)
{
  constexpr double d = 0.5;
  for (unsigned k = 0; k < 4; ++k) {
    std::vector<Outline> outlines = archipelago(random_seeds::seed(60 + k));
    outlines.front() = coast(0, 0, 8, 3000, random_seeds::seed(70 + k));
    CDT cdt = make(outlines);
    const Report report = CGAL::simplify_outline_2(
      cdt, CGAL::parameters::sizing_function(d).minimum_island_area(d * d / 2).minimum_gap(d));
    const auto mesh = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
    EXPECT_LE(report.forced_vertices, 0.03 * report.wanted_vertices);
    EXPECT_GE(report.share_of_fitting_pieces, 0.94);
    EXPECT_LE(static_cast<double>(mesh.number_of_vertices), 1.22 * report.wanted_vertices);
    EXPECT_GE(mesh.quality.mean_quality(), 0.975); // a fifth of the vertices are on the outline
    EXPECT_GE(mesh.quality.minimum_angle(), 35.);
  }
}

TEST(Simplify_outline, seeds_stay_in_their_regions)
{
  const std::vector<Outline> outlines = archipelago(random_seeds::seed(6));
  CDT cdt = make(outlines);
  std::vector<Point> seeds;
  for (std::size_t k = 1; k + 1 < outlines.size(); ++k) { // near to the shore, on the way to the middle
    const double x = 1.7 * (static_cast<double>((k - 1) / 5) - 2), y = 1.7 * (static_cast<double>((k - 1) % 5) - 2);
    seeds.emplace_back(outlines[k][0].first * 0.9 + x * 0.1, outlines[k][0].second * 0.9 + y * 0.1);
  }
  const auto np = CGAL::Bubble_relaxation_parameters::seeds(seeds).sizing_function(0.5);
  CGAL::npbs_relax(cdt, np);
  CDT fresh = make(outlines);
  const Report report = CGAL::simplify_outline_2(fresh, np);
  EXPECT_EQ(report.seeds.size(), seeds.size());
  const double area = validation::domain_area(fresh); // marked
  CGAL::npbs_relax(fresh, np);
  EXPECT_NEAR(validation::domain_area(fresh), area, 1e-9 * area);
  EXPECT_NEAR(area, validation::domain_area(cdt), 0.05 * area);

  CDT emptier = make(outlines);
  const Report dropped = CGAL::simplify_outline_2(emptier, np.minimum_island_area(0.1));
  EXPECT_LT(dropped.seeds.size(), seeds.size());
  EXPECT_EQ(dropped.seeds.size(), seeds.size() - dropped.dropped_islands.size());
}

TEST(Simplify_outline, seeds_above_vertices_stay_in_their_regions)
{
  // tips to the left and to the right, below a seed at the same x, above one, or beside one
  const std::vector<Outline> outlines{square(0, 0, 40),
                                      {{10, 10}, {14, 8}, {14, 12}},
                                      {{30, 10}, {26, 12}, {26, 8}},
                                      {{8, 24}, {12, 24}, {10, 28}},
                                      square(36, 36, 0.5)};
  const std::vector<Point> in_domain{{10, 20}, {30, 20}, {10, 30}, {26, 20}, {14, 20}, {12, 30}, {20, 10}},
    in_holes{{12, 10}, {28, 10}, {10, 26}, {36.25, 36.25}};
  const auto np = CGAL::Bubble_relaxation_parameters::sizing_function(1.).minimum_island_area(1.);
  const auto places = [](const std::vector<Point>& points) {
    std::vector<Report::Place> result;
    for (const Point& p : points)
      result.push_back({p.x(), p.y()});
    return result;
  };
  CDT by_domain = make(outlines), by_holes = make(outlines);
  const Report of_domain = CGAL::simplify_outline_2(by_domain, np.seeds(in_domain).seeds_are_in_domain(true));
  EXPECT_EQ(of_domain.dropped_islands.size(), 1u);
  EXPECT_EQ(of_domain.seeds, places(in_domain));
  const Report of_holes = CGAL::simplify_outline_2(by_holes, np.seeds(in_holes));
  EXPECT_EQ(of_holes.seeds, places({in_holes.begin(), in_holes.end() - 1}));
}

TEST(Simplify_outline, constraints_keep_their_identifiers)
{
  using Ctp = CGAL::Constrained_triangulation_plus_2<CDT>;
  Ctp cdt;
  std::vector<Ctp::Constraint_id> ids;
  for (const Outline& o : {coast(0, 0, 10, 900, 1), coast(-3, 0, 1, 100, 2), coast(3, 0, 1.5, 100, 3)})
    ids.push_back(insert(cdt, o));
  ids.push_back(insert(cdt, {{-1, -1}, {0, -1.01}, {1, -1}, {1.1, 1}}, false));
  std::vector<std::vector<Segment>> before;
  for (auto id : ids)
    before.push_back(segments_of(cdt, id));
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(cdt.number_of_constraints(), 4u);
  // each piece is of the constraint that its old segment was of
  std::map<Segment, std::size_t> old_constraint;
  for (std::size_t k = 0; k < ids.size(); ++k)
    for (const Segment& s : before[k])
      old_constraint[s] = k;
  std::vector<std::vector<Segment>> pieces(ids.size());
  for (const Report::Piece& p : report.pieces)
    pieces[old_constraint.at(segment(p.old_source, p.old_target))].push_back(segment(p.source, p.target));
  for (std::size_t k = 0; k < ids.size(); ++k) {
    std::sort(pieces[k].begin(), pieces[k].end());
    EXPECT_EQ(segments_of(cdt, ids[k]), pieces[k]);
    const auto first = cdt.vertices_in_constraint_begin(ids[k]);
    auto last = cdt.vertices_in_constraint_end(ids[k]);
    EXPECT_EQ(*first == *--last, k < 3);
  }
  EXPECT_EQ((*cdt.vertices_in_constraint_begin(ids[3]))->point(), Point(-1, -1));
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(1.));
  EXPECT_EQ(cdt.number_of_constraints(), 4u);
}

TEST(Simplify_outline, a_constraint_that_goes_there_and_back_goes_on_doing_so)
{
  using Ctp = CGAL::Constrained_triangulation_plus_2<CDT>;
  Ctp cdt;
  Outline outline = coast(0, 0, 10, 900, 1);
  outline.insert(outline.end(), {{0, 0}, Xy(outline.back())});
  const Ctp::Constraint_id id = insert(cdt, outline);
  CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(cdt.number_of_constraints(), 1u);
  const std::vector<Segment> segments = segments_of(cdt, id);
  EXPECT_LT(segments.size(), 200u);
  EXPECT_EQ(std::count_if(segments.begin(), segments.end(), [](const Segment& s) {
              return s.first == Xy(0, 0) || s.second == Xy(0, 0);
            }), 2);
}

TEST(Simplify_outline, pieces_tell_what_they_stand_for)
{
  CDT cdt = make({coast(0, 0, 10, 900, 1)});
  std::set<Segment> old;
  for (const Segment& s : validation::snapshot(cdt).constraints)
    old.insert(s);
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.));
  for (const Report::Piece& p : report.pieces) {
    EXPECT_FALSE(p.is_new);
    const Xy a{p.old_source[0], p.old_source[1]}, b{p.old_target[0], p.old_target[1]};
    EXPECT_EQ(old.count({(std::min)(a, b), (std::max)(a, b)}), 1u);
    EXPECT_LE(distance(a, {{p.source[0], p.source[1]}, {p.target[0], p.target[1]}}), 0.3);
  }
}

TEST(Simplify_outline, exact_kernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact>;
  Exact_cdt cdt = make<Exact_cdt>({coast(0, 0, 10, 900, 1), square(-1, -1, 2)});
  const Report report = CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_LE(report.hausdorff_distance, 0.1);
  EXPECT_EQ(validation::snapshot(cdt).constraints.size(), report.number_of_segments);
}

template <class NamedParameters>
void expect_refusal(CDT cdt, const NamedParameters& np, const std::vector<std::string>& words)
{
  expect_invalid([&] { CGAL::simplify_outline_2(cdt, np); }, words);
}

/// Where constraints of an exact kernel cross, `double` may have the crossing on the other side of another one.
TEST(Simplify_outline, what_an_exact_kernel_has_on_another_side_is_refused)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Default, CGAL::Exact_intersections_tag>;
  Exact_cdt cdt;
  insert(cdt, {{0.62288112774460191, 1.2774118970130361}, {0.62288112774460214, 1.2774118970130366},
               {0.62288112774460191, 1.2774118970130357}, {0.6228811277446018, 1.2774118970130364},
               {0.49324470764857098, -0.17551778246054853}});
  const Snapshot before = validation::snapshot(cdt);
  expect_throw<std::runtime_error>([&] { CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(0.34721)); },
                                   {"cannot be written", "0.49324", "too coarse"});
  EXPECT_TRUE(validation::snapshot(cdt) == before);
}

TEST(Simplify_outline, bad_input)
{
  const CDT good = make({square(0, 0, 1)});
  using CGAL::parameters::sizing_function;
  expect_refusal(CDT(), sizing_function(1.), {"dimension"});
  CDT open;
  insert(open, square(0, 0, 1), false);
  expect_refusal(open, sizing_function(1.), {"no face lies in the domain"});
  for (auto f : open.finite_face_handles())
    f->set_in_domain(true);
  expect_refusal(open, sizing_function(1.), {"(0, 0)", "(0, 1)", "must be constrained"});
  expect_refusal(good, sizing_function(0.), {"sizing_function", "= 0"});
  expect_refusal(good, sizing_function(1.).outline_tolerance(-1.), {"outline_tolerance = -1"});
  expect_refusal(good, sizing_function(1.).relative_outline_tolerance(0.), {"relative_outline_tolerance = 0"});
  expect_refusal(good, sizing_function(1.).relative_outline_tolerance(1.5),
                 {"relative_outline_tolerance = 1.5", "at most 1"});
  expect_refusal(good, sizing_function(1.).minimum_island_area(-1.), {"minimum_island_area = -1"});
  expect_refusal(good, sizing_function(1.).minimum_gap(std::nan("")), {"minimum_gap = nan"});
  expect_refusal(good, sizing_function(1.).corner_angle(-1.), {"corner_angle = -1"});
  expect_refusal(good, sizing_function(1.).corner_angle(181.), {"corner_angle = 181", "180"});
  expect_refusal(good, sizing_function(1.).minimum_gap(5.), {"minimum_gap = 5", "nothing"});
  CDT beside_a_constraint = good;
  insert(beside_a_constraint, {{3, 0}, {4, 1}}, false);
  expect_refusal(beside_a_constraint, sizing_function(1.).minimum_gap(5.), {"minimum_gap = 5", "nothing"});
  expect_refusal(good, CGAL::parameters::minimum_gap(5.), {"sizing_function", "outline_tolerance"});
  expect_refusal(good, sizing_function(1.).outline_tolerance(1e-20), {"outline_tolerance = 1e-20", "(0, 1)"});
  expect_refusal(good, sizing_function(2.).relative_outline_tolerance(1e-20),
                 {"relative_outline_tolerance = 1e-20", "d = 2", "(0, 1)"});
  // before the rules work, which would leave nothing
  expect_refusal(good, sizing_function(1.).outline_tolerance(1e-20).minimum_gap(5.), {"outline_tolerance = 1e-20"});
}

TEST(Simplify_outline, a_tolerance_up_to_the_size_is_taken)
{
  CDT share = make({square(0, 0, 1)}), length(share);
  using CGAL::parameters::sizing_function;
  CGAL::simplify_outline_2(share, sizing_function(0.2).relative_outline_tolerance(1.));
  const auto report = CGAL::simplify_outline_2(length, sizing_function(0.2).outline_tolerance(0.3)); // longer than d
  EXPECT_LE(report.hausdorff_distance, 0.3);
}

TEST(Simplify_outline, a_tolerance_forty_times_as_long_as_the_size_is_taken)
{
  CDT cdt = make({coast(0, 0, 10, 900, 1)});
  const Report report =
    CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(0.05).outline_tolerance(2));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_LE(report.largest_share_of_tolerance, 1);
  EXPECT_GT(report.share_of_fitting_pieces, 0.95);
}

TEST(Simplify_outline, sizes_far_too_small)
{
  CDT cdt = make({square(0, 0, 1)});
  expect_throw<std::length_error>([&] { CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1e-8)); },
                                  {"sizing_function", "pieces"});
  const auto np = CGAL::parameters::sizing_function(1e-3).maximum_number_of_bubbles(100000);
  expect_throw<std::length_error>([&] { CGAL::simplify_outline_2(cdt, np); },
                                  {"maximum_number_of_bubbles = 100000", "sizing function", "about 1.2e+06"});
  const auto fine_between_corners = CGAL::parameters::sizing_function([](const Point& p) {
    return (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1) ? 0.1 : 1e-7;
  });
  expect_throw<std::length_error>([&] { CGAL::simplify_outline_2(cdt, fine_between_corners); },
                                  {"sizing_function", "pieces"});
  expect_throw<std::length_error>(
    [&] { CGAL::simplify_outline_2(cdt, fine_between_corners.maximum_number_of_bubbles(1000)); },
    {"maximum_number_of_bubbles = 1000", "sizing function"});
  const auto fine_at_a_corner =
    CGAL::parameters::sizing_function([](const Point& p) { return 1e-7 + 0.2 * std::hypot(p.x(), p.y()); });
  const Report report = CGAL::simplify_outline_2(cdt, fine_at_a_corner);
  EXPECT_GT(report.number_of_segments, 100u);
  EXPECT_LT(report.number_of_segments, 500u);
}

// A side goes around a corner that is cut off by less than the rounding of coordinates, and is a wall from both ends.
TEST(Simplify_outline, walls_end_in_corners_that_are_cut_off)
{
  for (double way : {1., -1.}) {
    const double l = 0.0009, dx = l * std::cos(1.), dy = l * std::sin(1.);
    const double end = (100 + dx) * way;
    const Outline box{{0, 0}, {100 * way, 0}, {end, dy * way}, {end, 100 * way}, {0, 100 * way}};
    Outline island; // so near that the wall would give way
    for (int k = 0; k < 8; ++k)
      island.emplace_back((50 + 0.8 * std::cos(k * CGAL_PI / 4)) * way, (1.25 + 0.8 * std::sin(k * CGAL_PI / 4)) * way);
    CDT cdt = make({box, island});
    CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1.).relative_outline_tolerance(0.2));
    int on_the_wall = 0;
    for (auto v : cdt.finite_vertex_handles())
      if (v->point().x() * way > 2 && v->point().x() * way < 98 && v->point().y() * way < 0.3) {
        EXPECT_NEAR(v->point().y(), 0, 1e-9);
        ++on_the_wall;
      }
    EXPECT_GT(on_the_wall, 80);
  }
}

TEST(Simplify_outline, gaps_far_too_small)
{
  CDT cdt = make({square(0, 0, 1e6), square(1e-3, 1e5, 1e5)}); // that narrow is the domain beside its left wall
  const auto simplify = [&](double gap) {
    return CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1e5).minimum_gap(gap)).filled_gaps.size();
  };
  expect_throw<std::length_error>([&] { simplify(1e-3); }, {"minimum_gap = 0.001", "about 800000024 parts"});
  EXPECT_EQ(simplify(1e-300), 0u); // nothing is near
  EXPECT_EQ(simplify(1e4), 1u);
}

TEST(Simplify_outline, gaps_far_smaller_than_segments)
{
  const auto filled_gaps = [](CDT cdt, double gap) {
    return CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function(1e5).minimum_gap(gap)).filled_gaps;
  };
  const Outline triangle{{0, 0}, {1e6, 0}, {5e5, 8e5}};
  const auto corners = filled_gaps(make({triangle}), 0.1);
  EXPECT_EQ(corners.size(), 3u); // the rest of the sides is not cut, which would take gigabytes
  for (const auto& gap : corners)
    EXPECT_LT(gap.area, 0.01);
  EXPECT_EQ(filled_gaps(make({square(0, 0, 1e6), square(1e-2, 1e5, 1)}), 0.1).size(), 1u);
}

TEST(Simplify_outline, an_exception_changes_nothing)
{
  CDT cdt = make({coast(0, 0, 10, 900, 1)});
  const Snapshot before = validation::snapshot(cdt);
  const CDT::Vertex_handle v = cdt.finite_vertices_begin();
  const Point p = v->point();
  int calls = 0;
  EXPECT_THROW(CGAL::simplify_outline_2(cdt, CGAL::parameters::sizing_function([&](const Point&) -> double {
                 if (++calls == 500)
                   throw 42;
                 return 1;
               })),
               int);
  EXPECT_TRUE(validation::snapshot(cdt) == before);
  EXPECT_EQ(v->point(), p);
}

} // namespace test_simplify_outline
