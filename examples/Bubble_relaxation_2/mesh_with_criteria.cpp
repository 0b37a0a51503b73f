// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// CGAL's Delaunay refinement driven by the same d as the bubbles, and what the bubbles make of its mesh.

#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/Bubble_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/npbs_relax.h>

#include <iostream>

int main()
{
  using Criteria = CGAL::Bubble_mesh_criteria_2<paper::CDT, paper::Sizing>;
  const paper::Domain domain = paper::l_shape(0.5);
  paper::CDT cdt = paper::triangulate(domain);
  Svg_picture picture;

  CGAL::Delaunay_mesher_2<paper::CDT, Criteria> mesher(cdt, Criteria(domain.d));
  mesher.refine_mesh();
  const auto refined = CGAL::mesh_quality_2(cdt, CGAL::parameters::sizing_function(domain.d));
  std::cout << "Delaunay refinement\n" << refined << '\n';
  picture.add_mesh(cdt, "Delaunay refinement");
  picture.add_histogram(refined, "q = 2 r_in / r_out");

  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
  std::cout << "relaxed\n" << report.quality;
  picture.add_mesh(cdt, "relaxed");
  picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  picture.write("criteria.svg");
}
