// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_SHARES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_SHARES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Source_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Transfer_problem_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What the source adds in a triangle of the target to what interpolation gives there, u<sub>S</sub> less
/// u<sub>I</sub>: both are linear in the triangles' common part, where all integrals are exact up to roundings.
struct Vertex_share_2
{
  /// integrals over the overlap of u<sub>S</sub> - u<sub>I</sub> times each hat function
  std::array<double, 3> moments{};
  double overlap_area = 0, overlap_integral = 0; ///< of u<sub>S</sub>
  std::size_t pairs = 0;
  Bounds bounds{0, 0}; ///< of the source triangles that overlap, and of u<sub>I</sub> at the corners
};

/// those at the corners of a triangle
inline std::array<double, 3> values_at(const std::vector<double>& values, const std::array<Index, 3>& corners)
{
  return {values[corners[0]], values[corners[1]], values[corners[2]]};
}

/// of values at the corners of a triangle
inline Bounds bounds_of(const std::array<double, 3>& values)
{
  Bounds bounds{values[0], values[0]};
  bounds.include(values[1]);
  bounds.include(values[2]);
  return bounds;
}

/// The values of the source at the points of the target, linear in its triangles, those of the nearest places outside.
inline std::vector<double> interpolate(const Source_search_2& search, const std::vector<double>& values,
                                       const std::vector<Point>& points, const Threads& threads)
{
  std::vector<double> result(points.size());
  parallel_for(
    threads, points.size(),
    [&](std::size_t i) {
      const Source_location_2 place = search.locate(points[i]);
      const std::array<double, 3> u = values_at(values, search.source().triangles[place.triangle]);
      result[i] = bounds_of(u).clamp(linear_value(place.weights, u));
      for (int k = 0; k < 3; ++k)
        if (place.weights[k] == 1)
          result[i] = u[k]; // without the rounding of a sum: what did not move keeps its bits
    },
    256);
  return result;
}

/// Adds what a triangle of the source has in common with one of the target. `u`: the values of u<sub>I</sub> at the
/// corners of the latter, `source_values` those of u<sub>S</sub> at the corners of the former
inline void add_overlap(const Overlap_polygon_2& polygon, double target_area, const std::array<double, 3>& u,
                        const std::array<double, 3>& source_values, Vertex_share_2& sum)
{
  std::array<Weights_3, Overlap_polygon_2::most> hat;
  std::array<double, Overlap_polygon_2::most> value, difference;
  for (int k = 0; k < polygon.size(); ++k) {
    hat[k] = polygon.target_weights(k);
    value[k] = linear_value(polygon.source_weights(k), source_values);
    difference[k] = value[k] - linear_value(hat[k], u);
  }
  polygon.for_each_triangle([&](int i, int j, int k, double share) {
    const double area = share * target_area;
    const double total = difference[i] + difference[j] + difference[k];
    for (int c = 0; c < 3; ++c)
      sum.moments[c] += area / 12 * (hat[i][c] * (difference[i] + total) + hat[j][c] * (difference[j] + total) +
                                     hat[k][c] * (difference[k] + total));
    sum.overlap_integral += area * (value[i] + value[j] + value[k]) / 3;
  });
  sum.overlap_area += polygon.area();
  ++sum.pairs;
  for (double v : source_values)
    sum.bounds.include(v);
}

/// The shares of the triangles of the target.
inline std::vector<Vertex_share_2> vertex_shares(const Source_search_2& search, const Transfer_problem_2& problem,
                                                 const std::vector<double>& interpolated, const Threads& threads)
{
  std::vector<Vertex_share_2> shares(problem.target.number_of_triangles());
  parallel_for(
    threads, shares.size(),
    [&](std::size_t k) {
      const Index t = static_cast<Index>(k);
      const double area = problem.target.area(t);
      const std::array<double, 3> u = values_at(interpolated, problem.target.triangles[k]);
      shares[k].bounds = bounds_of(u);
      search.for_each_overlap(problem.target, t, [&](Index s, const Overlap_polygon_2& polygon) {
        add_overlap(polygon, area, u, values_at(problem.values, problem.source.triangles[s]), shares[k]);
      });
    },
    256);
  return shares;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_SHARES_2_H
