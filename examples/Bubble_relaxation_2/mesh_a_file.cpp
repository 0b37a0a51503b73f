// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A domain from a file of Triangle, with points in its holes, meshed and written for ParaView, by CGAL's own reader
// and writer:
//
//   mesh_a_file shore.poly 0.05 shore.vtu

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_poly.h>
#include <CGAL/IO/write_VTU.h>
#include <CGAL/npbs_relax.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT =
  CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

int main(int argc, char** argv)
{
  const char* input = argc > 1 ? argv[1] : "data/two_holes.poly";
  const double d = argc > 2 ? std::atof(argv[2]) : 0.1;
  const char* output = argc > 3 ? argv[3] : "mesh.vtu";

  std::ifstream in(input);
  if (!in) {
    std::cerr << input << ": cannot be opened\n";
    return EXIT_FAILURE;
  }
  CDT cdt;
  std::vector<Point> holes;
  CGAL::IO::read_triangle_poly_file(cdt, in, std::back_inserter(holes));

  std::cout << CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d).seeds(holes));

  std::ofstream out(output);
  CGAL::IO::write_VTU(out, cdt); // the triangles that are in the domain, which npbs_relax() has marked
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
