// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Vertices that stay where they are: one inside, one that splits a slanted edge of the boundary.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/insert_on_constraint_2.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <iostream>
#include <set>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Vertex_handle = CDT::Vertex_handle;

int main()
{
  CDT cdt;
  const std::vector<Point> outline{{0, 0}, {1, 0.1}, {1, 1}, {0, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);

  std::set<Vertex_handle> pinned;
  pinned.insert(cdt.insert(Point(0.37, 0.41))); // a sensor
  // where a load begins: on the edge but for a rounding, so it must not be inserted like the sensor
  pinned.insert(CGAL::insert_on_constraint_2(cdt, Point(1. / 3, 0.1 / 3)));

  // the map refers to the set, which has to live as long
  const CGAL::Boolean_property_map<std::set<Vertex_handle>> is_pinned(pinned);
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.1).vertex_is_constrained_map(is_pinned));

  for (Vertex_handle v : pinned) // their handles stay valid
    std::cout << v->point() << " has " << cdt.degree(v) << " neighbours\n";
}
