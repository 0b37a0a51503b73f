// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What it costs to carry values over from a mesh to another one that is a little finer: CPU time, microseconds for a
// vertex of the source and for a pair of triangles that overlap, and by how much the integral changes; last for a part
// of both meshes, where the integral is another since the rims are. Interpolation intersects no triangles.
//
//   transfer [number of vertices ...]

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/npbs_relax.h>
#include <CGAL/transfer_2.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using paper::CDT;
using paper::Point;
namespace P = CGAL::parameters;

/// a square with about so many vertices, three times as far from each other in one corner as in the opposite one
CDT mesh(double number_of_vertices)
{
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CDT cdt = paper::triangulate({square});
  const double d = std::sqrt(1.15 / number_of_vertices);
  CGAL::npbs_relax(cdt, P::sizing_function([=](const Point& p) { return d * (0.55 + 0.5 * (p.x() + p.y())); }));
  return cdt;
}

double field(const Point& p) { return 1 + std::sin(9 * p.x()) * std::cos(7 * p.y()); }

template <class Transfer>
void print_row(const std::string& name, std::size_t vertices, const Transfer& transfer)
{
  const std::clock_t start = std::clock();
  const CGAL::Transfer_report_2 r = transfer();
  const double microseconds = 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC;
  const bool has_pairs = r.number_of_pairs > 0;
  const double before = has_pairs ? r.overlap_integral : r.source_integral;
  std::cout << std::left << std::setw(32) << name << std::right << std::setw(9) << vertices << std::fixed
            << std::setprecision(3) << std::setw(9) << 1e-6 * microseconds << std::setprecision(2) << std::setw(11)
            << microseconds / double(vertices) << std::setw(9);
  if (has_pairs)
    std::cout << r.number_of_pairs << std::setw(9) << microseconds / double(r.number_of_pairs);
  else
    std::cout << '-' << std::setw(9) << '-';
  std::cout << std::scientific << std::setprecision(1) << std::setw(10) << r.target_integral / before - 1 << std::endl;
}

/// the faces within a circle
std::vector<CDT::Face_handle> part(const CDT& cdt, double radius)
{
  std::vector<CDT::Face_handle> faces;
  for (CDT::Face_handle f : cdt.finite_face_handles())
    if (paper::distance(f->vertex(0)->point(), 0.5, 0.5) < radius)
      faces.push_back(f);
  return faces;
}

void measure(double number_of_vertices)
{
  const CDT source = mesh(number_of_vertices), target = mesh(1.3 * number_of_vertices);
  std::map<CDT::Vertex_handle, double> at_source, at_target;
  std::map<CDT::Face_handle, double> in_source, in_target;
  for (CDT::Vertex_handle v : source.finite_vertex_handles())
    at_source[v] = field(v->point());
  for (CDT::Face_handle f : source.finite_face_handles())
    in_source[f] = field(CGAL::centroid(source.triangle(f)));
  const auto vertices = [&](const std::string& name, std::size_t number, const auto& np) {
    print_row(name, number, [&] {
      return CGAL::transfer_vertex_values_2(source, boost::make_assoc_property_map(at_source), target,
                                            boost::make_assoc_property_map(at_target), np);
    });
  };
  const std::size_t all = source.number_of_vertices();
  const auto faces = [&](const std::string& name, CGAL::Face_transfer method) {
    print_row(name, all, [&] {
      return CGAL::transfer_face_values_2(source, boost::make_assoc_property_map(in_source), target,
                                          boost::make_assoc_property_map(in_target), P::transfer_method(method));
    });
  };
  vertices("vertices, interpolation", all, P::transfer_method(CGAL::Vertex_transfer::INTERPOLATION));
  vertices("vertices, projection", all, P::transfer_method(CGAL::Vertex_transfer::PROJECTION));
  vertices("vertices, monotone projection", all, P::transfer_method(CGAL::Vertex_transfer::MONOTONE_PROJECTION));
  faces("faces, mean", CGAL::Face_transfer::MEAN);
  faces("faces, reconstruction", CGAL::Face_transfer::RECONSTRUCTION);
  faces("faces, monotone reconstruction", CGAL::Face_transfer::MONOTONE_RECONSTRUCTION);
  // about a thousand vertices, whatever the whole has
  const double radius = std::sqrt(1000 / (3.14 * number_of_vertices));
  const auto from = part(source, radius), to = part(target, radius);
  std::set<CDT::Vertex_handle> those;
  for (CDT::Face_handle f : from)
    for (int i = 0; i < 3; ++i)
      those.insert(f->vertex(i));
  if (radius < 0.5)
    vertices("vertices of a part, projection", those.size(), P::source_faces(from).target_faces(to));
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<double> numbers{1e4, 1e5};
  if (argc > 1)
    numbers.clear();
  for (int k = 1; k < argc; ++k)
    numbers.push_back(std::atof(argv[k]));
  std::cout << "values at or in                  vertices  seconds  us/vertex    pairs  us/pair    change\n";
  for (double n : numbers)
    measure(n);
}
