// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/find_spans.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The rule `minimum_island_area`: takes small islands into the domain. An island is a ring with the domain all around
/// it and none within, and nothing else: no vertex that stays, no other constraint.
class Island_rule_2
{
public:
  /// \pre there are no idle vertices but those that stay
  Island_rule_2(const Outline_2& outline, double least_area) : m_outline(outline), m_least_area(least_area) {}

  Outline_2 operator()(Outline_simplification_report_2& report) const
  {
    std::vector<char> is_dropped(m_outline.segments.size(), 0);
    for (const Outline_span_2& span : find_spans(m_outline)) {
      const double area = area_within(span);
      const bool is_inside = area > 0 ? span.inside_left : span.inside_right,
                 is_around = area > 0 ? span.inside_right : span.inside_left; // the domain
      if (!span.is_ring || is_inside || !is_around || !(std::abs(area) < m_least_area) || has_something_within(span))
        continue;
      for (Index e : span.segments)
        is_dropped[e] = 1;
      const Point& first = m_outline.points[*std::min_element(span.vertices.begin(), span.vertices.end())];
      report.dropped_islands.push_back({{first.x(), first.y()}, std::abs(area)});
    }
    std::sort(report.dropped_islands.begin(), report.dropped_islands.end(),
              [](const auto& a, const auto& b) { return a.place < b.place; });
    Outline_2 result = m_outline;
    result.segments.clear();
    for (std::size_t e = 0; e < is_dropped.size(); ++e)
      if (!is_dropped[e])
        result.segments.push_back(m_outline.segments[e]);
    return without_idle_vertices(result);
  }

private:
  const Point& point(const Outline_span_2& span, std::size_t k) const { return m_outline.points[span.vertices[k]]; }

  /// positive if the ring goes around counterclockwise
  double area_within(const Outline_span_2& span) const
  {
    const Point& o = point(span, 0);
    double twice = 0;
    for (std::size_t k = 1; k < span.size(); ++k) {
      const Point &p = point(span, k), &q = point(span, k + 1);
      twice += (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
    }
    return twice / 2;
  }

  /// whether another vertex lies in a ring; vertices are sorted by x, so few are asked
  bool has_something_within(const Outline_span_2& span) const
  {
    Bbox_2 box;
    for (Index v : span.vertices)
      box += m_outline.points[v].bbox();
    std::vector<Index> ring = span.vertices;
    std::sort(ring.begin(), ring.end());
    constexpr double lowest = -(std::numeric_limits<double>::infinity)();
    const auto first = std::lower_bound(m_outline.points.begin(), m_outline.points.end(), Point(box.xmin(), lowest));
    for (auto p = first; p != m_outline.points.end() && p->x() <= box.xmax(); ++p)
      if (box.ymin() <= p->y() && p->y() <= box.ymax() &&
          !std::binary_search(ring.begin(), ring.end(), static_cast<Index>(p - m_outline.points.begin())) &&
          is_within(span, *p))
        return true;
    return false;
  }

  bool is_within(const Outline_span_2& ring, const Point& p) const
  {
    bool is_within = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const bool upward = point(ring, k).y() <= point(ring, k + 1).y();
      const Point &low = point(ring, upward ? k : k + 1), &high = point(ring, upward ? k + 1 : k);
      if (low.y() <= p.y() && p.y() < high.y() && CGAL::orientation(low, high, p) == LEFT_TURN)
        is_within = !is_within;
    }
    return is_within;
  }

  const Outline_2& m_outline;
  double m_least_area;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_DROP_ISLANDS_H
