// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What finite-volume codes ask of a mesh: the statistics of the Voronoi cells of the benchmark's domains, and of
// shores from GSHHG, simplified within a tenth of d, without islands under half of its square and narrows under d,
// then without those under 2 d. For each mesh its cells, obtuse triangles, those of them at constraints, faces of a
// negative length, the smallest length of a face over the distance of its cells' centres, and the largest offset of a
// face's midpoint.
//
//   dual [1000 10000] [--coasts FOLDER] [--size 3] [NAME ...]
//
// Numbers are those of vertices; FOLDER, the size in kilometres and names are as for coasts.

#include "benchmark_domains.h"
#include "coast.h"
#include "simplified_coast.h"

#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>

#include <cctype>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Options
{
  std::vector<double> numbers;
  std::string folder;
  double size = 3;
  std::vector<std::string> names;
};

Options read_options(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const bool has_value = i + 1 < argc;
    if (a == "--coasts" && has_value)
      options.folder = argv[++i];
    else if (a == "--size" && has_value)
      options.size = std::atof(argv[++i]);
    else if (std::isdigit(static_cast<unsigned char>(a[0])))
      options.numbers.push_back(std::atof(a.c_str()));
    else
      options.names.push_back(a);
  }
  if (!(options.size > 0) || (options.folder.empty() && !options.names.empty()))
    throw std::invalid_argument("dual [NUMBER ...] [--coasts FOLDER] [--size KILOMETRES] [NAME ...]");
  if (options.numbers.empty())
    options.numbers = {1000, 10000};
  return options;
}

void print_columns()
{
  std::cout << std::left << std::setw(28) << "domain" << std::right << std::setw(8) << "cells" << std::setw(8)
            << "obtuse" << std::setw(16) << "at constraints" << std::setw(10) << "negative" << std::setw(15)
            << "face/distance" << std::setw(8) << "offset" << '\n'
            << std::fixed << std::setprecision(3);
}

void print(const std::string& name, const CGAL::Voronoi_quality_2& q)
{
  std::cout << std::left << std::setw(28) << name << std::right << std::setw(8) << q.number_of_cells << std::setw(8)
            << q.number_of_obtuse_triangles << std::setw(16) << q.number_of_centers_beyond_constraints << std::setw(10)
            << q.number_of_negative_faces << std::setw(15) << q.smallest_face_ratio << std::setw(8)
            << q.largest_midpoint_offset << std::endl;
}

void measure(const paper::Domain& domain, paper::CDT& cdt)
{
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
  print(domain.name, CGAL::Voronoi_dual_2<paper::CDT>(cdt).quality());
}

} // namespace

int main(int argc, char** argv)
try {
  const Options options = read_options(argc, argv);
  std::vector<Domain_maker> makers = compared_domains();
  makers.insert(makers.end(), {square, paper::non_convex, paper::ring});
  print_columns();
  for (double n : options.numbers)
    for (const Domain_maker& make : makers) {
      const paper::Domain domain = domain_with_vertices(make, n);
      paper::CDT cdt = paper::triangulate(domain);
      measure(domain, cdt);
    }
  if (options.folder.empty())
    return EXIT_SUCCESS;
  for (double gap : {1., 2.})
    for (paper::Domain coast : read_coasts(options.folder, options.size, options.names)) {
      paper::CDT cdt = paper::triangulate(coast);
      simplify_by_rules(coast, cdt, gap);
      coast.name += gap > 1 ? ", 2 d" : "";
      measure(coast, cdt);
    }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return EXIT_FAILURE;
}
