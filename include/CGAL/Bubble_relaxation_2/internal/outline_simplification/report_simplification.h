// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPORT_SIMPLIFICATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPORT_SIMPLIFICATION_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/outline_distance.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Checks, exactly, that paths are within the tolerance of the spans that they replace, and these of them: all vertices
/// of either near to the segment of the other that they belong to. What is between vertices is near then as well, since
/// a segment is convex, and the span is connected.
class Fidelity_check_2
{
public:
  Fidelity_check_2(const Outline_2& outline, const Outline_demands_2& tolerances)
      : m_outline(outline), m_demands(tolerances)
  {
  }

  /// \throws std::runtime_error if a path is not
  void operator()(const Outline_span_2& span, const Fitted_path_2& path)
  {
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Index segment = path[k].segment;
      const bool is_last = !span.is_ring && static_cast<std::size_t>(segment) == span.size();
      const Index a = span.vertex(segment), b = is_last ? a : span.vertex(segment + 1);
      check(path[k].point, m_outline.points[a], m_outline.points[b],
            (std::min)(m_demands.tolerance[a], m_demands.tolerance[b]));
      if (k == 0)
        continue;
      for (Index m = path[k - 1].segment + 1; m <= segment; ++m)
        check(m_outline.points[span.vertex(m)], path[k - 1].point, path[k].point, m_demands.tolerance[span.vertex(m)]);
    }
  }

  double largest_share() const { return m_largest_share; }

private:
  void check(const Point& p, const Point& a, const Point& b, double tolerance)
  {
    if (p == a || p == b)
      return;
    const double square = std::nextafter(tolerance * tolerance, 0.);
    const bool is_near = a == b
                           ? CGAL::compare_squared_distance(p, a, square) != LARGER
                           : Kernel().compare_squared_distance_2_object()(p, Kernel::Segment_2(a, b), square) != LARGER;
    if (!is_near)
      throw std::runtime_error("Bubble_relaxation_2: the new outline is too far from the old one at " +
                               in_words(p.x(), p.y()) + "; please report this");
    m_largest_share = (std::max)(m_largest_share, distance_to_segment(p, a, b) / tolerance);
  }

  const Outline_2& m_outline;
  const Outline_demands_2& m_demands; // with whole tolerances
  double m_largest_share = 0;
};

/// The area of the domain within an outline, by triangles that its segments form with any point, `origin`. Its bits do
/// not depend on the order of segments.
template <class Outline>
double area_of_domain(const Outline& outline, const Point& origin)
{
  std::vector<double> terms;
  for (const Outline_segment_2& s : outline.segments)
    if (s.inside_left != s.inside_right) {
      const double area = CGAL::area(origin, outline.points[s.source], outline.points[s.target]);
      terms.push_back(s.inside_left ? area : -area);
    }
  std::sort(terms.begin(), terms.end());
  return std::accumulate(terms.begin(), terms.end(), 0.);
}

/// what is outside of the domain stays and does not count
inline std::size_t number_of_domain_segments(const std::vector<Outline_segment_2>& segments)
{
  return static_cast<std::size_t>(
    std::count_if(segments.begin(), segments.end(), [](const Outline_segment_2& s) { return s.is_in_domain(); }));
}

/// the lengths of pieces in the report, and what they stand for
inline void report_pieces(const Outline_2& given, const Sizes_2& sizes, Simplified_outline_2& result)
{
  auto& report = result.report;
  const auto place = [](const Point& p) { return Outline_simplification_report_2::Place{p.x(), p.y()}; };
  std::size_t fitting = 0;
  report.number_of_old_segments = number_of_domain_segments(given.segments);
  report.number_of_segments = number_of_domain_segments(result.segments);
  report.shortest_piece = (std::numeric_limits<double>::infinity)();
  for (const Outline_segment_2& s : result.segments) {
    const Point &a = result.points[s.source], &b = result.points[s.target];
    const bool is_new = s.origin == no_index;
    const Point &c = is_new ? a : given.points[given.segments[s.origin].source],
                &d = is_new ? b : given.points[given.segments[s.origin].target];
    report.pieces.push_back({place(a), place(b), place(c), place(d), is_new});
    if (!s.is_in_domain())
      continue;
    const Point middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
    const double length = distance(a, b) / sizes(middle);
    fitting += length >= 0.6 && length <= 1.5;
    if (length < report.shortest_piece) {
      report.shortest_piece = length;
      report.shortest_place = place(middle);
    }
  }
  report.share_of_fitting_pieces = static_cast<double>(fitting) / static_cast<double>(report.number_of_segments);
}

/// On which side of the boundary of the domain points are, as the parity of the boundary segments below each tells. A
/// point above a common end of two segments is taken for one a little to the right of it.
inline std::vector<Bounded_side> sides_of_boundary(const Simplified_outline_2& outline,
                                                   const std::vector<Point>& points)
{
  std::vector<Index> order = indices_below(points.size());
  std::sort(order.begin(), order.end(), [&](Index k, Index l) { return points[k].x() < points[l].x(); });
  std::vector<Bounded_side> sides(points.size(), ON_UNBOUNDED_SIDE);
  for (const Outline_segment_2& s : outline.segments) {
    if (s.inside_left == s.inside_right)
      continue;
    const Point &a = outline.points[s.source], &b = outline.points[s.target], &left = (std::min)(a, b),
                &right = (std::max)(a, b);
    const auto first = std::lower_bound(order.begin(), order.end(), left.x(),
                                        [&](Index k, double x) { return points[k].x() < x; });
    for (auto k = first; k != order.end() && points[*k].x() <= right.x(); ++k) {
      const Point& p = points[*k];
      const Orientation turn = CGAL::orientation(left, right, p);
      if (turn == COLLINEAR && left <= p && p <= right)
        sides[*k] = ON_BOUNDARY;
      else if (turn == LEFT_TURN && p.x() < right.x())
        sides[*k] = static_cast<Bounded_side>(-sides[*k]); // ON_BOUNDARY, which is 0, remains
    }
  }
  return sides;
}

/// The seeds that are still in regions of their kind: a rule may have taken the region away, or have left a seed on the
/// boundary, where it tells nothing.
inline void report_seeds(const Simplification_problem_2& problem, Simplified_outline_2& result)
{
  const bool is_changed = !result.report.dropped_islands.empty() || !result.report.filled_gaps.empty();
  const std::vector<Bounded_side> sides = sides_of_boundary(result, problem.seeds);
  const Bounded_side wanted = problem.seeds_are_in_domain ? ON_BOUNDED_SIDE : ON_UNBOUNDED_SIDE;
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (!is_changed || sides[k] == wanted)
      result.report.seeds.push_back({problem.seeds[k].x(), problem.seeds[k].y()});
}

/// adds a segment, in halves until they are no longer than `longest`
inline void add_halves(const Point& a, const Point& b, double longest, One_sided_distance_2::Segments& halves)
{
  if (distance(a, b) <= longest) {
    halves.emplace_back(a, b);
    return;
  }
  const Point middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
  add_halves(a, middle, longest, halves);
  add_halves(middle, b, longest, halves);
}

/// The two-sided Hausdorff distance between the outline that was replaced and the new one, up to a relative error.
/// What is outside of the domain is in both, so none of it is far from the other one.
inline double distance_between(const Outline_2& outline, const std::vector<double>& size_at_vertices,
                               const Simplified_outline_2& result)
{
  constexpr double longest = 4; // of what is looked at at once, in units of d: near to it are few pieces
  One_sided_distance_2::Segments old, halves, pieces, all_pieces;
  for (const Outline_segment_2& s : outline.segments) {
    const Point &a = outline.points[s.source], &b = outline.points[s.target];
    old.emplace_back(a, b);
    if (s.is_in_domain())
      add_halves(a, b, longest * (std::min)(size_at_vertices[s.source], size_at_vertices[s.target]), halves);
  }
  for (const Outline_segment_2& s : result.segments) {
    all_pieces.emplace_back(result.points[s.source], result.points[s.target]);
    if (s.is_in_domain())
      pieces.push_back(all_pieces.back());
  }
  const double least_size = *std::min_element(size_at_vertices.begin(), size_at_vertices.end());
  const double from_old = One_sided_distance_2(all_pieces, least_size)(halves, 0);
  return One_sided_distance_2(old, least_size)(pieces, from_old); // not less than it is
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPORT_SIMPLIFICATION_H
