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

#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
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

} // namespace test_simplify_outline_work
