// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A plate of two materials, with a number for each boundary condition: edges and triangles of the mesh have them
// too, and each material its own size. The marker changes in the middle of the bottom, where a vertex stays.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/Region_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iostream>
#include <utility>
#include <map>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Vertex_handle = CDT::Vertex_handle;
namespace params = CGAL::Bubble_relaxation_parameters; // setters in any order

enum Material { STEEL = 1, GLASS = 2 };
enum Boundary { NONE, FIXED, LOADED };

int main()
{
  CDT cdt;
  CGAL::Constraint_marker_map_2<CDT, Boundary> markers;
  const Vertex_handle a = cdt.insert(Point(0, 0)), b = cdt.insert(Point(0.3, 0)), c = cdt.insert(Point(1, 0)),
                      d = cdt.insert(Point(1, 1)), e = cdt.insert(Point(0, 1));
  for (const auto& [u, v] : {std::pair(a, c), {c, d}, {d, e}, {e, a}, {b, d}}) // the last one parts the materials
    cdt.insert_constraint(u, v);
  markers.set(cdt, a, b, FIXED); // when all constraints are in: b cuts the one from a to c
  markers.set(cdt, d, e, LOADED);

  CGAL::Face_region_map_2<CDT, Material> materials;
  materials.set_all_around(cdt.locate(Point(0.1, 0.5)), STEEL);
  materials.set_all_around(cdt.locate(Point(0.9, 0.5)), GLASS);

  const CGAL::Region_sizing_field_2<CDT> size(cdt, materials, [](Material m) { return m == GLASS ? 0.02 : 0.1; });
  const CGAL::Gradation_limited_sizing_field_2<CDT> graded(cdt, 0.2, params::sizing_function(size));
  const auto report =
    CGAL::npbs_relax(cdt, params::sizing_function(graded).edge_marker_map(markers).face_region_map(materials));

  std::map<Boundary, double> length;
  for (const CDT::Edge& edge : cdt.constrained_edges()) {
    const Vertex_handle u = edge.first->vertex(CDT::ccw(edge.second)), v = edge.first->vertex(CDT::cw(edge.second));
    length[markers(u, v)] += std::sqrt(CGAL::squared_distance(u->point(), v->point()));
  }
  std::map<Material, double> area;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    area[materials(f)] += cdt.triangle(f).area();
  std::cout << "fixed: " << length[FIXED] << ", loaded: " << length[LOADED] << "\nsteel: " << area[STEEL]
            << ", glass: " << area[GLASS] << '\n'
            << report.quality;
}
