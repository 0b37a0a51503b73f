// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The parameters of the simulation: the integrator, its step, mass, damping and force, placement and
// population control, on the circle of Fig. 10 (eq. 4). One row each, and a picture of the last.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vb = CGAL::Triangulation_vertex_base_2<K>;
using Fb = CGAL::Delaunay_mesh_face_base_2<K>;
using CDT =
  CGAL::Constrained_Delaunay_triangulation_2<K, CGAL::Triangulation_data_structure_2<Vb, Fb>>;

double d(const Point& p) { return 0.04 * std::abs(std::hypot(p.x(), p.y()) - 0.3) / 0.3 + 0.02; }

int main()
{
  // all names start from here, so that they can be chained in any order
  namespace P = CGAL::Bubble_relaxation_parameters;
  std::vector<Point> circle;
  for (int i = 0; i < 63; ++i)
    circle.push_back(Point(0.6 * std::cos(2 * CGAL_PI * i / 63), 0.6 * std::sin(2 * CGAL_PI * i / 63)));
  Svg_picture picture;

  std::cout << std::setw(44) << std::left << "parameters" << std::right
            << "  vertices  evaluations  mean q  min q\n" << std::fixed << std::setprecision(3);
  const auto run = [&](const char* what, const auto& parameters) {
    CDT cdt;
    cdt.insert_constraint(circle.begin(), circle.end(), true);
    const auto report = CGAL::npbs_relax(cdt, parameters.sizing_function(d));
    std::cout << std::setw(44) << std::left << what << std::right << std::setw(10)
              << report.number_of_vertices << std::setw(13) << report.number_of_force_evaluations
              << std::setw(8) << report.quality.mean_quality() << std::setw(7)
              << report.quality.minimum_quality() << '\n';
    picture = Svg_picture();
    picture.add_mesh(cdt, what);
    picture.add_histogram(report.quality, "q = 2 r_in / r_out");
  };

  run("the paper's", CGAL::npbs_paper_parameters());
  run("the paper's, three times the time step", CGAL::npbs_paper_parameters().time_step(0.06));
  run("the paper's, less damping", CGAL::npbs_paper_parameters().damping(1.5));
  run("rhombic placement, overlap ratio", P::initial_placement(CGAL::Bubble_placement::RHOMBIC)
        .population_control(CGAL::Bubble_population::OVERLAP_RATIO));
  run("rhombic placement", P::initial_placement(CGAL::Bubble_placement::RHOMBIC));
  run("no population control", P::population_control(CGAL::Bubble_population::NONE));
  run("twice the force, more damping", P::force_coefficient(2.).damping(0.8));
  run("half the mass and the time step", P::mass(0.5).time_step(0.25));
  run("20 rounds, exact rest", P::number_of_rounds(20).displacement_tolerance(1e-6));
  run("defaults", P::integrator(CGAL::Bubble_integrator::SEMI_IMPLICIT_EULER));
  picture.write("defaults.svg");
}
