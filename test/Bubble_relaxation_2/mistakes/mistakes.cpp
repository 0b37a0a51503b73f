// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Calls that cannot work. `check_mistakes.cmake` compiles them, and counts what the compiler says: one error for each,
// with the words above it. What both functions say is told once, so each has a part of its own.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Face_region_map_2.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <map>
#include <set>
#include <string>
#include <utility>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Terrain = CGAL::Constrained_Delaunay_triangulation_2<CGAL::Projection_traits_xy_3<K>>;
namespace P = CGAL::parameters;

double size_at(const K::Point_2& p)
{
  return 0.1 + p.x();
}

void right(CDT& cdt, Terrain& terrain)
{
  CGAL::npbs_relax(cdt);
  CGAL::simplify_outline_2(cdt, 0.1);
  CGAL::npbs_relax(cdt, 0.1);
  CGAL::npbs_relax(cdt, [](const K::Point_2& p) { return 0.1 + p.x(); });
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).callback([](double) { return true; }));
  CGAL::npbs_relax(cdt, size_at);
  CGAL::npbs_relax(terrain, [](const K::Point_2& p) { return 0.1 + p.x(); });
  CGAL::npbs_relax(terrain, P::elevation_function([](const K::Point_2&) { return 1; }));
  CGAL::npbs_relax(terrain, P::edge_marker_map(CGAL::Constraint_marker_map_2<Terrain>()));
  CGAL::npbs_relax(cdt, P::protect_constraints(true));
}

#if MISTAKES
void wrong(CDT& cdt, Terrain& terrain)
{
  CGAL::Delaunay_triangulation_2<K> unconstrained;
  CGAL::Constrained_Delaunay_triangulation_2<CGAL::Projection_traits_3<K>> slanted(
    CGAL::Projection_traits_3<K>(K::Vector_3(1, 1, 1)));
  const CDT fixed = cdt;
#if MISTAKES == 1
  // wrong: what has no constraints has no domain
  CGAL::npbs_relax(unconstrained);
  // wrong: cannot be const
  CGAL::npbs_relax(fixed, 0.1);
  // wrong: points in the plane
  CGAL::npbs_relax(slanted);
  // wrong: return a bool
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).callback([](double) {}));
  // wrong: Parallel_tag needs a program linked with TBB
  CGAL::npbs_relax(cdt, P::number_of_rounds(2).concurrency_tag(CGAL::Parallel_tag()));
  // wrong: seeds must be a range
  CGAL::npbs_relax(cdt, P::seeds(K::Point_2(0, 0)));
  // wrong: must return a number
  CGAL::npbs_relax(cdt, [](const K::Point_2&) { return std::string("fine"); });
  // wrong: sizing_function must be callable
  CGAL::npbs_relax(cdt, "fine");
  // wrong: elevation_function is for a terrain
  CGAL::npbs_relax(cdt, P::elevation_function([](const K::Point_2&) { return 1; }));
  // wrong: elevation_function must be callable
  CGAL::npbs_relax(terrain, P::elevation_function([](const K::Point_3& p) { return p.z(); }));
  // wrong: edge_marker_map must be a property map
  CGAL::npbs_relax(cdt, P::edge_marker_map(CGAL::Face_region_map_2<CDT>()));
  // wrong: protect_constraints must be a bool or a property map
  CGAL::npbs_relax(cdt, P::protect_constraints(std::set<CDT::Vertex_handle>()));
  // wrong: face_region_map must be a property map
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).face_region_map(CGAL::Constraint_marker_map_2<CDT>()));
  // wrong: vertex_is_constrained_map must be a property map
  CGAL::npbs_relax(cdt, P::vertex_is_constrained_map(std::set<CDT::Vertex_handle>()));
  // wrong: is CGAL's and none of Bubble_relaxation_2
  CGAL::npbs_relax(cdt, P::number_of_rounds(2).size(0.1));
#elif MISTAKES == 2
  // wrong: edge_marker_map must be a property map
  CGAL::simplify_outline_2(cdt, P::sizing_function(0.1).edge_marker_map(
                                  std::map<std::pair<CDT::Vertex_handle, CDT::Vertex_handle>, int>()));
  // wrong: face_region_map must be a property map
  CGAL::npbs_adapt(cdt, P::sizing_function(0.1).face_region_map([](CDT::Face_handle) { return 1; }));
  // wrong: it takes no terrain
  CGAL::simplify_outline_2(terrain);
  // wrong: what has no constraints has no domain
  CGAL::simplify_outline_2(unconstrained, 0.1);
  // wrong: cannot be const
  CGAL::simplify_outline_2(fixed, 0.1);
  // wrong: seeds must be a range
  CGAL::simplify_outline_2(cdt, P::seeds(K::Point_2(0, 0)).sizing_function(0.1));
  // wrong: must return a number
  CGAL::simplify_outline_2(cdt, [](const K::Point_2&) { return std::string("fine"); });
  // wrong: sizing_function must be callable
  CGAL::simplify_outline_2(cdt, "fine");
#elif MISTAKES == 3
  // wrong: faces must be a range
  CGAL::npbs_remesh_faces(cdt, cdt.infinite_face(), 0.1);
  // wrong: visitor must be a model of BubbleRelaxationVisitor_2
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).visitor(CGAL::Default_adaptation_visitor_2<CDT>()));
  // wrong: visitor must be a model of BubbleAdaptationVisitor_2
  CGAL::npbs_adapt(cdt, P::sizing_function(0.1).visitor(CGAL::Default_relaxation_visitor_2()));
#endif
}
#endif
