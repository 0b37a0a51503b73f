// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The elevation of a surface beyond the hull of its points, and where there is no place.

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolated_elevation_2.h>
#include <CGAL/Projection_traits_xy_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_interpolated_elevation {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Terrain = CGAL::Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<K>>;

TEST(Interpolated_elevation, beyond_the_hull_is_that_of_its_nearest_point)
{
  const int n = 12;
  Terrain terrain, turned; // the same, inserted in another order
  std::vector<K::Point_2> corners;
  for (int i = 0; i < n; ++i)
    corners.emplace_back(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n));
  const auto elevation = [&](int i) { return corners[i].x() + 3 * corners[i].y(); };
  for (int i = 0; i < n; ++i) {
    const int k = (7 * i + 5) % n;
    terrain.insert(Terrain::Point(corners[i].x(), corners[i].y(), elevation(i)));
    turned.insert(Terrain::Point(corners[k].x(), corners[k].y(), elevation(k)));
  }
  const CGAL::Interpolated_elevation_2<Terrain> z(terrain), z_turned(turned);
  for (double x : {-5., -1.1, -0.3, 0., 0.7, 5., 1e6})
    for (double y : {-3., -1.2, 1.3, 5., 1e6}) {
      const K::Point_2 q(x, y);
      double least = 1e300, expected = 0;
      for (int i = 0; i < n; ++i) {
        const K::Point_2 &a = corners[i], &b = corners[(i + 1) % n];
        const double s = (std::max)(0., (std::min)(1., (q - a) * (b - a) / CGAL::squared_distance(a, b)));
        const K::Point_2 p = a + s * (b - a);
        if (CGAL::squared_distance(p, q) < least) {
          least = CGAL::squared_distance(p, q);
          expected = p.x() + 3 * p.y();
        }
      }
      EXPECT_NEAR(z(q), expected, 1e-9) << q;
      for (double former = 0; former < 6; ++former) { // what was asked before
        z(K::Point_2(0.9 * std::cos(former), 0.9 * std::sin(former)));
        const double value = z(q);
        EXPECT_EQ(value, z_turned(q)) << q;
      }
    }
}

TEST(Interpolated_elevation, has_no_number_where_there_is_no_place)
{
  Terrain terrain;
  for (const auto& p : {Terrain::Point(0, 0, 1), Terrain::Point(2, 0, 3), Terrain::Point(0, 2, 5)})
    terrain.insert(p);
  const CGAL::Interpolated_elevation_2<Terrain> z(terrain);
  for (double bad : {std::nan(""), double(INFINITY), -double(INFINITY)}) {
    EXPECT_TRUE(std::isnan(z({bad, 0})));
    EXPECT_TRUE(std::isnan(z({0.5, bad})));
  }
  for (double far : {1e100, 1e200, 1.7e308}) {
    EXPECT_EQ(z({far, -far}), 3);
    EXPECT_EQ(z({-far, -far}), 1);
  }
}

} // namespace test_interpolated_elevation
