// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Calls by several ranks that cannot work, as those in mistakes.cpp.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Distributed/npbs_relax.h>
#include <CGAL/Distributed/triangulate.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Projection_traits_xy_3.h>

#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Points = CGAL::Point_set_3<K::Point_2, K::Vector_2>;
namespace P = CGAL::parameters;

void right(Points& points, const CDT& cdt)
{
  CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, 0.1);
  CGAL::Distributed::npbs_mesh(points, cdt, MPI_COMM_WORLD, [](const K::Point_2& p) { return 0.1 + p.x(); });
  CGAL::Distributed::triangulate(points, cdt, MPI_COMM_WORLD);
  CGAL::Distributed::triangulate(points, cdt, MPI_COMM_WORLD, 0.1);
}

#if MISTAKES
void wrong(Points& points, const CDT& cdt)
{
  const CGAL::Constrained_Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<K>> terrain;
  const CGAL::Delaunay_triangulation_2<K> unconstrained;
#if MISTAKES == 1
  // wrong: it takes no terrain
  CGAL::Distributed::npbs_relax(points, terrain, MPI_COMM_WORLD);
  // wrong: what has no constraints has no domain
  CGAL::Distributed::npbs_relax(points, unconstrained, MPI_COMM_WORLD, 0.1);
  // wrong: return a bool
  CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, P::sizing_function(0.1).callback([](double) {}));
  // wrong: seeds must be a range
  CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, P::seeds(K::Point_2(0, 0)).sizing_function(0.1));
  // wrong: must return a number
  CGAL::Distributed::npbs_relax(points, cdt, MPI_COMM_WORLD, [](const K::Point_2&) { return std::string("fine"); });
#elif MISTAKES == 2
  // wrong: it takes no terrain
  CGAL::Distributed::triangulate(points, terrain, MPI_COMM_WORLD);
  // wrong: what has no constraints has no domain
  CGAL::Distributed::triangulate(points, unconstrained, MPI_COMM_WORLD);
  // wrong: seeds must be a range
  CGAL::Distributed::triangulate(points, cdt, MPI_COMM_WORLD, P::seeds(K::Point_2(0, 0)));
  // wrong: must return a number
  CGAL::Distributed::triangulate(points, cdt, MPI_COMM_WORLD, [](const K::Point_2&) { return std::string("fine"); });
#elif MISTAKES == 3
  // wrong: it takes no terrain
  CGAL::Distributed::npbs_mesh(points, terrain, MPI_COMM_WORLD);
  // wrong: what has no constraints has no domain
  CGAL::Distributed::npbs_mesh(points, unconstrained, MPI_COMM_WORLD, 0.1);
#endif
}
#endif
