// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What else takes a terrain: fields of sizes, criteria of refinement, transfers. All see its projection.

#include "domains.h"

#include <CGAL/Bubble_mesh_criteria_2.h>
#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/Projection_traits_yz_3.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/transfer_2.h>

#include <gtest/gtest.h>

#include <boost/property_map/property_map.hpp>

#include <map>

namespace test_terrain_fields {

namespace P = CGAL::parameters;

using domains::K;
using Traits = CGAL::Projection_traits_yz_3<K>; // places are (y, z), elevations are x
using Terrain = domains::Cdt_of<Traits>;

/// a square on a slope; its mesh if `d` is positive
Terrain square(double d = 0)
{
  Terrain terrain;
  const Terrain::Point corners[] = {{5, 0, 0}, {6, 1, 0}, {8, 1, 1}, {7, 0, 1}};
  for (int i = 0; i < 4; ++i)
    terrain.insert_constraint(corners[i], corners[(i + 1) % 4]);
  if (d > 0)
    CGAL::npbs_relax(terrain, d);
  return terrain;
}

TEST(Terrain_fields, gradation)
{
  Terrain terrain = square();
  const auto jump = [](const K::Point_2& p) { return p.x() < 0.5 ? 0.03 : 0.3; };
  const CGAL::Gradation_limited_sizing_field_2<Terrain> d(terrain, 0.2, P::sizing_function(jump));
  EXPECT_NEAR(d({0.9, 0.5}), 0.03 + 0.4 * 0.2, 0.012);
  EXPECT_GT(CGAL::npbs_relax(terrain, d).number_of_vertices, 600u);
}

TEST(Terrain_fields, criteria)
{
  const Terrain terrain = square();
  const auto d = [](const K::Point_2& p) { return p.x() + p.y() < 1 ? 0.1 : 10; };
  using Criteria = CGAL::Bubble_mesh_criteria_2<Terrain, decltype(d)>;
  int large = 0;
  for (Terrain::Face_handle f : terrain.finite_face_handles()) {
    Criteria::Quality q;
    large += Criteria(d).is_bad_object()(f, q) == CGAL::Mesh_2::IMPERATIVELY_BAD;
  }
  EXPECT_GE(large, 1);
}

TEST(Terrain_fields, transfer)
{
  const Terrain from = square(0.1), to = square(0.07);
  std::map<Terrain::Vertex_handle, double> given, result;
  for (Terrain::Vertex_handle v : from.finite_vertex_handles())
    given[v] = v->point().y() - 2 * v->point().z();
  auto map = boost::make_assoc_property_map(result);
  CGAL::transfer_vertex_values_2(from, boost::make_assoc_property_map(given), to, map);
  for (Terrain::Vertex_handle v : to.finite_vertex_handles())
    EXPECT_NEAR(result[v], v->point().y() - 2 * v->point().z(), 1e-14);
}

} // namespace test_terrain_fields
