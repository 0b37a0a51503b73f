// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_BARE_TRIANGULATION_H
#define BUBBLE_RELAXATION_2_BENCHMARK_BARE_TRIANGULATION_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <ctime>
#include <stdexcept>
#include <utility>
#include <vector>

/// The floor: the bare constrained Delaunay triangulation of the vertices and constraints of a mesh, with the
/// marks of its domain. It is the least that a mesher pays whose output is such a triangulation, so times in
/// floors can be compared between machines.

/// seconds of CPU time of this process, of all its threads and with what the system does for it
inline double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// What any mesher's output is reduced to: vertices, and the constraints, cut into edges of the mesh.
struct Vertices_and_constraints
{
  std::vector<paper::Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> constraints;
};

template <class CDT>
Vertices_and_constraints vertices_and_constraints(const CDT& mesh)
{
  Vertices_and_constraints result;
  CGAL::Unique_hash_map<typename CDT::Vertex_handle, std::size_t> index;
  for (typename CDT::Vertex_handle v : mesh.finite_vertex_handles()) {
    index[v] = result.points.size();
    result.points.push_back(v->point());
  }
  for (const auto& e : mesh.finite_edges())
    if (mesh.is_constrained(e))
      result.constraints.emplace_back(index[e.first->vertex(mesh.ccw(e.second))],
                                      index[e.first->vertex(mesh.cw(e.second))]);
  return result;
}

/// Marks the faces in an odd number of outlines, in the order of `all_face_handles()`: the faces numbered,
/// their neighbours and constrained edges in arrays, and one flood over them.
template <class CDT>
std::vector<char> faces_in_domain(const CDT& cdt)
{
  using Face_handle = typename CDT::Face_handle;
  std::vector<Face_handle> faces;
  CGAL::Unique_hash_map<Face_handle, std::size_t> index;
  for (Face_handle f : cdt.all_face_handles()) {
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

/// Makes the bare triangulation.
/// \returns seconds for one bulk insertion into the empty `cdt`, and for the marks
inline double triangulate_bare(const Vertices_and_constraints& mesh, paper::CDT& cdt)
{
  const double start = cpu_seconds();
  cdt.insert_constraints(mesh.points.begin(), mesh.points.end(), mesh.constraints.begin(),
                         mesh.constraints.end());
  const std::vector<char> is_inside = faces_in_domain(cdt);
  const double seconds = cpu_seconds() - start;
  std::size_t t = 0;
  for (paper::CDT::Face_handle f : cdt.all_face_handles())
    f->set_in_domain(is_inside[t++]);
  if (cdt.number_of_vertices() != mesh.points.size())
    throw std::runtime_error("the floor is not the mesh: it has other vertices");
  return seconds;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_BARE_TRIANGULATION_H
