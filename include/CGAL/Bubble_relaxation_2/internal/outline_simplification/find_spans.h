// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FIND_SPANS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FIND_SPANS_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Cuts an outline into spans, at vertices that stay and at junctions. Where a span starts, and which way it goes, is
/// told by the order of the vertices.
class Span_search_2
{
public:
  explicit Span_search_2(const Outline_2& outline) : m_outline(outline), m_at(segments_at_vertices(outline))
  {
    for (std::size_t v = 0; v < m_at.size(); ++v)
      std::sort(m_at[v].begin(), m_at[v].end(), [&](Index e, Index f) {
        return other_end(e, static_cast<Index>(v)) < other_end(f, static_cast<Index>(v));
      });
  }

  std::vector<Outline_span_2> operator()()
  {
    std::vector<Outline_span_2> spans;
    m_is_done.assign(m_outline.segments.size(), 0);
    for (bool of_rings : {false, true})
      for (std::size_t v = 0; v < m_at.size(); ++v)
        for (Index e : m_at[v])
          if (!m_is_done[e] && (of_rings || stays(static_cast<Index>(v))))
            spans.push_back(follow(static_cast<Index>(v), e));
    return spans;
  }

private:
  bool stays(Index v) const { return m_outline.is_fixed[v] || m_at[v].size() != 2; }

  Index other_end(Index e, Index v) const { return m_outline.segments[e].other_end(v); }

  Outline_span_2 follow(Index v, Index e)
  {
    Outline_span_2 span;
    const Outline_segment_2& first = m_outline.segments[e];
    span.inside_left = first.source == v ? first.inside_left : first.inside_right;
    span.inside_right = first.source == v ? first.inside_right : first.inside_left;
    span.vertices.push_back(v);
    for (;;) {
      m_is_done[e] = 1;
      v = other_end(e, v);
      span.vertices.push_back(v);
      span.segments.push_back(e);
      if (stays(v) || v == span.vertices.front())
        break;
      e = m_at[v][0] == e ? m_at[v][1] : m_at[v][0];
    }
    span.is_ring = !stays(v);
    return span;
  }

  const Outline_2& m_outline;
  Segments_at_vertices_2 m_at; // segments, in the order of their other ends
  std::vector<char> m_is_done;
};

inline std::vector<Outline_span_2> find_spans(const Outline_2& outline) { return Span_search_2(outline)(); }

/// Finds the corners of a span: where the directions to the places at which it first leaves a disc form an angle under
/// a limit, the span is straight up to half of the tolerance on both ways there, and no other vertex of the span in the
/// disc has a smaller angle. At this scale a corner is one of the shape, not of what is rough about it.
class Corner_search_2
{
public:
  /// The discs have half of the wanted size as radius; `largest_angle` in degrees.
  Corner_search_2(const Outline_2& outline, const Outline_span_2& span, const Outline_demands_2& demands,
                  double largest_angle)
    : m_outline(outline), m_span(span), m_cosines(span.size(), -2), m_reach(span.size())
  {
    const double limit = cosine_of(largest_angle * (3.14159265358979323846 / 180));
    m_length.push_back(0);
    for (std::size_t k = 0; k < (span.is_ring ? 2 : 1) * span.size(); ++k)
      m_length.push_back(m_length.back() + distance(point(k % span.size()), point(k % span.size() + 1)));
    for (std::size_t k = first(); k < span.size(); ++k) {
      const Index v = span.vertices[k];
      find_angle(k, 0.5 * demands.size[v], 0.5 * demands.tolerance[v], limit);
    }
  }

  std::vector<Index> operator()() const
  {
    std::vector<Index> corners;
    for (std::size_t k = first(); k < m_span.size(); ++k)
      if (m_cosines[k] > -2 && is_sharpest(k))
        corners.push_back(m_span.vertices[k]);
    return corners;
  }

private:
  std::size_t first() const { return m_span.is_ring ? 0 : 1; }
  const Point& point(std::size_t k) const { return m_outline.points[m_span.vertices[k]]; }

  /// the vertex after `k`, or before it, as an index of the span; its size where it ends
  std::size_t next(std::size_t k, bool forward) const
  {
    const std::size_t n = m_span.size();
    if (m_span.is_ring)
      return forward ? (k + 1 == n ? 0 : k + 1) : (k == 0 ? n - 1 : k - 1);
    return forward ? k + 1 : k - 1;
  }

  bool is_end(std::size_t k) const { return !m_span.is_ring && (k == 0 || k == m_span.size()); }

  /// The first place outside of the disc; `center` if a ring stays within. Vertices are skipped that cannot be outside
  /// yet, as the length on the way to them tells.
  Point exit(std::size_t center, double radius, bool forward, std::size_t& reach) const
  {
    const std::size_t n = m_span.size(), most = m_span.is_ring ? n : forward ? n - center : center;
    const std::size_t start = m_span.is_ring && !forward ? center + n : center;
    const auto vertex = [&](std::size_t steps) { return forward ? start + steps : start - steps; };
    const auto length = [&](std::size_t steps) { return std::abs(m_length[vertex(steps)] - m_length[start]); };
    const auto place = [&](std::size_t steps) -> const Point& {
      return point(m_span.is_ring ? vertex(steps) % n : vertex(steps));
    };
    const Point& c = point(center);
    double r = 0;
    for (std::size_t steps = 0; steps < most;) {
      std::size_t next = steps + 1;
      for (std::size_t end = most; next < end;) { // the first one that may be outside, or the last of all
        const std::size_t middle = next + (end - next) / 2;
        if (length(middle) < length(steps) + (radius - r))
          next = middle + 1;
        else
          end = middle;
      }
      r = distance(c, place(next));
      reach = next - 1;
      if (r >= radius)
        return where_it_leaves(c, place(next - 1), place(next), radius);
      steps = next;
    }
    reach = m_span.is_ring ? most - 1 : most;
    return place(most);
  }

  static Point where_it_leaves(const Point& c, const Point& p, const Point& q, double radius)
  {
    const double dx = q.x() - p.x(), dy = q.y() - p.y(), ux = p.x() - c.x(), uy = p.y() - c.y();
    const double a = dx * dx + dy * dy, b = ux * dx + uy * dy, e = ux * ux + uy * uy - radius * radius;
    const double s = (-b + std::sqrt((std::max)(0., b * b - a * e))) / a;
    return Point(p.x() + s * dx, p.y() + s * dy);
  }

  void find_angle(std::size_t k, double radius, double tolerance, double limit)
  {
    const Point p = exit(k, radius, true, m_reach[k][0]), q = exit(k, radius, false, m_reach[k][1]), &c = point(k);
    const double lp = distance(c, p), lq = distance(c, q),
                 cosine = ((p.x() - c.x()) * (q.x() - c.x()) + (p.y() - c.y()) * (q.y() - c.y())) / (lp * lq);
    if (lp > 0 && lq > 0 && cosine > limit && is_straight(k, true, p, tolerance) && is_straight(k, false, q, tolerance))
      m_cosines[k] = cosine;
  }

  bool is_straight(std::size_t center, bool forward, const Point& exit, double tolerance) const
  {
    std::size_t k = center;
    for (std::size_t i = 0; i < m_reach[center][forward ? 0 : 1]; ++i) {
      k = next(k, forward);
      if (!(distance_to_segment(point(k), point(center), exit) <= tolerance))
        return false;
    }
    return true;
  }

  bool is_sharpest(std::size_t center) const
  {
    for (int side = 0; side < 2; ++side) {
      std::size_t k = center;
      for (std::size_t i = 0; i < m_reach[center][side]; ++i) {
        k = next(k, side == 0);
        if (is_end(k))
          break;
        if (m_cosines[k] > m_cosines[center] ||
            (m_cosines[k] == m_cosines[center] && m_span.vertices[k] < m_span.vertices[center]))
          return false;
      }
    }
    return true;
  }

  const Outline_2& m_outline;
  const Outline_span_2& m_span;
  std::vector<double> m_length;                      // of the way to each vertex; of a ring twice around
  std::vector<double> m_cosines;                     // of the angles under the limit; -2 elsewhere
  std::vector<std::array<std::size_t, 2>> m_reach;   // how many vertices on either side lie in the disc
};

/// Makes the corners of all spans vertices that stay; returns how many there are. Where a rule made a segment there is
/// no corner of the user's.
inline std::size_t fix_corners(Outline_2& outline, const Outline_demands_2& demands, double largest_angle)
{
  std::vector<Index> corners;
  for (const Outline_span_2& span : find_spans(outline)) {
    const std::vector<Index> found = Corner_search_2(outline, span, demands, largest_angle)();
    corners.insert(corners.end(), found.begin(), found.end());
  }
  std::vector<char> is_of_rule(outline.points.size(), 0);
  for (const Outline_segment_2& s : outline.segments)
    if (s.origin == no_index)
      is_of_rule[s.source] = is_of_rule[s.target] = 1;
  corners.erase(std::remove_if(corners.begin(), corners.end(), [&](Index v) { return is_of_rule[v] != 0; }),
                corners.end());
  for (Index v : corners)
    outline.is_fixed[v] = 1;
  return corners.size();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_FIND_SPANS_H
