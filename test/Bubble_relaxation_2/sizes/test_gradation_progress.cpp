// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// How often a field with a limited gradient tells what is done of it.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gradation_limited_sizing_field_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace test_gradation_progress {

namespace P = CGAL::parameters;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Field = CGAL::Gradation_limited_sizing_field_2<CDT>;

CDT square()
{
  CDT cdt;
  const std::vector<Point> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(corners.begin(), corners.end(), true);
  return cdt;
}

double rough(const Point& p) { return 1e-4 + 0.2 * std::abs(std::sin(20 * p.x()) * std::cos(17 * p.y())); }

/// it takes a millisecond or more
double slow(const Point& p)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return rough(p);
}

TEST(Gradation_progress, ends_with_1_also_where_there_was_no_room)
{
  std::vector<double> told;
  const Field h(square(), 0.2, P::sizing_function(rough).maximum_number_of_vertices(500).callback([&](double share) {
    told.push_back(share);
    return true;
  }));
  EXPECT_FALSE(h.is_resolved());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  ASSERT_GT(told.size(), 1u);
  EXPECT_EQ(told.back(), 1);
  EXPECT_LT(told[told.size() - 2], 1);
}

TEST(Gradation_progress, does_not_wait_for_slow_sizes)
{
  int asked = 0, most = 0; // sizes between two calls
  const auto d = [&](const Point& p) {
    most = (std::max)(most, ++asked);
    return slow(p);
  };
  const Field h(square(), 0.2, P::sizing_function(d).maximum_number_of_vertices(500).callback([&](double) {
    asked = 0;
    return true;
  }));
  EXPECT_LE(most, 50); // 25 milliseconds are a reason to call
  EXPECT_GT(h.number_of_vertices(), 400u);
}

TEST(Gradation_progress, stops_within_a_turn)
{
  for (int last : {1, 3, 10}) {
    int calls = 0, asked = 0, asked_until_stop = 0;
    const auto d = [&](const Point& p) {
      ++asked;
      return slow(p);
    };
    const Field h(square(), 0.2, P::sizing_function(d).callback([&](double share) {
      EXPECT_LT(share, 1);
      asked_until_stop = asked;
      return ++calls < last;
    }));
    EXPECT_EQ(calls, last);
    EXPECT_FALSE(h.is_resolved());
    EXPECT_LE(asked, asked_until_stop + int(h.number_of_vertices())); // it needs all sizes of its vertices
    for (double x = 0.01; x < 1; x += 0.03)
      for (double y = 0.01; y < 1; y += 0.03)
        EXPECT_LE(std::abs(h(Point(x + 0.001, y)) - h(Point(x, y))), 0.001 * 0.2 * (1 + 1e-6)) << x << ' ' << y;
  }
}

} // namespace test_gradation_progress
