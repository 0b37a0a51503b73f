// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Triangulations whose points are located by a hierarchy of coarser ones: the upper levels know no vertex that has gone.

#include "adaptation_checks.h"
#include "domains.h"
#include "validation.h"

#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/Triangulation_hierarchy_vertex_base_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_hierarchy {

using domains::K;
using domains::Point;
using Vertex_base = CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<K>>;
using Levels = CGAL::Triangulation_hierarchy_2<CGAL::Constrained_Delaunay_triangulation_2<
  K, CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Delaunay_mesh_face_base_2<K>>, CGAL::Exact_predicates_tag>>;

template <class Cdt>
class Hierarchy : public testing::Test
{
protected:
  Cdt cdt = domains::mesh<Cdt>({domains::slanted, domains::hole}, 0.015);

  /// every level is read, also to remove vertices
  void expect_sound()
  {
    validation::expect_valid_mesh(cdt);
    ASSERT_TRUE(cdt.is_valid());
    for (double x = 0.15; x < 0.9; x += 0.03)
      for (double y = 0.2; y < 0.85; y += 0.03)
        EXPECT_NE(cdt.triangle(cdt.locate(Point(x, y))).bounded_side(Point(x, y)), CGAL::ON_UNBOUNDED_SIDE);
  }
};

using Kinds = testing::Types<Levels, CGAL::Constrained_triangulation_plus_2<Levels>>;

TYPED_TEST_SUITE(Hierarchy, Kinds);

TYPED_TEST(Hierarchy, forgets_what_local_changes_remove)
{
  TypeParam& cdt = this->cdt;
  const std::size_t fine = cdt.number_of_vertices();
  for (double x : {0.2, 0.5, 0.8}) {
    const auto d = [x](const Point& p) { return (std::min)(0.06, 0.015 + 0.2 * std::hypot(p.x() - x, p.y() - 0.3)); };
    CGAL::npbs_adapt(cdt, adaptation::size(d));
    this->expect_sound();
  }
  EXPECT_LT(2 * cdt.number_of_vertices(), fine);
  std::vector<typename TypeParam::Vertex_handle> inside;
  for (typename TypeParam::Vertex_handle v : cdt.finite_vertex_handles())
    if (!cdt.are_there_incident_constraints(v))
      inside.push_back(v);
  for (std::size_t k = 0; k < inside.size(); k += 2)
    cdt.remove(inside[k]);
  EXPECT_TRUE(cdt.is_valid());
}

TYPED_TEST(Hierarchy, comes_back_after_a_stop)
{
  TypeParam& cdt = this->cdt;
  const validation::Snapshot before = validation::snapshot(cdt);
  CGAL::npbs_relax(cdt, adaptation::size(0.03).restore_when_stopped(true).callback([](double x) { return x < 1; }));
  EXPECT_TRUE(validation::snapshot(cdt) == before);
  this->expect_sound();
  CGAL::npbs_relax(cdt, adaptation::size(0.03));
  this->expect_sound();
}

} // namespace test_hierarchy
