// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A coast that is known in far more detail than the mesh shall have: meshed as it is, with an outline within a tenth
// of d of it, and without its small islands and narrows.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/simplify_outline_2.h>

#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<Kernel>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

/// a ring around a point that is rough at all scales
std::vector<Point> coast(const Point& center, double radius, std::size_t n, std::mt19937& random)
{
  std::uniform_real_distribution<double> phase(0, 2 * CGAL_PI);
  const auto angle = [n](std::size_t i) { return 2 * CGAL_PI * double(i) / double(n); };
  std::vector<double> r(n, radius);
  for (std::size_t wave = 2; wave < n / 3; wave *= 2) {
    const double shift = phase(random);
    for (std::size_t i = 0; i < n; ++i)
      r[i] += 0.25 * radius / double(wave) * std::sin(angle(wave * i) + shift);
  }
  std::vector<Point> ring;
  for (std::size_t i = 0; i < n; ++i)
    ring.push_back(center + r[i] * Kernel::Vector_2(std::cos(angle(i)), std::sin(angle(i))));
  return ring;
}

CDT archipelago()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.01, 0.5), shift(-0.15, 0.15);
  CDT cdt;
  const std::vector<Point> sea = coast(Point(0, 0), 10, 3000, random);
  cdt.insert_constraint(sea.begin(), sea.end(), true);
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y) {
      const std::vector<Point> island =
        coast(Point(1.5 * x + shift(random), 1.5 * y + shift(random)), radius(random), 150, random);
      cdt.insert_constraint(island.begin(), island.end(), true);
    }
  return cdt;
}

void mesh(CDT& cdt, double d, const char* file)
{
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  std::cout << "  " << report.number_of_vertices << " vertices, mean q " << report.quality.mean_quality() << "\n\n";
  Svg_picture picture;
  picture.add_mesh(cdt, "mesh, coloured by q");
  picture.write(file);
}

int main()
{
  const double d = 0.25;
  CDT as_it_is = archipelago(), within_tolerance = as_it_is, without_details = as_it_is;

  std::cout << "the outline as it is\n";
  mesh(as_it_is, d, "outline_as_it_is.svg");

  std::cout << "an outline within a tenth of d\n"
            << CGAL::simplify_outline_2(within_tolerance,
                                        CGAL::parameters::sizing_function(d).relative_outline_tolerance(0.1));
  mesh(within_tolerance, d, "outline_within_tolerance.svg");

  const auto report = CGAL::simplify_outline_2(
    without_details, CGAL::parameters::sizing_function(d).minimum_island_area(d * d / 2).minimum_gap(d));
  std::cout << "without small islands and narrows\n" << report;
  for (const auto& island : report.dropped_islands)
    std::cout << "  dropped an island at " << island.place[0] << ' ' << island.place[1] << '\n';
  mesh(without_details, d, "outline_without_details.svg");
}
