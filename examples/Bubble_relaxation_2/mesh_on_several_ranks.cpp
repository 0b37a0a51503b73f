// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A square with a round hole, meshed by all ranks of MPI together, each its part of the domain and of the mesh:
//
//   mpirun -n 4 mesh_on_several_ranks
//
// Each rank writes a file with its triangles, and square_with_hole.pvtu names them all for ParaView: with markers of
// the boundary, and a function at the points.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <mpi.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);

  // all ranks have the domain, and the same d
  std::vector<Point> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, hole;
  for (int i = 0; i < 50; ++i)
    hole.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / 50), 0.5 * std::sin(2 * CGAL_PI * i / 50)));
  CDT cdt;
  CGAL::Constraint_marker_map_2<CDT> markers; // 1: the outer boundary, 2: the hole
  for (const auto* outline : {&square, &hole})
    for (std::size_t k = 0; k < outline->size(); ++k) {
      const auto u = cdt.insert((*outline)[k]), v = cdt.insert((*outline)[(k + 1) % outline->size()]);
      cdt.insert_constraint(u, v);
      markers.set(u, v, outline == &square ? 1 : 2);
    }
  const auto d = [](const Point& p) { return std::hypot(p.x(), p.y()) / 8; };

  CGAL::Point_set_3<Point, K::Vector_2> points; // gets those of this rank
  const auto np = CGAL::Bubble_relaxation_parameters::sizing_function(d).edge_marker_map(markers);
  const auto result = CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, np);
  const auto r = [&](std::size_t i) { return std::hypot(result.mesh.point(i).x(), result.mesh.point(i).y()); };
  result.mesh.write_pvtu("square_with_hole.pvtu", {{"r", r}});

  if (result.mesh.rank() == 0)
    std::cout << result.report // of all ranks
              << "the first rank has " << points.size() << " of these vertices\n";
  MPI_Finalize();
}
