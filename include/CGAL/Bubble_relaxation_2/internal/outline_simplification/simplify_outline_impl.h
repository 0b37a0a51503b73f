// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Forced_vertices_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/cut_segments.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/drop_islands.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/fill_gaps.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/find_spans.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/replace_spans.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/report_simplification.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/simplify_outline.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Points that no segment may pass, so that they stay in their regions: seeds, and vertices that stay, of which no
/// segment is left.
inline std::vector<Point> obstacles_of(const Outline_2& outline, const std::vector<Point>& seeds)
{
  std::vector<char> is_obstacle(outline.is_fixed);
  for (const Outline_segment_2& s : outline.segments)
    is_obstacle[s.source] = is_obstacle[s.target] = 0;
  std::vector<Point> obstacles;
  for (std::size_t v = 0; v < is_obstacle.size(); ++v)
    if (is_obstacle[v])
      obstacles.push_back(outline.points[v]);
  obstacles.insert(obstacles.end(), seeds.begin(), seeds.end());
  return obstacles;
}

/// Ends of constraints stay for the pieces' sake only, so rules do not look at them.
inline void fix_ends(Outline_2& outline, const std::vector<char>& is_end)
{
  for (std::size_t v = 0; v < outline.points.size(); ++v)
    if (outline.given[v] != no_index && is_end[outline.given[v]])
      outline.is_fixed[v] = 1;
}

/// the outline as the rules leave it
inline Outline_2 apply_rules(Outline_2 outline, const Simplification_problem_2& problem,
                             Outline_simplification_report_2& report)
{
  if (problem.options.minimum_island_area > 0)
    outline = Island_rule_2(outline, problem.options.minimum_island_area)(report);
  if (problem.options.minimum_gap > 0)
    outline = Gap_rule_2(outline, problem.options.minimum_gap)(report);
  if (std::none_of(outline.segments.begin(), outline.segments.end(),
                   [](const Outline_segment_2& s) { return s.is_in_domain(); }))
    throw std::invalid_argument("Bubble_relaxation_2: parameter minimum_gap = " +
                                in_words(problem.options.minimum_gap) + " leaves nothing of the domain");
  return outline;
}

/// \throws std::length_error if pieces would be far more than can be wanted
inline void check_number_of_pieces(const Outline_2& outline, const Outline_demands_2& demands)
{
  double n = static_cast<double>(outline.segments.size()) / Piece_fitting_2::parts_of_size;
  for (const Outline_segment_2& s : outline.segments)
    if (s.is_in_domain())
      n += distance(outline.points[s.source], outline.points[s.target]) /
           (std::min)(demands.size[s.source], demands.size[s.target]);
  check_number_of_pieces(n);
}

/// Makes one outline of the paths that replace the spans of another one.
inline Simplified_outline_2 assemble(const Outline_2& outline, const std::vector<Outline_span_2>& spans,
                                     const std::vector<Fitted_path_2>& paths)
{
  Simplified_outline_2 result;
  std::vector<Index> number(outline.points.size(), no_index); // of the outline's vertices in the result
  const auto add_vertex = [&](const Fitted_vertex_2& v) {
    const Index vertex = v.vertex != no_index ? v.vertex : index_among(outline.points, v.point); // it came back to
    if (vertex != no_index && number[vertex] != no_index)
      return number[vertex];
    const Index last = static_cast<Index>(result.points.size());
    result.points.push_back(v.point);
    result.old_vertices.push_back(vertex == no_index ? no_index : outline.given[vertex]);
    if (vertex != no_index)
      number[vertex] = last;
    return last;
  };
  for (std::size_t s = 0; s < spans.size(); ++s) {
    const Outline_span_2& span = spans[s];
    const Fitted_path_2& path = paths[s];
    Simplified_span_2& part = result.spans.emplace_back();
    for (std::size_t k = 0; k < path.size(); ++k)
      part.vertices.push_back(span.is_ring && k + 1 == path.size() ? part.vertices.front() : add_vertex(path[k]));
    for (std::size_t k = 0; k < span.size(); ++k) {
      part.origins.push_back(outline.segments[span.segments[k]].origin);
      part.is_forward.push_back(span.vertices[k] < span.vertices[k + 1]);
    }
    for (std::size_t k = 1; k < path.size(); ++k) { // stands for the old segment in the middle of its part
      const std::size_t middle = span.place(path[k - 1].segment + (path[k].segment - path[k - 1].segment) / 2);
      result.segments.push_back(
        {part.vertices[k - 1], part.vertices[k], span.inside_left, span.inside_right, part.origins[middle]});
    }
  }
  return result;
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Simplified_outline_2 simplify_outline(const Simplification_problem_2& problem)
{
  Outline_simplification_report_2 report;
  Outline_2 outline = without_idle_vertices(problem.outline);
  Outline_demands_2 demands = demands_of(outline, problem.sizes, problem.options); // checked before the rules work
  if (problem.options.has_rules()) {
    outline = apply_rules(std::move(outline), problem, report);
    demands = demands_of(outline, problem.sizes, problem.options);
  }
  fix_ends(outline, problem.is_end);
  if (const std::size_t most = problem.options.maximum_number_of_bubbles; most > 0)
    Forced_vertices_2(outline, demands, problem.sizes).check_wanted(most); // before segments are cut
  if (Outline_2 cut = with_cut_segments(outline, Even_parts_2(outline, demands.size, problem.sizes));
      cut.points.size() > outline.points.size()) {
    outline = std::move(cut);
    demands = demands_of(outline, problem.sizes, problem.options);
  }
  check_number_of_pieces(outline, demands);
  const Forced_vertices_2 forced(outline, demands, problem.sizes);
  report.wanted_vertices = forced.wanted();
  report.forced_vertices = forced.forced(report.wanted_vertices);
  report.number_of_corners = fix_corners(outline, demands, problem.options.corner_angle);
  const std::vector<Outline_span_2> spans = find_spans(outline);
  const Outline_demands_2 cautious = with_caution(demands, outline);
  const std::vector<Point> obstacles = obstacles_of(outline, problem.seeds);
  const std::vector<Fitted_path_2> paths = replace_spans(outline, spans, cautious, obstacles);
  Fidelity_check_2 check(outline, demands);
  for (std::size_t s = 0; s < spans.size(); ++s)
    check(spans[s], paths[s]);
  Simplified_outline_2 result = assemble(outline, spans, paths);
  report.largest_share_of_tolerance = check.largest_share();
  report.hausdorff_distance = distance_between(outline, demands.size, result);
  const Point& origin = problem.outline.points.front();
  report.old_area = area_of_domain(problem.outline, origin);
  report.area = area_of_domain(result, origin);
  result.report = std::move(report);
  report_pieces(problem.outline, problem.sizes, result);
  report_seeds(problem, result);
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_IMPL_H
