// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The package's names do not clash with those of Mesh_2 and Mesh_3, whichever comes first.

#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/lloyd_optimize_mesh_2.h>
#include <CGAL/Mesh_criteria_3.h>

#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

TEST(Include_order, package_last)
{
  const auto np = CGAL::parameters::mass(2.).number_of_iterations(3);
  EXPECT_EQ(CGAL::parameters::get_parameter(np, CGAL::internal_np::mass), 2);
  const auto meshless = CGAL::parameters::support_factor(2.).number_of_gauss_points(3).grid_cells(12, 12);
  EXPECT_EQ(CGAL::parameters::get_parameter(meshless, CGAL::internal_np::support_factor), 2);
}
