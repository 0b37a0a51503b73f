// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_REMAP_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_REMAP_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Compensated_sum.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_overlaps_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/face_slopes.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Values of target triangles from those of the source triangles that overlap them: first the mean over the overlap,
/// which is the projection, then what slopes in the source triangles add. A slope turns about the centroid of what the
/// target covers of the triangle, so it moves the integral among the triangles of the target and does not change it.
/// For the monotone variant the slope of each source triangle is made flatter until no target triangle that it adds to
/// can leave its bounds: the limiter of flux-corrected transport (Zalesak, J. Comput. Phys. 31 (1979)) with a source
/// triangle in the place of a flux. Limits of slopes in the source itself, the usual way, would flatten more.
class Face_remap_2
{
public:
  Face_remap_2(const Transfer_problem_2& problem, const Source_search_2& search, const Threads& threads)
    : m_problem(problem), m_overlaps(face_overlaps(search, problem.target, threads))
  {
    for (std::size_t t = 0; t < problem.target.number_of_triangles(); ++t)
      set_mean(search, t);
  }

  std::vector<double>& values() { return m_values; }
  std::vector<Bounds>& bounds() { return m_bounds; }
  const Face_overlaps_2& overlaps() const { return m_overlaps; }
  const std::vector<double>& overlap_areas() const { return m_areas; }

  /// adds what slopes do, within bounds or without
  void add_slopes(bool is_monotone)
  {
    const Face_set_2& source = m_problem.source;
    const Triangles_around_2 around(source.triangles, source.points.size(), [](std::size_t) { return true; });
    m_slopes = face_slopes(source, around, m_problem.values);
    compute_centers();
    std::vector<double> shares(m_slopes.size(), 1);
    if (is_monotone) {
      widen_bounds(bounds_around(source, around, m_problem.values));
      limit(shares);
    }
    for (std::size_t t = 0; t < m_values.size(); ++t) {
      Compensated_sum sum;
      for (const Face_overlap_2& o : m_overlaps[t])
        sum += shares[o.source] * excess(o);
      if (m_areas[t] > 0)
        m_values[t] += sum.value() / m_areas[t];
      if (is_monotone)
        m_values[t] = m_bounds[t].clamp(m_values[t]);
    }
  }

private:
  /// the mean over the overlap; if there is none the value of the source triangle that is the nearest to the centroid
  void set_mean(const Source_search_2& search, std::size_t t)
  {
    const std::vector<double>& u = m_problem.values;
    double area = 0, sum = 0, first = 0;
    Bounds bounds{0, 0};
    for (const Face_overlap_2& o : m_overlaps[t]) {
      if (area == 0)
        bounds = Bounds{first = u[o.source], u[o.source]};
      bounds.include(u[o.source]);
      area += o.area;
      sum += o.area * (u[o.source] - first); // of differences, so that constants keep their bits
    }
    m_areas.push_back(area);
    if (area > 0) {
      m_values.push_back(bounds.clamp(first + sum / area));
      m_bounds.push_back(bounds);
      return;
    }
    const Face_set_2& target = m_problem.target;
    const Point& p = target.point(static_cast<Index>(t), 0);
    const Offset_2 a = offset(p, target.point(static_cast<Index>(t), 1)),
                   b = offset(p, target.point(static_cast<Index>(t), 2));
    const double value = u[search.locate(Point(p.x() + (a.x + b.x) / 3, p.y() + (a.y + b.y) / 3)).triangle];
    m_values.push_back(value);
    m_bounds.push_back(Bounds{value, value});
  }

  /// the centroids of what is covered of the source triangles, by their barycentric coordinates
  void compute_centers()
  {
    m_centers.assign(m_slopes.size(), Offset_2{0, 0});
    std::vector<double> areas(m_slopes.size(), 0);
    for (std::size_t t = 0; t < m_values.size(); ++t)
      for (const Face_overlap_2& o : m_overlaps[t]) {
        areas[o.source] += o.area;
        m_centers[o.source].x += o.moment.x;
        m_centers[o.source].y += o.moment.y;
      }
    for (std::size_t s = 0; s < areas.size(); ++s)
      if (areas[s] > 0)
        m_centers[s] = Offset_2{m_centers[s].x / areas[s], m_centers[s].y / areas[s]};
  }

  /// what the slope adds to the integral over an overlap
  double excess(const Face_overlap_2& o) const
  {
    const Offset_2& c = m_centers[o.source];
    return dot(m_slopes[o.source], Offset_2{o.moment.x - o.area * c.x, o.moment.y - o.area * c.y});
  }

  void widen_bounds(const std::vector<Bounds>& around)
  {
    for (std::size_t t = 0; t < m_values.size(); ++t)
      for (const Face_overlap_2& o : m_overlaps[t])
        m_bounds[t].include(around[o.source]);
  }

  /// the shares of slopes with which no bound is left, whatever part of the others is taken
  void limit(std::vector<double>& shares) const
  {
    for (std::size_t t = 0; t < m_values.size(); ++t) {
      double gain = 0, loss = 0;
      for (const Face_overlap_2& o : m_overlaps[t])
        (excess(o) > 0 ? gain : loss) += excess(o);
      const double upper = share_in_room(m_areas[t] * (m_bounds[t].largest - m_values[t]), gain);
      const double lower = share_in_room(m_areas[t] * (m_bounds[t].least - m_values[t]), loss);
      for (const Face_overlap_2& o : m_overlaps[t])
        shares[o.source] = (std::min)(shares[o.source], excess(o) > 0 ? upper : excess(o) < 0 ? lower : 1);
    }
  }

  const Transfer_problem_2& m_problem;
  Face_overlaps_2 m_overlaps;
  std::vector<double> m_values, m_areas; // of the target: values, covered areas
  std::vector<Bounds> m_bounds;
  std::vector<Offset_2> m_slopes, m_centers; // of the source
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_REMAP_2_H
