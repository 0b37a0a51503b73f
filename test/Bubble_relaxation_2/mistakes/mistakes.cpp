// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Calls that cannot work. `check_mistakes.cmake` compiles each alone, as the mistake with this number, and counts what
// the compiler says.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <string>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Terrain = CGAL::Constrained_Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<K>>;
namespace P = CGAL::parameters;

int main()
{
  CDT cdt;
  Terrain terrain;
#if MISTAKE == 0 // none
  CGAL::npbs_relax(cdt);
  CGAL::simplify_outline_2(cdt, 0.1);
  CGAL::npbs_relax(cdt, 0.1);
  CGAL::npbs_relax(cdt, [](const K::Point_2& p) { return 0.1 + p.x(); });
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).callback([](double) { return true; }));
  CGAL::npbs_relax(terrain, [](const K::Point_2& p) { return 0.1 + p.x(); });
  CGAL::npbs_relax(terrain, P::elevation_function([](const K::Point_2&) { return 1; }));
  CGAL::npbs_relax(terrain, P::edge_marker_map(CGAL::Constraint_marker_map_2<Terrain>()));
#elif MISTAKE == 1 // what has no constraints has no domain
  CGAL::Delaunay_triangulation_2<K> unconstrained;
  CGAL::npbs_relax(unconstrained);
#elif MISTAKE == 2 // cannot be const
  const CDT fixed = cdt;
  CGAL::npbs_relax(fixed, 0.1);
#elif MISTAKE == 3 // points in the plane
  CGAL::Constrained_Delaunay_triangulation_2<CGAL::Projection_traits_3<K>> slanted(
    CGAL::Projection_traits_3<K>(K::Vector_3(1, 1, 1)));
  CGAL::npbs_relax(slanted);
#elif MISTAKE == 4 // return a bool
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).callback([](double) {}));
#elif MISTAKE == 5 // Parallel_tag needs a program linked with TBB
  CGAL::npbs_relax(cdt, P::number_of_rounds(2).concurrency_tag(CGAL::Parallel_tag()));
#elif MISTAKE == 6 // seeds must be a range
  CGAL::npbs_relax(cdt, P::seeds(K::Point_2(0, 0)));
#elif MISTAKE == 12 // what has no constraints has no domain
  CGAL::Delaunay_triangulation_2<K> unconstrained;
  CGAL::simplify_outline_2(unconstrained, 0.1);
#elif MISTAKE == 13 // cannot be const
  const CDT fixed = cdt;
  CGAL::simplify_outline_2(fixed, 0.1);
#elif MISTAKE == 14 // seeds must be a range
  CGAL::simplify_outline_2(cdt, P::seeds(K::Point_2(0, 0)).sizing_function(0.1));
#elif MISTAKE == 15 // must return a number
  CGAL::simplify_outline_2(cdt, [](const K::Point_2&) { return std::string("fine"); });
#elif MISTAKE == 16 // sizing_function must be callable
  CGAL::simplify_outline_2(cdt, "fine");
#elif MISTAKE == 7 // must return a number
  CGAL::npbs_relax(cdt, [](const K::Point_2&) { return std::string("fine"); });
#elif MISTAKE == 8 // sizing_function must be callable
  CGAL::npbs_relax(cdt, "fine");
#elif MISTAKE == 9 // elevation_function is for a terrain
  CGAL::npbs_relax(cdt, P::elevation_function([](const K::Point_2&) { return 1; }));
#elif MISTAKE == 10 // elevation_function must be callable
  CGAL::npbs_relax(terrain, P::elevation_function([](const K::Point_3& p) { return p.z(); }));
#elif MISTAKE == 17 // edge_marker_map must be a property map
  CGAL::npbs_relax(cdt, P::edge_marker_map(CGAL::Face_region_map_2<CDT>()));
#elif MISTAKE == 18 // face_region_map must be a property map
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).face_region_map(CGAL::Constraint_marker_map_2<CDT>()));
#elif MISTAKE == 11 // it takes no terrain
  CGAL::simplify_outline_2(terrain);
#endif
}
