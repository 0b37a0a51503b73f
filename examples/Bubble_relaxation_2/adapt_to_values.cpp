// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A mesh that follows a solution: sizes at the vertices of a mesh, as an indicator of errors would give them,
// and the same mesh relaxed with these, several times.

#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/npbs_relax.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

using paper::CDT;
using paper::Point;
using Sizes = std::map<CDT::Vertex_handle, double>;

/// a front along a circle, which stands for a solution
double solution(const Point& p) { return std::tanh(20 * (paper::distance(p, 0.2, 0.1) - 0.7)); }

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
  CDT cdt = paper::triangulate(paper::square_with_hole(1));
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
