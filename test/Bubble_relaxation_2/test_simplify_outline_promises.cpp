// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What is promised of simplified outlines where rules, pins, constraints within and hierarchies of them meet, and when
// they cannot be written.

#include "domains.h"
#include "expect_throw.h"
#include "random_seeds.h"
#include "rough_outlines.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/simplify_outline_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace {

using namespace domains;
using namespace rough_outlines;
using CGAL::parameters::sizing_function;
using validation::Segment;
using validation::Snapshot;
using validation::Xy;
using Ctp = CGAL::Constrained_triangulation_plus_2<CDT>;
using Report = CGAL::Outline_simplification_report_2;

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
  CGAL::Polygon_2<K> polygon;
  for (const auto& p : shore)
    polygon.push_back(Point(p.first, p.second));
  int tried = 0;
  for (const Xy& p : wanted.vertices) {
    const Outline island{p, {p.first + 1e-4, p.second}, {p.first, p.second + 1e-4}};
    if (!std::all_of(island.begin(), island.end(),
                     [&](const Xy& q) { return polygon.has_on_bounded_side(Point(q.first, q.second)); }))
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
    std::vector<Point> points;
    for (const auto& p : o)
      points.emplace_back(p.first, p.second);
    Ctp cdt;
    const auto id = cdt.insert_constraint(points.begin(), points.end(), true);
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
  const std::vector<Point> triangle{{0, 0}, {10, 0}, {5, 9}, {0, 0}, {10, 0}};
  Ctp cdt;
  const auto id = cdt.insert_constraint(triangle.begin(), triangle.end());
  CGAL::simplify_outline_2(cdt, sizing_function(1.));
  const auto segments = segments_of(cdt, id);
  EXPECT_EQ(std::set<Segment>(segments.begin(), segments.end()).size() + 10, segments.size());
}

} // namespace
