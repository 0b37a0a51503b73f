// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What simplify_outline_2() does not work on: constraints outside of the domain. And outlines of a size that would take
// minutes if something took more than about the time that it must.

#include "domains.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Segment_grid_2.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace test_simplify_outline_work {

using namespace domains;
using namespace rough_outlines;
using CGAL::parameters::sizing_function;
using validation::Segment;
using Report = CGAL::Outline_simplification_report_2;

/// a square around the origin
Outline frame(double half_side) { return square(-half_side, -half_side, 2 * half_side); }

std::vector<Segment> pieces_outside(const Report& report, double half_side)
{
  std::vector<Segment> result;
  for (const Report::Piece& p : report.pieces)
    if ((std::max)(std::abs(p.source[0]), std::abs(p.source[1])) > half_side)
      result.push_back(segment(p.source, p.target));
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Simplify_outline_work, constraints_outside_of_the_domain_stay_whole)
{
  const std::vector<Point> seeds{{1, 2}};
  for (double half_side : {100., 1e4, 1e9}) {
    CDT cdt = make({frame(5), frame(half_side)});
    const Report report = CGAL::simplify_outline_2(cdt, sizing_function(1.).seeds(seeds).seeds_are_in_domain(true));
    EXPECT_EQ(report.number_of_old_segments, 4u);
    EXPECT_EQ(report.number_of_segments, 40u);
    EXPECT_EQ(report.share_of_fitting_pieces, 1);
    EXPECT_EQ(report.pieces.size(), 44u);
    const double l = half_side;
    EXPECT_EQ(pieces_outside(report, 5), (std::vector<Segment>{{{-l, -l}, {-l, l}}, {{-l, -l}, {l, -l}},
                                                               {{-l, l}, {l, l}}, {{l, -l}, {l, l}}}));
  }
}

TEST(Simplify_outline_work, sizes_outside_of_the_domain_are_not_asked)
{
  const std::vector<Point> seeds{{1, 2}};
  CDT cdt = make({frame(5), frame(100)});
  insert(cdt, {{5, 5}, {20, 21}}, false); // from a corner of the domain outwards
  const auto none_outside = [](const Point& p) {
    return (std::max)(std::abs(p.x()), std::abs(p.y())) <= 5 ? 1 : std::numeric_limits<double>::quiet_NaN();
  };
  const Report report =
    CGAL::simplify_outline_2(cdt, sizing_function(none_outside).seeds(seeds).seeds_are_in_domain(true));
  EXPECT_EQ(report.number_of_segments, 40u);
  EXPECT_EQ(report.pieces.size(), 45u);
}

/// Without them, pieces would pass where they are.
TEST(Simplify_outline_work, constraints_outside_of_the_domain_are_not_passed)
{
  CDT without = make({frame(9), polygon(0, 0, 3.02, 400)}), cdt(without);
  std::vector<Segment> rods; // in a round hole, near to its shore
  for (int k = 0; k < 12; ++k) {
    const double t = 0.5 * k, c = std::cos(t), s = std::sin(t);
    const Outline rod{{3 * c - 0.2 * s, 3 * s + 0.2 * c}, {3 * c + 0.2 * s, 3 * s - 0.2 * c}};
    insert(cdt, rod, false);
    rods.emplace_back((std::min)(rod[0], rod[1]), (std::max)(rod[0], rod[1]));
  }
  const auto number_of_crossings = [&](const Report& report) {
    const auto line = [](const Segment& s) {
      return K::Segment_2(Point(s.first.first, s.first.second), Point(s.second.first, s.second.second));
    };
    int n = 0;
    for (const Report::Piece& p : report.pieces)
      for (const Segment& rod : rods)
        n += segment(p.source, p.target) != rod && CGAL::do_intersect(line(segment(p.source, p.target)), line(rod));
    return n;
  };
  EXPECT_GT(number_of_crossings(CGAL::simplify_outline_2(without, sizing_function(1.))), 0);
  EXPECT_EQ(number_of_crossings(CGAL::simplify_outline_2(cdt, sizing_function(1.))), 0);
  const std::vector<Segment> after = validation::snapshot(cdt).constraints;
  for (const Segment& rod : rods)
    EXPECT_EQ(std::count(after.begin(), after.end(), rod), 1);
}

TEST(Simplify_outline_work, a_thousand_vertices_in_each_piece)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (double share : {0.1, 0.3, 0.6}) { // of the tolerance
    Outline rough;
    for (int k = 0; k < 12000; ++k) {
      const double t = 2 * CGAL_PI * k / 12000, r = 1 + 0.06 * share * noise(random);
      rough.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    CDT cdt = make({rough});
    const Report report = CGAL::simplify_outline_2(cdt, sizing_function(0.4).outline_tolerance(0.06));
    EXPECT_LE(report.largest_share_of_tolerance, 1);
    EXPECT_EQ(report.share_of_fitting_pieces, 1);
    EXPECT_NEAR(static_cast<double>(report.number_of_segments), 2 * CGAL_PI / 0.4, 2);
  }
}

using CGAL::Bubble_relaxation_2::internal::Index;
using CGAL::Bubble_relaxation_2::internal::Segment_grid_2;

/// slanted lines beside each other
struct Lines
{
  static constexpr int n = 2000;
  static constexpr double length = 300;

  Segment_grid_2 grid;

  Lines()
  {
    for (int k = 0; k < n; ++k)
      grid.insert(source(k), target(k), 0.5);
  }

  static Point source(int k) { return Point(0.3 * k, 0); }
  static Point target(int k) { return Point(0.3 * k + 0.7 * length, 0.7 * length); }

  template <class... Query>
  std::set<Index> near(const Query&... query) const
  {
    std::set<Index> result;
    grid.for_each_near(query..., [&](Index k) { EXPECT_TRUE(result.insert(k).second); });
    return result;
  }
};

TEST(Simplify_outline_work, few_of_many_long_segments_are_near_to_a_box)
{
  Lines lines;
  for (double x : {150., 217.3, 400.}) {
    const CGAL::Bbox_2 box(x, 80, x + 2, 82);
    std::set<Index> wanted;
    for (int k = 0; k < Lines::n; ++k)
      if (CGAL::do_intersect(K::Segment_2(Lines::source(k), Lines::target(k)), K::Iso_rectangle_2(box)))
        wanted.insert(k);
    const std::set<Index> found = lines.near(box);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
    EXPECT_GT(wanted.size(), 10u);
    EXPECT_LT(found.size(), 8 * wanted.size()); // boxes of 700 lines meet it
    lines.grid.remove(*wanted.begin());
    EXPECT_EQ(lines.near(box).size(), found.size() - 1);
    lines.grid.put_back(*wanted.begin());
    EXPECT_EQ(lines.near(box), found);
  }
}

TEST(Simplify_outline_work, few_of_many_long_segments_are_near_to_a_long_one)
{
  const Lines lines;
  constexpr int line = 1000;
  constexpr double reach = 1.5;
  const Point a = Lines::source(line), b = Lines::target(line);
  const CGAL::Bbox_2 box = a.bbox() + b.bbox();
  const CGAL::Bbox_2 around(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach);
  std::set<Index> wanted;
  for (int k = 0; k < Lines::n; ++k)
    if (CGAL::squared_distance(K::Segment_2(a, b), K::Segment_2(Lines::source(k), Lines::target(k))) <= reach * reach)
      wanted.insert(k);
  const std::set<Index> found = lines.near(a, b, reach, around);
  EXPECT_TRUE(std::includes(found.begin(), found.end(), wanted.begin(), wanted.end()));
  EXPECT_LT(found.size(), 20 * wanted.size());
  EXPECT_GT(lines.near(around).size(), 1000u);
}

/// Pieces of long lines that have company, each of which was tested with all in the box of what is left of the line.
TEST(Simplify_outline_work, long_slanted_channels)
{
  Outline comb{{50, -1}, {0, -1}};
  for (int k = 0; k < 50; ++k)
    comb.insert(comb.end(), {{k, 0.3 * k}, {k + 35, 150 + 0.3 * k}, {k + 35.3, 150 + 0.3 * k}, {k + 0.3, 0.3 * k}});
  CDT cdt = make({comb});
  const Report report = CGAL::simplify_outline_2(cdt, sizing_function(1.));
  EXPECT_GT(report.share_of_fitting_pieces, 0.99);
  EXPECT_LE(report.hausdorff_distance, 0.1);
  EXPECT_NEAR(static_cast<double>(report.number_of_segments), 100 * std::hypot(35, 150) + 105, 300);
}

} // namespace test_simplify_outline_work
