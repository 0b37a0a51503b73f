// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// How the cost of npbs_relax grows with the number of vertices: CPU time per vertex, and its ratio to the
// bare constrained Delaunay triangulation of the very vertices that come out (bulk insertion and
// constraints), measured in the same run.
//
//   scaling            1e3 to 1e6 vertices on a graded and a uniform domain
//   scaling 300000     up to this number

#include "../../examples/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Timer.h>
#include <CGAL/npbs_relax.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>

namespace {

/// seconds for inserting the vertices and constraints of a mesh into an empty triangulation
double floor_of(const paper::CDT& mesh)
{
  std::vector<paper::Point> points;
  std::map<paper::CDT::Vertex_handle, std::size_t> index;
  for (paper::CDT::Vertex_handle v : mesh.finite_vertex_handles()) {
    index[v] = points.size();
    points.push_back(v->point());
  }
  std::vector<std::pair<std::size_t, std::size_t>> constraints;
  for (const auto& e : mesh.finite_edges())
    if (mesh.is_constrained(e))
      constraints.emplace_back(index[e.first->vertex(mesh.ccw(e.second))],
                               index[e.first->vertex(mesh.cw(e.second))]);
  CGAL::Timer timer;
  timer.start();
  paper::CDT cdt;
  cdt.insert_constraints(points.begin(), points.end(), constraints.begin(), constraints.end());
  cdt.insert(points.begin(), points.end());
  return timer.time();
}

} // namespace

int main(int argc, char** argv)
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  std::cout << std::setw(20) << std::left << "domain" << std::right << std::setw(10) << "vertices"
            << std::setw(12) << "us/vertex" << std::setw(9) << "floors" << std::setw(9) << "mean q"
            << std::setw(8) << "min q" << std::setw(7) << "steps"
            << "   floors of: placement, renewal, motion, population, writing, evaluation\n"
            << std::fixed;
  for (auto make : {paper::square_with_hole, paper::non_convex}) {
    double f = 0.63; // about 1000 vertices of example 1
    for (double n = 1e3; n <= 1.01 * largest; n *= 10, f /= std::sqrt(10.)) {
      const double scale = make == paper::non_convex ? f * 1.7 : f;
      const paper::Domain domain = make(scale);
      paper::CDT cdt = paper::triangulate(domain);
      CGAL::Timer timer;
      timer.start();
      const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
      const double seconds = timer.time(), bare = floor_of(cdt);
      const auto& s = report.seconds;
      std::cout << std::setw(20) << std::left << domain.name << std::right << std::setw(10)
                << report.number_of_vertices << std::setprecision(2) << std::setw(12)
                << 1e6 * seconds / double(report.number_of_vertices) << std::setprecision(1)
                << std::setw(9) << seconds / bare << std::setprecision(4) << std::setw(9)
                << report.quality.mean_quality() << std::setprecision(3) << std::setw(8)
                << report.quality.minimum_quality() << std::setw(7) << report.number_of_steps
                << std::setprecision(1) << "   " << s.placement / bare << ' ' << s.renewal / bare << ' '
                << s.motion / bare << ' ' << s.population / bare << ' ' << s.writing / bare << ' '
                << s.evaluation / bare << std::endl;
    }
  }
}
