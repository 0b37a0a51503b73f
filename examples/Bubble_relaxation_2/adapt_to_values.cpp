// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A mesh that follows a solution: sizes at the vertices of a mesh, as an indicator of errors would give them,
// and the same mesh relaxed with these, several times.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT =
  CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Sizes = std::map<CDT::Vertex_handle, double>;

/// a front along a circle, which stands for a solution
double solution(const Point& p) { return std::tanh(20 * (std::hypot(p.x() - 0.2, p.y() - 0.1) - 0.7)); }

/// At each vertex the length at which a linear interpolation misses the solution by `error`: an edge of
/// length L misses it in its middle by about c L^2, and the largest c around the vertex counts.
Sizes wanted_sizes(const CDT& cdt, double error, double smallest, double largest)
{
  Sizes sizes;
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
    sizes[v] = largest;
  for (const auto& e : cdt.finite_edges()) {
    const CDT::Vertex_handle u = e.first->vertex(cdt.ccw(e.second)), v = e.first->vertex(cdt.cw(e.second));
    const double miss = std::abs(solution(CGAL::midpoint(u->point(), v->point())) -
                                 (solution(u->point()) + solution(v->point())) / 2);
    const double length = std::sqrt(CGAL::squared_distance(u->point(), v->point()));
    const double wanted = std::clamp(length * std::sqrt(error / (miss + 1e-12)), smallest, largest);
    for (CDT::Vertex_handle end : {u, v})
      sizes[end] = (std::min)(sizes[end], wanted);
  }
  return sizes;
}

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
  auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(0.06));
  picture.add_mesh(cdt, "d = 0.06");
  for (int turn = 1; turn <= 4; ++turn) {
    Sizes sizes = wanted_sizes(cdt, 0.02, 0.008, 0.15);
    // the field is a copy: the mesh that it was made of may be changed by it
    const CGAL::Interpolated_sizing_field_2<CDT> d(cdt, boost::make_assoc_property_map(sizes), 0.25);
    report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
    std::cout << "turn " << turn << ": " << report.number_of_vertices << " vertices, mean q "
              << report.quality.mean_quality() << ", smallest q " << report.quality.minimum_quality()
              << ", sizes grow by " << report.largest_size_gradient << " at most\n";
    if (turn == 4)
      picture.add_mesh(cdt, "turn " + std::to_string(turn));
  }
  picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  picture.write("adapted.svg");
}
