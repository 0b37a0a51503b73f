// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// How the cost of npbs_relax grows with the number of vertices: CPU time per vertex, and its ratio to the
// floor, the bare constrained Delaunay triangulation of the very vertices that come out: one bulk
// insertion of vertices and constraints, and the marks of the domain, measured in the same run. The last
// line of a domain is the time per vertex at the largest number over that at 1e4.
//
//   scaling            1e3 to 1e6 vertices on a graded and a uniform domain
//   scaling 300000     up to this number

#include "../../examples/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Timer.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

namespace {

using CDT = paper::CDT;

/// Marks the faces in an odd number of outlines: the faces numbered, their neighbours and constrained edges
/// in arrays, and one flood over them.
std::vector<char> mark_domain(const CDT& cdt)
{
  std::vector<CDT::Face_handle> faces;
  CGAL::Unique_hash_map<CDT::Face_handle, std::size_t> index;
  for (CDT::Face_handle f : cdt.all_face_handles()) {
    index[f] = faces.size();
    faces.push_back(f);
  }
  std::vector<std::array<std::size_t, 3>> neighbors(faces.size());
  std::vector<std::array<bool, 3>> is_wall(faces.size());
  for (std::size_t t = 0; t < faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      neighbors[t][i] = index[faces[t]->neighbor(i)];
      is_wall[t][i] = faces[t]->is_constrained(i);
    }
  std::vector<char> is_inside(faces.size(), 0), is_seen(faces.size(), 0);
  std::vector<std::size_t> stack(1, index[cdt.infinite_face()]);
  is_seen[stack[0]] = 1;
  while (!stack.empty()) {
    const std::size_t t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const std::size_t next = neighbors[t][i];
      if (is_seen[next])
        continue;
      is_seen[next] = 1;
      is_inside[next] = is_inside[t] != is_wall[t][i];
      stack.push_back(next);
    }
  }
  return is_inside;
}

/// seconds for inserting the vertices and constraints of a mesh into an empty triangulation and marking
/// its domain
double floor_of(const CDT& mesh)
{
  std::vector<paper::Point> points;
  std::map<CDT::Vertex_handle, std::size_t> index;
  for (CDT::Vertex_handle v : mesh.finite_vertex_handles()) {
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
  CDT cdt;
  cdt.insert_constraints(points.begin(), points.end(), constraints.begin(), constraints.end());
  const std::vector<char> is_inside = mark_domain(cdt);
  const double seconds = timer.time();
  const auto inside = std::count(is_inside.begin(), is_inside.end(), 1);
  const auto wanted = std::count_if(mesh.finite_faces_begin(), mesh.finite_faces_end(),
                                    [](const CDT::Face& f) { return f.is_in_domain(); });
  if (cdt.number_of_vertices() != mesh.number_of_vertices() || inside != wanted)
    std::cerr << "scaling: the floor is not the mesh\n";
  return seconds;
}

void print_header()
{
  std::cout << std::setw(20) << std::left << "domain" << std::right << std::setw(10) << "vertices"
            << std::setw(12) << "us/vertex" << std::setw(9) << "floors" << std::setw(9) << "mean q"
            << std::setw(8) << "min q" << std::setw(7) << "steps"
            << "   % of: placement, renewal, motion, population, writing, evaluation\n"
            << std::fixed;
}

/// meshes a domain, prints its row, returns microseconds per vertex
double measure(const paper::Domain& domain)
{
  CDT cdt = paper::triangulate(domain);
  CGAL::Timer timer;
  timer.start();
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
  const double seconds = timer.time(), bare = floor_of(cdt);
  const double per_vertex = 1e6 * seconds / double(report.number_of_vertices);
  const auto& s = report.seconds;
  std::cout << std::setw(20) << std::left << domain.name << std::right << std::setw(10)
            << report.number_of_vertices << std::setprecision(2) << std::setw(12) << per_vertex
            << std::setprecision(1) << std::setw(9) << seconds / bare << std::setprecision(4)
            << std::setw(9) << report.quality.mean_quality() << std::setprecision(3) << std::setw(8)
            << report.quality.minimum_quality() << std::setw(7) << report.number_of_steps
            << std::setprecision(0) << "  ";
  // of wall-clock time: phases are not timed otherwise
  for (double phase : {s.placement, s.renewal, s.motion, s.population, s.writing, s.evaluation})
    std::cout << ' ' << 100 * phase / s.total();
  std::cout << std::endl;
  return per_vertex;
}

} // namespace

int main(int argc, char** argv)
{
  const double largest = argc > 1 ? std::atof(argv[1]) : 1e6;
  print_header();
  for (auto make : {paper::square_with_hole, paper::non_convex}) {
    double f = make == paper::non_convex ? 0.63 * 1.7 : 0.63; // about 1000 vertices
    double at_ten_thousand = 0, at_last = 0, last = 0;
    for (double n = 1e3; n <= 1.01 * largest; n *= 10, f /= std::sqrt(10.)) {
      at_last = measure(make(f));
      last = n;
      if (n == 1e4)
        at_ten_thousand = at_last;
    }
    if (last > 1e4)
      std::cout << "time per vertex at " << std::setprecision(0) << last << " over that at 10000: "
                << std::setprecision(2) << at_last / at_ten_thousand << std::endl;
  }
}
