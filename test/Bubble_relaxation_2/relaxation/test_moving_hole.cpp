// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A hole of a mesh that moves: its constraints are taken out and put in elsewhere, and only what does not fit then is
// meshed anew.

#include "../../../demo/Bubble_relaxation_2/moving_hole.h"
#include "domains.h"
#include "validation.h"

#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace test_moving_hole {

using domains::CDT;
using domains::Point;

constexpr double radius = 0.12, fine = 0.03, coarse = 0.06;

std::vector<Point> circle(double x, double y)
{
  constexpr int n = 25;
  std::vector<Point> result;
  for (int i = 0; i < n; ++i)
    result.push_back(Point(x + radius * std::cos(2 * CGAL_PI * i / n), y + radius * std::sin(2 * CGAL_PI * i / n)));
  return result;
}

struct Sizes
{
  double x, y;

  double operator()(const Point& p) const
  {
    return (std::min)(coarse, fine + 0.2 * (std::max)(0., std::hypot(p.x() - x, p.y() - y) - radius));
  }
};

TEST(Moving_hole, leaves_good_meshes_and_what_is_far_as_it_was)
{
  Sizes d{0.3, 0.5};
  CDT cdt = domains::make({{{0, 0}, {2, 0}, {2, 1}, {0, 1}}});
  const std::vector<Point> start = circle(d.x, d.y);
  cdt.insert_constraint(start.begin(), start.end(), true);
  const auto np = CGAL::parameters::sizing_function(std::cref(d)).misfit_quality(0.85);
  CGAL::npbs_relax(cdt, np);
  const double area = validation::domain_area(cdt);
  Moving_hole<CDT> hole(cdt, start);
  std::set<CDT::Vertex_handle> removed;
  hole.on_removal = [&](CDT::Vertex_handle v) { EXPECT_TRUE(removed.insert(v).second); };
  std::size_t changed = 0, all = 0;
  for (int step = 1; step <= 40; ++step) {
    SCOPED_TRACE(step);
    std::map<CDT::Vertex_handle, Point> before;
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
      before[v] = v->point();
    d.x += 0.035;
    d.y = 0.5 + 0.25 * std::sin(0.3 * step);
    removed.clear();
    hole.move(circle(d.x, d.y), 0.8 * fine);
    EXPECT_GT(removed.size(), 0u);
    EXPECT_TRUE(cdt.is_valid());
    EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
    CGAL::npbs_adapt(cdt, np);
    validation::expect_valid_mesh(cdt);
    EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
    EXPECT_EQ(hole.vertices().size(), start.size());
    const auto quality = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(std::cref(d)));
    EXPECT_GE(quality.minimum_quality(), 0.8);
    EXPECT_NEAR(quality.mean_length_ratio(), 1, 0.03);
    for (CDT::Vertex_handle v : cdt.finite_vertex_handles()) {
      const auto found = before.find(v);
      const bool is_kept = found != before.end() && found->second == v->point();
      changed += !is_kept;
      if (std::hypot(v->point().x() - d.x, v->point().y() - d.y) > 0.75) {
        EXPECT_TRUE(is_kept);
      }
    }
    all += cdt.number_of_vertices();
  }
  EXPECT_LT(double(changed), 0.4 * double(all));
}

} // namespace test_moving_hole
