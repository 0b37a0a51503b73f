// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A cell whose opposite sides have the same nodes, as periodic boundary conditions need: it is meshed once, its left
// and lower sides are copied to the others, and it is meshed again with sides that stay as they are.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>
#include <CGAL/utility.h>

#include <cmath>
#include <iostream>
#include <set>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Vertex_handle = CDT::Vertex_handle;
using Edge_ends = std::pair<Vertex_handle, Vertex_handle>; // sorted

// a round hole
void insert_hole(CDT& cdt)
{
  std::vector<Point> hole;
  for (int i = 0; i < 40; ++i)
    hole.emplace_back(0.35 + 0.2 * std::cos(i * CGAL_PI / 20), 0.6 + 0.2 * std::sin(i * CGAL_PI / 20));
  cdt.insert_constraint(hole.begin(), hole.end(), true);
}

double size(const Point& p)
{
  return 0.02 + 0.15 * std::abs(std::hypot(p.x() - 0.35, p.y() - 0.6) - 0.2);
}

// where the unit square's lower side, or its left one, has nodes, from 0 to 1
std::set<double> cuts(const CDT& mesh, bool is_lower)
{
  std::set<double> result;
  for (Vertex_handle v : mesh.finite_vertex_handles())
    if ((is_lower ? v->point().y() : v->point().x()) == 0)
      result.insert(is_lower ? v->point().x() : v->point().y());
  return result;
}

int main()
{
  CDT once;
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  once.insert_constraint(square.begin(), square.end(), true);
  insert_hole(once);
  CGAL::npbs_relax(once, size);

  CDT cell;
  std::set<Edge_ends> sides;
  for (bool is_lower : {true, false})
    for (double opposite : {0., 1.}) {
      Vertex_handle last;
      for (double s : cuts(once, is_lower)) {
        const Vertex_handle v = cell.insert(is_lower ? Point(s, opposite) : Point(opposite, s));
        if (last != Vertex_handle()) {
          cell.insert_constraint(last, v);
          sides.insert(CGAL::make_sorted_pair(last, v));
        }
        last = v;
      }
    }
  insert_hole(cell);
  const auto report = CGAL::npbs_relax(
    cell, CGAL::parameters::sizing_function(size).protect_constraints(CGAL::make_boolean_property_map(sides)));

  std::set<Point> nodes;
  for (Vertex_handle v : cell.finite_vertex_handles())
    nodes.insert(v->point());
  int on_left = 0, with_partner = 0; // which a solver takes for one with it
  for (const Point& p : nodes)
    if (p.x() == 0) {
      ++on_left;
      with_partner += nodes.count(Point(1, p.y())) == 1 ? 1 : 0;
    }
  std::cout << report.number_of_vertices << " nodes, smallest angle " << report.quality.minimum_angle() << "; "
            << with_partner << " of " << on_left << " on the left side have one at the same height on the right\n";
}
