// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_GATHERED_MESH_H
#define BUBBLE_RELAXATION_2_DEMO_GATHERED_MESH_H

#include "files/mesh_of_domain.h"
#include "mpi_session.h"

#include <CGAL/Mesh_arrays_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

/// The mesh of all ranks on the first one, in arrays as files want it. They are the same for any number of ranks.
class Gathered_mesh
{
public:
  /// Collective. \param mesh this rank's part
  template <class Mesh>
  Gathered_mesh(const Mpi_session& session, const Mesh& mesh)
    : m_vertices(session.gather(vertices(mesh))), m_triangles(session.gather(triangles(mesh))),
      m_lines(session.gather(lines(mesh)))
  {
    const auto sort = [](auto& records) {
      std::sort(records.begin(), records.end(), [](const auto& a, const auto& b) { return a.ids < b.ids; });
    };
    sort(m_vertices);
    sort(m_triangles);
    sort(m_lines);
  }

  /// On the first rank. \param domain that was meshed \param has_sizes whether files shall have them
  CGAL::Mesh_arrays_2 arrays(const Domain& domain, bool has_sizes) const
  {
    CGAL::Mesh_arrays_2 result;
    for (const Vertex& v : m_vertices) {
      result.points.emplace_back(v.x, v.y);
      if (has_sizes)
        result.vertex_data["d"].push_back(v.size);
    }
    const auto number = [this](std::int64_t id) {
      return static_cast<std::size_t>(std::lower_bound(m_vertices.begin(), m_vertices.end(), id,
                                                       [](const Vertex& v, std::int64_t i) { return v.ids[0] < i; }) -
                                      m_vertices.begin());
    };
    for (const Triangle& t : m_triangles) {
      result.triangles.push_back({number(t.ids[0]), number(t.ids[1]), number(t.ids[2])});
      result.regions.push_back(t.region);
    }
    for (const Line& l : m_lines) {
      result.edges.push_back({number(l.ids[0]), number(l.ids[1])});
      result.edge_markers.push_back(l.marker);
    }
    result.vertex_markers.assign(result.points.size(), 0);
    add_tags_of_file(domain, result);
    result.holes = CGAL::Mesh_arrays_2(domain.cdt).holes;
    return result;
  }

private:
  struct Vertex
  {
    std::array<std::int64_t, 1> ids;
    double x, y, size;
  };

  struct Triangle
  {
    std::array<std::int64_t, 3> ids; ///< the smallest first
    double region;
  };

  struct Line
  {
    std::array<std::int64_t, 2> ids;
    std::int32_t marker;
  };

  template <class Mesh>
  static std::vector<Vertex> vertices(const Mesh& mesh)
  {
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < mesh.number_of_owned_points(); ++i)
      result.push_back({{mesh.global_id(i)}, mesh.point(i).x(), mesh.point(i).y(), mesh.size(i)});
    return result;
  }

  template <class Mesh>
  static std::vector<Triangle> triangles(const Mesh& mesh)
  {
    std::vector<Triangle> result;
    for (std::size_t t = 0; t < mesh.number_of_owned_triangles(); ++t) {
      result.push_back({mesh.triangle(t), mesh.region(t)});
      auto& ids = result.back().ids;
      std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
    }
    return result;
  }

  /// those whose end with the smaller id is this rank's
  template <class Mesh>
  static std::vector<Line> lines(const Mesh& mesh)
  {
    std::map<std::array<std::int64_t, 2>, Line> known;
    for (std::size_t t = 0; t < mesh.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i) {
        if (!mesh.is_constrained(t, i))
          continue;
        const auto& v = mesh.vertices(t);
        auto a = static_cast<std::size_t>(v[static_cast<std::size_t>((i + 1) % 3)]),
             b = static_cast<std::size_t>(v[static_cast<std::size_t>((i + 2) % 3)]);
        if (mesh.global_id(b) < mesh.global_id(a))
          std::swap(a, b);
        if (mesh.is_ghost(a))
          continue;
        const std::array<std::int64_t, 2> ids{mesh.global_id(a), mesh.global_id(b)};
        known.insert({ids, Line{ids, mesh.marker(t, i)}});
      }
    std::vector<Line> result;
    for (const auto& line : known)
      result.push_back(line.second);
    return result;
  }

  std::vector<Vertex> m_vertices;
  std::vector<Triangle> m_triangles;
  std::vector<Line> m_lines;
};

#endif // BUBBLE_RELAXATION_2_DEMO_GATHERED_MESH_H
