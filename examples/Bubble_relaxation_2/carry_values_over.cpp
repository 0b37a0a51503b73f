// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A mesh whose fine part goes round, and a field that is carried over from each mesh to the next one: by interpolation,
// which loses some of its integral each time, and by a projection, which keeps it, and all bounds.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>
#include <CGAL/transfer_2.h>

#include <cmath>
#include <iostream>
#include <map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Values = std::map<CDT::Vertex_handle, double>;

/// a drop of something, in the middle of the domain
double drop(const Point& p) { return std::hypot(p.x(), p.y()) < 0.4 ? 1 : 0; }

CDT square()
{
  const std::vector<Point> outline{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  CDT cdt;
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  return cdt;
}

int main()
{
  for (auto method : {CGAL::Vertex_transfer::INTERPOLATION, CGAL::Vertex_transfer::MONOTONE_PROJECTION}) {
    CDT cdt = square();
    Values values;
    double integral = 0;
    for (int step = 0; step <= 12; ++step) {
      const double x = 0.4 * std::cos(2 * CGAL_PI * step / 12), y = 0.4 * std::sin(2 * CGAL_PI * step / 12);
      const auto d = [=](const Point& p) { return 0.03 + 0.1 * std::hypot(p.x() - x, p.y() - y); };

      // the values belong to the vertices of the old mesh, so it is the new one that is made beside it
      CDT next = square();
      CGAL::npbs_relax(next, CGAL::parameters::sizing_function(d));
      Values next_values;
      if (step == 0) {
        for (CDT::Vertex_handle v : next.finite_vertex_handles())
          next_values[v] = drop(v->point());
      } else {
        const CGAL::Transfer_report_2 report = CGAL::transfer_vertex_values_2(
          cdt, boost::make_assoc_property_map(values), next, boost::make_assoc_property_map(next_values),
          CGAL::parameters::transfer_method(method));
        if (step == 1)
          integral = report.source_integral;
        if (step == 12)
          std::cout << (method == CGAL::Vertex_transfer::INTERPOLATION ? "interpolation: " : "projection:    ")
                    << "after 12 meshes the integral has changed by "
                    << 100 * (report.target_integral / integral - 1) << " %\n";
      }
      cdt.swap(next); // handles stay valid
      values.swap(next_values);
    }
  }
}
