// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_CUT_SEGMENTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_CUT_SEGMENTS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Segment_grid_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Which segments of the domain that are longer than `length` have another one nearer than `reach`: the domain can be
/// narrow beside these only. One that they meet in a vertex counts where the angle is acute.
inline std::vector<char> segments_near_others(const Outline_2& outline, double reach, double length)
{
  const std::vector<Outline_segment_2>& segments = outline.segments;
  const auto point = [&outline](Index v) -> const Point& { return outline.points[v]; };
  const auto are_near = [&](const Outline_segment_2& s, const Outline_segment_2& t) {
    for (Index u : {s.source, s.target})
      for (Index v : {t.source, t.target})
        if (u == v)
          return CGAL::angle(point(s.source + s.target - u), point(u), point(t.source + t.target - u)) == ACUTE;
    const auto is_near = [&](Index v, const Outline_segment_2& to) {
      return distance_to_segment(point(v), point(to.source), point(to.target)) < reach;
    };
    return is_near(s.source, t) || is_near(s.target, t) || is_near(t.source, s) || is_near(t.target, s);
  };
  Segment_grid_2 grid;
  for (const Outline_segment_2& s : segments)
    grid.insert(point(s.source), point(s.target), reach);
  std::vector<char> result(segments.size(), 0);
  for (std::size_t e = 0; e < segments.size(); ++e) {
    const Outline_segment_2& s = segments[e];
    if (!s.is_in_domain() || distance(point(s.source), point(s.target)) <= length)
      continue;
    const Bbox_2 b = grid.box(static_cast<Index>(e)),
                 around(b.xmin() - reach, b.ymin() - reach, b.xmax() + reach, b.ymax() + reach);
    grid.for_each_near(around, [&](Index other) {
      result[e] = result[e] || (other != static_cast<Index>(e) && are_near(s, segments[other]));
    });
  }
  return result;
}

/// The outline with segments cut at `points_on(e)`, from the source of the segment `e` to its target.
template <class Points_on>
Outline_2 with_cut_segments(const Outline_2& outline, const Points_on& points_on)
{
  std::vector<std::pair<Point, Index>> points; // and the vertex, or behind these the new one
  for (std::size_t v = 0; v < outline.points.size(); ++v)
    points.emplace_back(outline.points[v], static_cast<Index>(v));
  Outline_2 cut;
  for (std::size_t e = 0; e < outline.segments.size(); ++e) {
    Outline_segment_2 s = outline.segments[e];
    const Index target = s.target;
    for (const Point& p : points_on(e)) {
      s.target = static_cast<Index>(points.size());
      points.emplace_back(p, s.target);
      cut.segments.push_back(s);
      s.source = s.target;
    }
    s.target = target;
    cut.segments.push_back(s);
  }
  std::sort(points.begin(), points.end());
  std::vector<Index> number(points.size());
  for (const auto& p : points) {
    number[p.second] = static_cast<Index>(cut.points.size());
    const bool is_old = static_cast<std::size_t>(p.second) < outline.points.size();
    cut.points.push_back(p.first);
    cut.is_fixed.push_back(is_old && outline.is_fixed[p.second]);
    cut.given.push_back(is_old ? outline.given[p.second] : no_index);
  }
  for (Outline_segment_2 s : std::exchange(cut.segments, {})) {
    s.source = number[s.source];
    s.target = number[s.target];
    cut.add(s);
  }
  cut.sort_segments();
  return cut;
}

/// Cuts segments in halves until d between their ends is what it is at these, and they are no longer than some hundred
/// pieces.
class Even_parts_2
{
public:
  Even_parts_2(const Outline_2& outline, const std::vector<double>& size_at_vertices, const Sizes_2& sizes)
    : m_outline(outline), m_size(size_at_vertices), m_sizes(sizes)
  {}

  /// where a segment is cut, from its source to its target
  std::vector<Point> operator()(std::size_t e) const
  {
    const Outline_segment_2& s = m_outline.segments[e];
    std::vector<Point> cuts;
    cut(m_outline.points[s.source], m_outline.points[s.target], m_size[s.source], m_size[s.target], 0, cuts);
    return cuts;
  }

private:
  bool cut(const Point& a, const Point& b, double at_a, double at_b, int depth, std::vector<Point>& cuts) const
  {
    constexpr double short_part = 2, long_part = 256, even = 0.1; // in units of d
    constexpr int deepest = 24;
    const double length = distance(a, b);
    if (length <= short_part * (std::min)(at_a, at_b) || depth == deepest)
      return false;
    const Point m = CGAL::midpoint(a, b);
    const double at_m = m_sizes(m);
    const std::size_t before = cuts.size();
    const bool is_cut_before = cut(a, m, at_a, at_m, depth + 1, cuts);
    cuts.push_back(m);
    const bool is_cut_behind = cut(m, b, at_m, at_b, depth + 1, cuts);
    if (is_cut_before || is_cut_behind || length > long_part * at_m ||
        std::abs(at_m - 0.5 * (at_a + at_b)) > even * at_m)
      return true;
    cuts.resize(before);
    return false;
  }

  const Outline_2& m_outline;
  const std::vector<double>& m_size;
  const Sizes_2& m_sizes;
};

/// Joins parts of a segment between which nothing else ends: what follows takes time for each vertex.
inline Outline_2 with_joined_parts(const Outline_2& cut)
{
  std::vector<boost::container::small_vector<Index, 2>> at(cut.points.size()); // segments
  for (std::size_t e = 0; e < cut.segments.size(); ++e)
    for (Index v : {cut.segments[e].source, cut.segments[e].target})
      at[v].push_back(static_cast<Index>(e));
  const auto origin = [&cut](Index e) { return cut.segments[e].origin; };
  const auto joins_parts = [&](Index v) {
    return cut.given[v] == no_index && !cut.is_fixed[v] && at[v].size() == 2 && origin(at[v][0]) != no_index &&
           origin(at[v][0]) == origin(at[v][1]);
  };
  std::vector<char> is_done(cut.segments.size(), 0);
  const auto end_of_parts = [&](Index e, Index v) { // from a part on over its end `v`
    while (joins_parts(v)) {
      e = at[v][0] == e ? at[v][1] : at[v][0];
      is_done[e] = 1;
      v = cut.segments[e].source == v ? cut.segments[e].target : cut.segments[e].source;
    }
    return v;
  };
  Outline_2 joined = cut;
  joined.segments.clear();
  for (std::size_t e = 0; e < cut.segments.size(); ++e) {
    if (is_done[e])
      continue;
    Outline_segment_2 s = cut.segments[e];
    s.source = end_of_parts(static_cast<Index>(e), s.source);
    s.target = end_of_parts(static_cast<Index>(e), s.target);
    joined.add(s);
  }
  joined.sort_segments();
  return without_idle_vertices(joined);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_CUT_SEGMENTS_H
