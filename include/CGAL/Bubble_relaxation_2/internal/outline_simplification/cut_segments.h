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
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Segment_grid_2.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// From where to where along a segment, as distances from its source.
using Stretch = std::pair<double, double>;

/// A stretch of the segment from `a` to `b` outside of which the one from `c` to `d` is not nearer than `reach`; maybe
/// empty.
inline Stretch stretch_near(const Point& a, const Point& b, const Point& c, const Point& d, double reach)
{
  const double length = distance(a, b);
  const Kernel::Vector_2 along = (b - a) / length;
  const double x_c = along * (c - a), x_d = along * (d - a);
  const double y_c = CGAL::determinant(along, c - a), y_d = CGAL::determinant(along, d - a);
  double first = 0, last = std::abs(y_c) < reach ? 1 : 0; // of the way from `c` to `d`, what is so near to the line
  if (y_c != y_d) {
    const double enters = (-reach - y_c) / (y_d - y_c), leaves = (reach - y_c) / (y_d - y_c);
    first = (std::max)(0., (std::min)(enters, leaves));
    last = (std::min)(1., (std::max)(enters, leaves));
  }
  if (first >= last)
    return {0, 0};
  const double x_first = x_c + first * (x_d - x_c), x_last = x_c + last * (x_d - x_c);
  return {(std::max)(0., (std::min)(x_first, x_last) - reach), (std::min)(length, (std::max)(x_first, x_last) + reach)};
}

/// Of each segment of the domain that is longer than `length` the stretches, in order and apart, where another one is
/// nearer than `reach`: the domain can be narrow beside these only. One that they meet in a vertex counts where the
/// angle is acute.
inline std::vector<std::vector<Stretch>> stretches_near_others(const Outline_2& outline, double reach, double length)
{
  const std::vector<Outline_segment_2>& segments = outline.segments;
  const auto point = [&outline](Index v) -> const Point& { return outline.points[v]; };
  const auto meet_bluntly = [&](const Outline_segment_2& s, const Outline_segment_2& t) {
    for (Index u : {s.source, s.target})
      for (Index v : {t.source, t.target})
        if (u == v)
          return CGAL::angle(point(s.other_end(u)), point(u), point(t.other_end(u))) != ACUTE;
    return false;
  };
  Segment_grid_2 grid;
  for (const Outline_segment_2& s : segments)
    grid.insert(point(s.source), point(s.target), reach);
  std::vector<std::vector<Stretch>> result(segments.size());
  for (std::size_t e = 0; e < segments.size(); ++e) {
    const Outline_segment_2& s = segments[e];
    const Point &a = point(s.source), &b = point(s.target);
    if (!s.is_in_domain() || distance(a, b) <= length)
      continue;
    std::vector<Stretch> near;
    const Bbox_2 box = grid.box(static_cast<Index>(e));
    grid.for_each_near(
      a, b, reach, {box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach}, [&](Index other) {
        const Outline_segment_2& t = segments[other];
        if (other != static_cast<Index>(e) && !meet_bluntly(s, t))
          near.push_back(stretch_near(a, b, point(t.source), point(t.target), reach));
      });
    std::sort(near.begin(), near.end());
    for (const Stretch& part : near)
      if (std::vector<Stretch>& united = result[e]; !united.empty() && part.first <= united.back().second)
        united.back().second = (std::max)(united.back().second, part.second);
      else if (part.first < part.second)
        united.push_back(part);
  }
  return result;
}

/// The outline with segments cut at `points_on(e)`, from the source of the segment `e` to its target.
template <class Points_on>
Outline_2 with_cut_segments(const Outline_2& outline, Points_on&& points_on)
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

/// \throws std::length_error if pieces of the outline would be far more than can be wanted
inline void check_number_of_pieces(double n)
{
  constexpr double most = 2e6; // three gigabytes of places where they may end
  if (!(n < most))
    throw std::length_error("Bubble_relaxation_2: sizing_function asks for about " + in_words(std::round(n)) +
                            " pieces of the outline, or more");
}

/// Cuts segments in halves until d between their ends is what it is at these, which is about the same, and they are no
/// longer than some hundred pieces. Segments outside of the domain stay as they are.
class Even_parts_2
{
public:
  Even_parts_2(const Outline_2& outline, const std::vector<double>& size_at_vertices, const Sizes_2& sizes)
    : m_outline(outline), m_size(size_at_vertices), m_sizes(sizes)
  {}

  /// where a segment is cut, from its source to its target
  /// \throws std::length_error if d asks for far more pieces than can be wanted
  std::vector<Point> operator()(std::size_t e)
  {
    const Outline_segment_2& s = m_outline.segments[e];
    std::vector<Point> cuts;
    if (!s.is_in_domain())
      return cuts;
    cut(m_outline.points[s.source], m_outline.points[s.target], m_size[s.source], m_size[s.target], 0, cuts);
    return cuts;
  }

private:
  bool cut(const Point& a, const Point& b, double at_a, double at_b, int depth, std::vector<Point>& cuts)
  {
    constexpr double short_part = 2, long_part = 256, even = 0.1, about = 2; // in units of d
    constexpr int deepest = 24;
    const double length = distance(a, b);
    if (length <= short_part * (std::min)(at_a, at_b) || depth == deepest) {
      m_pieces += length / (std::min)(at_a, at_b);
      check_number_of_pieces(m_pieces);
      return false;
    }
    const Point m = CGAL::midpoint(a, b);
    const double at_m = m_sizes(m);
    const std::size_t before = cuts.size();
    const bool is_cut_before = cut(a, m, at_a, at_m, depth + 1, cuts);
    cuts.push_back(m);
    const bool is_cut_behind = cut(m, b, at_m, at_b, depth + 1, cuts);
    if (is_cut_before || is_cut_behind || length > long_part * at_m ||
        std::abs(at_m - 0.5 * (at_a + at_b)) > even * at_m || (std::max)(at_a, at_b) > about * (std::min)(at_a, at_b))
      return true;
    cuts.resize(before);
    return false;
  }

  const Outline_2& m_outline;
  const std::vector<double>& m_size;
  const Sizes_2& m_sizes;
  double m_pieces = 0; // so far
};

/// Joins parts of a segment between which nothing else ends: what follows takes time for each vertex.
inline Outline_2 with_joined_parts(const Outline_2& cut)
{
  const auto at = segments_at_vertices(cut);
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
      v = cut.segments[e].other_end(v);
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
