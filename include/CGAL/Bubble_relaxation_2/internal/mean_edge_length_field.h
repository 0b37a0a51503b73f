// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MEAN_EDGE_LENGTH_FIELD_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MEAN_EDGE_LENGTH_FIELD_H

#include <CGAL/Bubble_relaxation_2/internal/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/flatten_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

struct Edge_length
{
  std::array<Index, 2> ends;
  double length;
};

/// At each vertex the mean length of its edges in the domain. `edges`: both ends and the length of each.
inline std::vector<double> mean_edge_lengths(std::size_t number_of_vertices,
                                             std::vector<Edge_length> edges)
{
  // in the order of lengths, so that sums are rounded the same way whatever the order of the faces is
  std::sort(edges.begin(), edges.end(),
            [](const Edge_length& e, const Edge_length& f) { return e.length < f.length; });
  std::vector<double> sum(number_of_vertices, 0), count(number_of_vertices, 0);
  double all = 0;
  for (const Edge_length& e : edges) {
    for (Index v : e.ends) {
      sum[v] += e.length;
      ++count[v];
    }
    all += e.length;
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    sum[v] = count[v] > 0 ? sum[v] / count[v] : all / static_cast<double>(edges.size());
  return sum;
}

/// The size that a mesh has: at each vertex the mean length of its edges in the domain.
template <class Cdt, class Is_inside>
Interpolated_field_2 mean_edge_length_field(const Cdt& cdt, const Is_inside& is_inside)
{
  auto flat = flatten_triangulation(cdt);
  const Flat_triangulation_2& tr = flat.tr;
  std::vector<char> inside;
  for (auto f : flat.faces)
    inside.push_back(is_inside(f) ? 1 : 0);
  std::vector<Edge_length> edges;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (int i = 0; i < 3 && inside[t]; ++i) {
      const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)], n = tr.neighbors[t][i];
      if (a < b || n == no_index || !inside[n]) // else it is added from the other side
        edges.push_back({{a, b}, std::sqrt(CGAL::squared_distance(tr.points[a], tr.points[b]))});
    }
  std::vector<double> sizes = mean_edge_lengths(tr.points.size(), std::move(edges));
  return Interpolated_field_2(std::move(flat.tr), std::move(inside), std::move(sizes));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MEAN_EDGE_LENGTH_FIELD_H
