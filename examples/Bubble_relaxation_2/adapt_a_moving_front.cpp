// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A front moves through a mesh: only the part is meshed anew where the sizes that it asks for have changed, and the
// values in the faces go along.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/transfer_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>,
                                                 CGAL::Delaunay_mesh_face_base_2<K>>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K, Tds>;
using Values = std::map<CDT::Face_handle, double>;

/// carries the values of the old faces over to the new ones
struct Carrier : CGAL::Default_adaptation_visitor_2<CDT>
{
  const CDT& cdt;
  Values& values;

  Carrier(const CDT& t, Values& v) : cdt(t), values(v) {}

  void while_both_exist(const Faces& old_faces, const Vertices&, const Faces& new_faces, const Vertices&)
  {
    Values carried;
    CGAL::transfer_face_values_2(cdt, boost::make_assoc_property_map(values), cdt,
                                 boost::make_assoc_property_map(carried),
                                 CGAL::parameters::source_faces(old_faces).target_faces(new_faces));
    for (CDT::Face_handle f : old_faces)
      values.erase(f);
    values.insert(carried.begin(), carried.end());
  }
};

int main()
{
  CDT cdt;
  const std::vector<K::Point_2> outline{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  cdt.insert_constraint(outline.begin(), outline.end(), true);

  double front = 0.3; // where it is: a circle around a corner
  const auto d = [&front](const K::Point_2& p) {
    return (std::min)(0.05, 0.008 + 0.2 * std::abs(std::hypot(p.x(), p.y()) - front));
  };
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(std::cref(d)));

  Values values;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    values[f] = std::hypot(f->vertex(0)->point().x(), f->vertex(0)->point().y()) < front ? 1 : 0;
  const auto integral = [&] {
    double sum = 0;
    for (const auto& [face, value] : values)
      sum += value * cdt.triangle(face).area();
    return sum;
  };
  const double before = integral();

  Carrier carrier(cdt, values);
  for (int step = 0; step < 20; ++step) {
    front += 0.02;
    const auto report =
      CGAL::npbs_adapt(cdt, CGAL::parameters::sizing_function(std::cref(d)).visitor(std::ref(carrier)));
    std::cout << cdt.number_of_faces() << " faces, new " << report.number_of_triangles << ", smallest q of them "
              << report.quality.minimum_quality() << '\n';
  }
  std::cout << "the integral of the values has changed by " << integral() - before << '\n';
  return std::abs(integral() - before) < 1e-12 ? 0 : 1;
}
