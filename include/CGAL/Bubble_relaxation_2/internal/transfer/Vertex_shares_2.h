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

/// The values of the source at the points of the target, linear in its triangles, those of the nearest places outside.
inline std::vector<double> interpolate(const Source_search_2& search, const std::vector<double>& values,
                                       const std::vector<Point>& points, const Threads& threads)
{
  std::vector<double> result(points.size());
  parallel_for(
    threads, points.size(),
    [&](std::size_t i) {
      const Source_location_2 place = search.locate(points[i]);
      const std::array<Index, 3>& v = search.source().triangles[place.triangle];
      const std::array<double, 3> u{values[v[0]], values[v[1]], values[v[2]]};
      Bounds bounds{u[0], u[0]};
      bounds.include(u[1]);
      bounds.include(u[2]);
      result[i] = bounds.clamp(linear_value(place.weights, u));
      for (int k = 0; k < 3; ++k)
        if (place.weights[k] == 1)
          result[i] = u[k]; // without the rounding of a sum: what did not move keeps its bits
    },
    256);
  return result;
}

/// Computes the shares of the triangles of the target.
class Vertex_shares_computation_2
{
public:
  Vertex_shares_computation_2(const Source_search_2& search, const Transfer_problem_2& problem,
                              const std::vector<double>& interpolated)
    : m_search(search), m_problem(problem), m_interpolated(interpolated)
  {}

  std::vector<Vertex_share_2> operator()(const Threads& threads) const
  {
    std::vector<Vertex_share_2> shares(m_problem.target.number_of_triangles());
    parallel_for(threads, shares.size(), [&](std::size_t t) { shares[t] = share(static_cast<Index>(t)); }, 256);
    return shares;
  }

private:
  using Values = std::array<double, 3>;

  static Values values_of(const std::vector<double>& values, const std::array<Index, 3>& v)
  {
    return {values[v[0]], values[v[1]], values[v[2]]};
  }

  Vertex_share_2 share(Index t) const
  {
    const Face_set_2 &source = m_problem.source, &target = m_problem.target;
    const Values u = values_of(m_interpolated, target.triangles[t]);
    Vertex_share_2 result;
    result.bounds = Bounds{u[0], u[0]};
    result.bounds.include(u[1]);
    result.bounds.include(u[2]);
    Source_search_2::Triangles found;
    m_search.find_overlapping(target, t, found);
    for (Index s : found) {
      const Overlap_polygon_2 polygon(source, s, target, t);
      if (polygon.area() > 0)
        add(polygon, target.area(t), u, values_of(m_problem.values, source.triangles[s]), result);
    }
    return result;
  }

  static void add(const Overlap_polygon_2& polygon, double target_area, const Values& u, const Values& source_values,
                  Vertex_share_2& result)
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
      const double sum = difference[i] + difference[j] + difference[k];
      for (int c = 0; c < 3; ++c)
        result.moments[c] += area / 12 * (hat[i][c] * (difference[i] + sum) + hat[j][c] * (difference[j] + sum) +
                                          hat[k][c] * (difference[k] + sum));
      result.overlap_integral += area * (value[i] + value[j] + value[k]) / 3;
    });
    result.overlap_area += polygon.area();
    ++result.pairs;
    for (double v : source_values)
      result.bounds.include(v);
  }

  const Source_search_2& m_search;
  const Transfer_problem_2& m_problem;
  const std::vector<double>& m_interpolated;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_SHARES_2_H
