// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Figures 19 to 21 of the paper: a mesh, and the same mesh after d has been changed (eq. 12): refined near
// the hole, and what already fits is kept. Then it is coarsened.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT =
  CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

int main()
{
  const std::vector<Point> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<Point> hole;
  for (int i = 0; i < 50; ++i)
    hole.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / 50), 0.5 * std::sin(2 * CGAL_PI * i / 50)));

  CDT cdt;
  cdt.insert_constraint(square.begin(), square.end(), true);
  cdt.insert_constraint(hole.begin(), hole.end(), true);

  Svg_picture picture;
  const auto relax = [&](const char* what, const auto& d) {
    const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
    std::cout << what << ": " << report.number_of_initial_bubbles << " bubbles to start with, "
              << report.number_of_insertions << " inserted, " << report.number_of_deletions
              << " deleted\n"
              << report.quality << '\n';
    picture.add_mesh(cdt, what);
    picture.add_histogram(report.quality, what);
  };

  relax("eq. 1", [](const Point& p) { return std::hypot(p.x(), p.y()) / 8; });
  relax("refined, eq. 12", [](const Point& p) {
    const double r = std::hypot(p.x(), p.y());
    return r / (r > 0.7 ? 8 : r > 0.6 ? 11 : 14);
  });
  relax("coarsened, d = 0.1 to 0.2", [](const Point& p) { return 0.05 + std::hypot(p.x(), p.y()) / 10; });
  picture.write("refined.svg");
}
