// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Parts of meshes at borders of the domain beyond which triangles are flat up to roundings.

#include "adaptation_checks.h"
#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_adapt_slivers {

using adaptation::size;
using domains::CDT;
using domains::Outline;
using domains::polygon;
using validation::Xy;

/// Inserts vertices on the edges of an outline, which lie beside them by a rounding. Returns those outside.
std::set<Xy> insert_on_edges(CDT& cdt, const Outline& o, int parts)
{
  std::set<Xy> outside;
  for (std::size_t i = 0; i < o.size(); ++i)
    for (int k = 1; k < parts; ++k) {
      const double s = double(k) / parts;
      const auto &[x, y] = o[i];
      const CDT::Point p(x, y), q(o[(i + 1) % o.size()].first, o[(i + 1) % o.size()].second);
      const CDT::Vertex_handle v = cdt.insert(CDT::Point(x + s * (q.x() - x), y + s * (q.y() - y)));
      if (CGAL::orientation(p, q, v->point()) == CGAL::RIGHT_TURN)
        outside.insert(validation::xy(v));
    }
  return outside;
}

TEST(Adapt_slivers, vertices_beside_the_outline_by_a_rounding_stay)
{
  std::size_t number_outside = 0;
  for (int parts : {2, 3})
    for (int k = 0; k < 4; ++k) {
      SCOPED_TRACE(k);
      const Outline o = polygon(0, 0, 1, 12, 0.2 * k);
      CDT cdt = domains::make({o});
      const std::set<Xy> outside = insert_on_edges(cdt, o, parts);
      number_outside += outside.size();
      const validation::Snapshot before = validation::snapshot(domains::make({o}));
      for (double d : {0.1, 0.4, 0.15}) {
        const auto report = d == 0.1 ? CGAL::npbs_relax(cdt, size(d)) : CGAL::npbs_adapt(cdt, size(d));
        validation::expect_mesh_of(before, cdt, outside);
        validation::expect_vertices_kept(outside, validation::snapshot(cdt));
        EXPECT_NEAR(validation::domain_area(cdt), domains::area(o), 1e-12);
        EXPECT_GT(report.quality.minimum_quality(), 0.7);
      }
    }
  EXPECT_GT(number_outside, 20u);
}

/// There are slivers all around vertices beyond the border then, which were opened without end.
TEST(Adapt_slivers, outlines_in_outlines_down_to_roundings)
{
  const double x = 0.35486061957442, y = 0.10228123970337;
  std::vector<Outline> outlines{polygon(0, 0, 1, 29), polygon(x, y, 0.15, 4)};
  const std::vector<std::pair<double, int>> rings{{0.00517, 5}, {2.5e-5, 6}, {4.4e-6, 10}, {1.2e-8, 10}, {5.2e-11, 3},
                                                  {7.4e-12, 4}, {1.34e-12, 7}, {1.62e-14, 7}, {5.6e-15, 6}};
  for (const auto& [radius, n] : rings)
    outlines.push_back(polygon(x, y, radius, n));
  CDT cdt = domains::make(outlines);
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto cone = [](const CDT::Point& p) { return 0.738 + 3.2357 * std::hypot(p.x() - 0.532, p.y() - 0.0275); };
  CGAL::npbs_relax(cdt, size(cone));
  const double area = validation::domain_area(cdt);
  CGAL::npbs_adapt(cdt, size(1e80));
  validation::expect_mesh_of(before, cdt);
  EXPECT_NEAR(validation::domain_area(cdt), area, 1e-12);
}

TEST(Adapt_slivers, edges_too_short_are_told)
{
  CDT cdt = domains::make({Outline{{0, 0}, {9.9e-324, 1.5e-323}, {1, 0}, {1, 1}, {0, 1}}});
  for (CDT::Face_handle f : cdt.finite_face_handles())
    f->set_in_domain(true);
  const validation::Content<CDT> before(cdt);
  expect_invalid([&] { CGAL::npbs_adapt(cdt, size(0.2)); }, {"is too short"});
  EXPECT_TRUE(validation::Content<CDT>(cdt) == before);
}

} // namespace test_adapt_slivers
