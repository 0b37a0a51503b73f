// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL's Delaunay refinement driven by the same d as the bubbles, and what the bubbles make of its mesh.

#include "svg_picture.h"

#include <CGAL/Bubble_mesh_criteria_2.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT =
  CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Sizing = std::function<double(const Point&)>;
using Criteria = CGAL::Bubble_mesh_criteria_2<CDT, Sizing>;

int main()
{
  // the paper's L, dense in its inner corner (eq. 6, with half of its d)
  const std::vector<Point> outline{{0, 0}, {0.4, 0}, {0.4, 0.6}, {1, 0.6}, {1, 1}, {0, 1}};
  const Sizing d = [](const Point& p) {
    return 0.5 * (std::min)(0.16 * std::hypot(p.x() - 0.4, p.y() - 0.6) + 0.01, 0.08);
  };
  CDT cdt;
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  Svg_picture picture;

  CGAL::Delaunay_mesher_2<CDT, Criteria> mesher(cdt, Criteria(d));
  mesher.refine_mesh();
  const auto refined = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(d));
  std::cout << "Delaunay refinement\n" << refined << '\n';
  picture.add_mesh(cdt, "Delaunay refinement");
  picture.add_histogram(refined, "q = 2 r_in / r_out");

  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  std::cout << "relaxed\n" << report.quality;
  picture.add_mesh(cdt, "relaxed");
  picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  picture.write("criteria.svg");
}
