// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A triangulation copied to arrays: vertices in the order of their points and triangles in the order of
/// their vertices, so that it does not matter how it came about.
template <class Triangulation>
struct Flattened_triangulation_2
{
  Flat_triangulation_2 tr;
  std::vector<typename Triangulation::Vertex_handle> vertices; ///< of each point
  std::vector<typename Triangulation::Face_handle> faces;      ///< of each triangle
};

/// \pre `t` has dimension 2
template <class Triangulation>
Flattened_triangulation_2<Triangulation> flatten_triangulation(const Triangulation& t)
{
  using Vertex_handle = typename Triangulation::Vertex_handle;
  using Face_handle = typename Triangulation::Face_handle;
  std::vector<std::pair<Point, Vertex_handle>> vertices;
  for (Vertex_handle v : t.finite_vertex_handles())
    vertices.emplace_back(Point(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y())), v);
  // points that coincide when rounded come as they are; who cannot have them checks
  std::stable_sort(vertices.begin(), vertices.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Flattened_triangulation_2<Triangulation> flat;
  Unique_hash_map<Vertex_handle, Index> vertex_index(no_index);
  for (const auto& v : vertices) {
    vertex_index[v.second] = static_cast<Index>(flat.tr.points.size());
    flat.tr.points.push_back(v.first);
    flat.vertices.push_back(v.second);
  }

  struct Corner_face
  {
    std::array<Index, 3> vertices; // the smallest first
    Face_handle face;
    int first; // index of the first vertex in the face
  };
  std::vector<Corner_face> faces;
  for (Face_handle f : t.finite_face_handles()) {
    const std::array<Index, 3> v{vertex_index[f->vertex(0)], vertex_index[f->vertex(1)],
                                 vertex_index[f->vertex(2)]};
    const int first = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin());
    faces.push_back({{v[first], v[ccw(first)], v[cw(first)]}, f, first});
  }
  std::sort(faces.begin(), faces.end(),
            [](const Corner_face& a, const Corner_face& b) { return a.vertices < b.vertices; });
  Unique_hash_map<Face_handle, Index> face_index(no_index);
  for (std::size_t k = 0; k < faces.size(); ++k)
    face_index[faces[k].face] = static_cast<Index>(k);
  for (const Corner_face& c : faces) {
    flat.tr.vertices.push_back(c.vertices);
    flat.tr.neighbors.push_back({face_index[c.face->neighbor(c.first)],
                                 face_index[c.face->neighbor(ccw(c.first))],
                                 face_index[c.face->neighbor(cw(c.first))]});
    flat.faces.push_back(c.face);
  }
  return flat;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLATTEN_TRIANGULATION_H
