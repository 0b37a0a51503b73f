// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A bay with an island, meshed for several solvers: names of boundaries for Gmsh, depths and an open boundary for
// ADCIRC and SCHISM, node strings for SMS, and all that there is for ParaView.

#include <CGAL/Bubble_relaxation_2/IO/2DM.h>
#include <CGAL/Bubble_relaxation_2/IO/ADCIRC.h>
#include <CGAL/Bubble_relaxation_2/IO/MSH.h>
#include <CGAL/Bubble_relaxation_2/IO/VTU.h>
#include <CGAL/Bubble_relaxation_2/IO/triangle.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Face_base = CGAL::Delaunay_mesh_face_base_2<Kernel>; // which is marked, and so tells what is written
using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, Face_base>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Tds>;
namespace params = CGAL::Bubble_relaxation_parameters; // setters in any order

int main()
{
  constexpr int coast = 1, sea = 2, island = 3;
  CDT cdt;
  CGAL::Constraint_marker_map_2<CDT> markers;
  const std::vector<Point> shore{{0, 0}, {4000, 0}, {4000, 3000}, {1500, 3500}, {0, 2000}},
    rock{{1500, 1200}, {2200, 1300}, {1900, 1900}};
  for (const auto& ring : {shore, rock})
    cdt.insert_constraint(ring.begin(), ring.end(), true);
  const auto mark = [&](const std::vector<Point>& ring, const std::vector<int>& sides) {
    for (std::size_t k = 0; k < ring.size(); ++k)
      markers.set(cdt, cdt.insert(ring[k]), cdt.insert(ring[(k + 1) % ring.size()]), sides[k]);
  };
  mark(shore, {coast, sea, coast, coast, coast}); // when all constraints are in, which may cut each other
  mark(rock, {island, island, island});

  const auto depth = [](const Point& p) { return 2 + p.x() / 100; }; // in metres
  const auto d = [&](const Point& p) { return 30 * std::sqrt(depth(p)); };
  CGAL::npbs_relax(cdt, params::sizing_function(d).edge_marker_map(markers));

  std::vector<CDT::Vertex_handle> vertices; // in the order of the points: for values that are known by vertices
  CGAL::Mesh_arrays_2 mesh(cdt, params::edge_marker_map(markers).output_iterator(std::back_inserter(vertices)));
  mesh.marker_names = {{coast, "coast"}, {sea, "open sea"}, {island, "island"}};
  for (CDT::Vertex_handle v : vertices)
    mesh.vertex_data["depth"].push_back(depth(v->point()));

  CGAL::IO::write_VTU("bay.vtu", mesh);
  CGAL::IO::write_MSH("bay.msh", mesh);
  CGAL::IO::write_2DM("bay.2dm", mesh);
  CGAL::IO::write_ADCIRC("fort.14", mesh, {sea});
  CGAL::IO::write_triangle_files("bay.node", mesh);
  CGAL::IO::write_MSH2("bay_without_tags.msh", cdt); // a triangulation alone will do
  std::cout << mesh.points.size() << " points and " << mesh.triangles.size() << " triangles in five formats\n";
}
