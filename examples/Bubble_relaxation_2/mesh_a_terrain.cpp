// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A terrain, points in space with a break line, is meshed anew: finely where it is steep. New vertices lie on the surface
// that was there, so the new one misses it by the curvature only, which is checked.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interpolated_elevation_2.h>
#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Projection_traits_xy_3<K>;
using Vb = CGAL::Triangulation_vertex_base_2<Traits>;
using Fb = CGAL::Delaunay_mesh_face_base_2<Traits>;
using Terrain =
  CGAL::Constrained_Delaunay_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<Vb, Fb>>;
using Point = Terrain::Point; // in space
using Sizes = std::map<Terrain::Vertex_handle, double>;

/// a hill on a slope, with a bend along a line: what a survey would measure
double ridge(double x) { return 0.3 * x - 0.1; }
double elevation(double x, double y)
{
  return std::exp(-4 * (x * x + y * y)) + 0.4 * std::abs(y - ridge(x));
}
constexpr double largest_curvature = 8; // second derivative of the hill, on its top

Point measured(double x, double y) { return Point(x, y, elevation(x, y)); }

/// points that are scattered in a square, the border of the square, and the line as a constraint
Terrain survey()
{
  Terrain terrain;
  constexpr int n = 50;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.3, 0.3);
  const auto coordinate = [&](double i) { return 2 * i / n - 1; };
  for (int i = 1; i < n; ++i)
    for (int j = 1; j < n; ++j) {
      const double x = coordinate(i + shift(random)), y = coordinate(j + shift(random));
      terrain.insert(measured(x, y));
    }
  for (int i = 0; i < n; ++i) {
    const double a = coordinate(i), b = coordinate(i + 1);
    terrain.insert_constraint(measured(a, -1), measured(b, -1));
    terrain.insert_constraint(measured(a, 1), measured(b, 1));
    terrain.insert_constraint(measured(-1, a), measured(-1, b));
    terrain.insert_constraint(measured(1, a), measured(1, b));
    terrain.insert_constraint(measured(a, ridge(a)), measured(b, ridge(b)));
  }
  return terrain;
}

/// at each vertex, what the steepest face there asks for
Sizes wanted_sizes(const Terrain& terrain)
{
  Sizes sizes;
  for (Terrain::Face_handle f : terrain.finite_face_handles()) {
    const K::Vector_3 n = CGAL::normal(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
    const double slope = std::hypot(n.x(), n.y()) / n.z();
    for (int i = 0; i < 3; ++i) {
      double& d = sizes.emplace(f->vertex(i), 0.1).first->second;
      d = (std::min)(d, (std::max)(0.02, 0.03 / slope));
    }
  }
  return sizes;
}

/// the square of the longest edge, seen from above
double squared_length(const Terrain& terrain)
{
  double largest = 0;
  for (const Terrain::Edge& e : terrain.finite_edges()) {
    const K::Vector_3 u = e.first->vertex(terrain.cw(e.second))->point() -
                          e.first->vertex(terrain.ccw(e.second))->point();
    largest = (std::max)(largest, u.x() * u.x() + u.y() * u.y());
  }
  return largest;
}

void write_off(const Terrain& terrain, const char* path)
{
  std::ofstream out(path);
  out << "OFF\n" << terrain.number_of_vertices() << ' ' << terrain.number_of_faces() << " 0\n";
  std::map<Terrain::Vertex_handle, std::size_t> number;
  for (Terrain::Vertex_handle v : terrain.finite_vertex_handles()) {
    number.emplace(v, number.size());
    out << v->point() << '\n';
  }
  for (Terrain::Face_handle f : terrain.finite_face_handles())
    out << "3 " << number[f->vertex(0)] << ' ' << number[f->vertex(1)] << ' ' << number[f->vertex(2)] << '\n';
}

int main()
{
  const Terrain before = survey();
  Terrain terrain = before;
  Sizes sizes = wanted_sizes(before);
  const CGAL::Interpolated_sizing_field_2<Terrain> d(before, boost::make_assoc_property_map(sizes), 0.25);
  const auto report = CGAL::npbs_relax(terrain, CGAL::parameters::sizing_function(d));
  std::cout << before.number_of_vertices() << " vertices before, " << report.number_of_vertices
            << " after, mean q " << report.quality.mean_quality() << '\n';
  write_off(terrain, "terrain.off");

  const CGAL::Interpolated_elevation_2<Terrain> old_surface(before), new_surface(terrain);
  double at_new = 0, at_old = 0;
  for (Terrain::Vertex_handle v : terrain.finite_vertex_handles())
    at_new = (std::max)(at_new, std::abs(v->point().z() - old_surface({v->point().x(), v->point().y()})));
  for (Terrain::Vertex_handle v : before.finite_vertex_handles())
    at_old = (std::max)(at_old, std::abs(v->point().z() - new_surface({v->point().x(), v->point().y()})));
  // a triangle misses the hill by half of the curvature times the square of the radius of the circle around it at most,
  // which is no more than its longest edge over the root of three
  const double bound = largest_curvature / 6 * (squared_length(before) + squared_length(terrain));
  std::cout << "new vertices miss the old surface by " << at_new << ", old vertices the new one by " << at_old
            << ", which is to be less than " << bound << '\n';
  return at_new < 1e-14 && at_old < bound ? EXIT_SUCCESS : EXIT_FAILURE;
}
