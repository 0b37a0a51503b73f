// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The rule `minimum_island_area`: takes small islands into the domain. An island is a region outside of the domain
/// that has the domain all around it, and nothing else: no vertex that stays, no other constraint, no domain within.
class Island_rule_2
{
public:
  Island_rule_2(const Outline_2& outline, double least_area)
    : m_outline(outline), m_triangulation(outline), m_least_area(least_area), m_degree(outline.points.size(), 0)
  {
    for (const Outline_segment_2& s : outline.segments)
      for (Index v : {s.source, s.target})
        ++m_degree[v];
  }

  Outline_2 operator()(Outline_simplification_report_2<double>& report)
  {
    for (const std::vector<Index>& region :
         m_triangulation.regions([this](Index t) { return !m_triangulation.is_inside(t); })) {
      const double area = m_triangulation.area(region);
      if (!(area < m_least_area) || !is_island(region))
        continue;
      for (Index t : region)
        m_triangulation.set_inside(t, true);
      m_is_dropped.insert(m_is_dropped.end(), region.begin(), region.end());
      Index first = m_triangulation.tr().vertices[region.front()][0];
      for (Index t : region)
        for (Index v : m_triangulation.tr().vertices[t])
          first = (std::min)(first, v);
      report.dropped_islands.push_back({{m_outline.points[first].x(), m_outline.points[first].y()}, area});
    }
    std::sort(report.dropped_islands.begin(), report.dropped_islands.end(),
              [](const auto& a, const auto& b) { return a.place < b.place; });
    return without_dropped();
  }

private:
  bool is_island(const std::vector<Index>& region) const
  {
    std::vector<Index> ring; // segments
    for (Index t : region)
      for (int i = 0; i < 3; ++i) {
        const Index n = m_triangulation.neighbor(t, i), e = m_triangulation.segment(t, i);
        if (e == no_index && n == no_index)
          return false; // beyond lies the rest of the plane
        if (e == no_index)
          continue;
        if (!m_triangulation.was_inside(n))
          return false;
        for (Index v : {m_outline.segments[e].source, m_outline.segments[e].target})
          if (m_outline.is_fixed[v] || m_degree[v] != 2)
            return false;
        ring.push_back(e);
      }
    return number_of_rings(ring) == 1;
  }

  std::size_t number_of_rings(std::vector<Index> segments) const
  {
    std::size_t n = 0;
    while (!segments.empty()) {
      ++n;
      std::vector<Index> ends{m_outline.segments[segments.front()].source};
      while (!ends.empty()) { // takes away all that hangs together
        const Index v = ends.back();
        ends.pop_back();
        for (std::size_t k = 0; k < segments.size();) {
          const Outline_segment_2& s = m_outline.segments[segments[k]];
          if (s.source != v && s.target != v) {
            ++k;
            continue;
          }
          ends.push_back(s.source == v ? s.target : s.source);
          segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(k));
        }
      }
    }
    return n;
  }

  Outline_2 without_dropped() const
  {
    std::vector<char> is_dropped(m_outline.segments.size(), 0);
    for (Index t : m_is_dropped)
      for (int i = 0; i < 3; ++i)
        if (m_triangulation.segment(t, i) != no_index)
          is_dropped[m_triangulation.segment(t, i)] = 1;
    Outline_2 result = m_outline;
    result.segments.clear();
    for (std::size_t e = 0; e < is_dropped.size(); ++e)
      if (!is_dropped[e])
        result.segments.push_back(m_outline.segments[e]);
    return without_idle_vertices(result);
  }

  const Outline_2& m_outline;
  Outline_triangulation_2 m_triangulation;
  double m_least_area;
  std::vector<int> m_degree;       // segments at each vertex
  std::vector<Index> m_is_dropped; // triangles
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H
