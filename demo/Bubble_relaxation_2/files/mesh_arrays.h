// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_ARRAYS_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_ARRAYS_H

#include "domain.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

/// The mesh of a domain in arrays, as files want it.
struct Mesh_arrays
{
  std::vector<Point> points;
  std::vector<int> point_markers; ///< of the input, else that of the segment, else 1 on the boundary, else 0
  std::vector<double> sizes;      ///< d in the points; empty if no formula is given
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<double> regions; ///< attributes of the triangles; empty if there are no regions
  std::vector<std::array<std::size_t, 2>> edges; ///< the pieces of segments
  std::vector<int> edge_markers;                 ///< of the input, else 1 on the boundary, else 0
  std::vector<Point> holes;                      ///< a point in each hole
};

/// a point in each hole: the centroid of its largest face
inline std::vector<Point> points_in_holes(const CDT& cdt)
{
  std::vector<Point> holes;
  CGAL::Unique_hash_map<CDT::Face_handle, bool> is_reached(false);
  double largest = 0;
  Point point;
  const auto visit = [&](CDT::Face_handle f) {
    if (f->is_in_domain() || std::exchange(is_reached[f], true))
      return false;
    const double area = cdt.is_infinite(f) ? 0 : cdt.triangle(f).area();
    if (area > largest) {
      largest = area;
      point = CGAL::centroid(cdt.triangle(f));
    }
    return true;
  };
  flood(cdt.infinite_face(), visit);
  for (CDT::Face_handle f : cdt.finite_face_handles()) {
    largest = 0;
    flood(f, visit);
    if (largest > 0)
      holes.push_back(point);
  }
  return holes;
}

/// Points and triangles; returns the numbers of the vertices.
inline CGAL::Unique_hash_map<CDT::Vertex_handle, std::size_t>
add_triangles(const Domain& domain, const Region_map& regions, Mesh_arrays& mesh)
{
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  CGAL::Unique_hash_map<CDT::Vertex_handle, std::size_t> numbers(none);
  for (CDT::Face_handle f : domain.cdt.finite_face_handles()) {
    if (!f->is_in_domain())
      continue;
    std::array<std::size_t, 3> triangle;
    for (int i = 0; i < 3; ++i) {
      std::size_t& number = numbers[f->vertex(i)];
      if (number == none) {
        number = mesh.points.size();
        mesh.points.push_back(f->vertex(i)->point());
        mesh.point_markers.push_back(point_marker(domain, f->vertex(i)->point()));
      }
      triangle[static_cast<std::size_t>(i)] = number;
    }
    mesh.triangles.push_back(triangle);
    if (!domain.regions.empty())
      mesh.regions.push_back(regions(f));
  }
  return numbers;
}

/// Gives edges on the boundary a marker if they have none, and points without one that of an edge.
/// \param is_boundary of each edge
inline void complete_markers(Mesh_arrays& mesh, const std::vector<char>& is_boundary)
{
  const std::vector<int> own_markers = mesh.point_markers;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    int& marker = mesh.edge_markers[k];
    if (marker == 0 && is_boundary[k])
      marker = 1;
    for (const std::size_t i : mesh.edges[k])
      if (own_markers[i] == 0)
        mesh.point_markers[i] = (std::max)(mesh.point_markers[i], marker);
  }
}

/// \param regions of the faces
/// \param size d, or nothing
inline Mesh_arrays make_mesh_arrays(const Domain& domain, const Region_map& regions,
                                    const std::function<double(const Point&)>& size)
{
  Mesh_arrays mesh;
  const auto numbers = add_triangles(domain, regions, mesh);
  std::vector<char> is_boundary;
  for (const CDT::Edge& e : domain.cdt.finite_edges()) {
    const bool is_left = e.first->is_in_domain(), is_right = e.first->neighbor(e.second)->is_in_domain();
    if (!domain.cdt.is_constrained(e) || !(is_left || is_right))
      continue;
    const CDT::Vertex_handle u = e.first->vertex(CDT::ccw(e.second)), v = e.first->vertex(CDT::cw(e.second));
    mesh.edges.push_back({numbers[u], numbers[v]});
    mesh.edge_markers.push_back(segment_marker(domain, u->point(), v->point()));
    is_boundary.push_back(is_left != is_right);
  }
  complete_markers(mesh, is_boundary);
  if (size)
    for (const Point& p : mesh.points)
      mesh.sizes.push_back(size(p));
  mesh.holes = points_in_holes(domain.cdt);
  return mesh;
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_ARRAYS_H
