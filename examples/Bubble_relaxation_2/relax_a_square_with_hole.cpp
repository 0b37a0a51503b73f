// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The quick start: a square with a round hole, meshed so that the triangles grow with the distance from
// the centre (eq. 1 of the paper).

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
    hole.push_back(Point(0.5 * std::cos(i * 0.125664), 0.5 * std::sin(i * 0.125664)));

  CDT cdt;
  cdt.insert_constraint(square.begin(), square.end(), true);
  cdt.insert_constraint(hole.begin(), hole.end(), true);

  const auto d = [](const Point& p) { return std::hypot(p.x(), p.y()) / 8; };
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));

  std::cout << report;
  Svg_picture picture;
  picture.add_mesh(cdt, "mesh, coloured by q");
  picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  picture.write("square_with_hole.svg");
}
