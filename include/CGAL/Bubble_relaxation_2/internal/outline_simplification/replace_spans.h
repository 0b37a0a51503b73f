// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPLACE_SPANS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPLACE_SPANS_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Movable_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Path_improvement_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Piece_fitting_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Span_replacement_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Wall_search_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

constexpr int sweeps_of_improvement = 6;

/// how far the new outline may be from the old one at a point
/// \throws std::invalid_argument if that is no more than roundings
inline double tolerance_at(const Point& p, double size, const Simplification_options& options)
{
  const double share = options.relative_tolerance * size, tolerance = (std::min)(options.tolerance, share),
               largest = (std::max)(std::abs(p.x()), std::abs(p.y()));
  if (tolerance > 1e-12 * largest && std::isfinite(tolerance))
    return tolerance;
  const std::string parameter =
    options.tolerance <= share
      ? "outline_tolerance = " + in_words(options.tolerance)
      : "relative_outline_tolerance = " + in_words(options.relative_tolerance) + " of d = " + in_words(size);
  throw std::invalid_argument("Bubble_relaxation_2: parameter " + parameter +
                              " must give a finite tolerance that is greater than the rounding of coordinates at " +
                              in_words(p.x(), p.y()));
}

/// of each vertex whether it is of segments outside of the domain only
inline std::vector<char> are_outside(const Outline_2& outline)
{
  std::vector<char> result(outline.points.size(), 0);
  for (const bool is_in_domain : {false, true})
    for (const Outline_segment_2& s : outline.segments)
      if (s.is_in_domain() == is_in_domain)
        result[s.source] = result[s.target] = !is_in_domain;
  return result;
}

/// Sizes and tolerances at the vertices. Outside of the domain, where d may be anything, the least ones do: what is
/// there stays.
inline Outline_demands_2 demands_of(const Outline_2& outline, const Sizes_2& sizes,
                                    const Simplification_options& options)
{
  constexpr double none = (std::numeric_limits<double>::infinity)();
  const std::vector<char> is_outside = are_outside(outline);
  Outline_demands_2 result{std::vector<double>(is_outside.size(), none), std::vector<double>(is_outside.size(), none)};
  for (std::size_t v = 0; v < is_outside.size(); ++v)
    if (!is_outside[v]) {
      result.size[v] = sizes(outline.points[v]);
      result.tolerance[v] = tolerance_at(outline.points[v], result.size[v], options);
    }
  for (std::vector<double>* demands : {&result.size, &result.tolerance})
    std::replace(demands->begin(), demands->end(), none, *std::min_element(demands->begin(), demands->end()));
  return result;
}

/// The same with tolerances that leave room for roundings.
inline Outline_demands_2 with_caution(Outline_demands_2 demands, const Outline_2& outline)
{
  for (std::size_t v = 0; v < demands.tolerance.size(); ++v) {
    const double largest = (std::max)(std::abs(outline.points[v].x()), std::abs(outline.points[v].y()));
    demands.tolerance[v] -= 1e-6 * demands.tolerance[v] + 16 * std::numeric_limits<double>::epsilon() * largest;
  }
  return demands;
}

/// the paths that take the places of the spans; those outside of the domain stay
/// \param obstacles points that no span may pass
inline std::vector<Fitted_path_2> replace_spans(const Outline_2& outline, const std::vector<Outline_span_2>& spans,
                                                const Outline_demands_2& demands, const std::vector<Point>& obstacles)
{
  Movable_outline_2 movable;
  std::vector<std::vector<Index>> ids(spans.size());
  for (std::size_t s = 0; s < spans.size(); ++s)
    for (std::size_t k = 0; k < spans[s].size(); ++k)
      ids[s].push_back(movable.insert(outline.points[spans[s].vertices[k]], outline.points[spans[s].vertices[k + 1]],
                                      demands.size[spans[s].vertices[k]]));
  const double least_size = *std::min_element(demands.size.begin(), demands.size.end());
  for (const Point& p : obstacles)
    movable.insert(p, p, least_size);
  std::vector<Fitted_path_2> paths(spans.size());
  std::vector<Index> order = indices_below(spans.size()); // long ones first, since they have more to gain
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return spans[a].size() > spans[b].size(); });
  for (Index s : order) {
    if (!spans[s].is_in_domain()) {
      paths[s] = path_along(outline, spans[s]);
      continue;
    }
    Span_replacement_2 replacement(outline, spans[s], demands, ids[s], movable);
    paths[s] = replacement(Piece_fitting_2(outline, spans[s], demands));
    ids[s] = replacement.ids();
  }
  const std::vector<char> is_wall = Wall_search_2(outline, demands.size)();
  std::vector<char> is_done(spans.size(), 0);
  for (int sweep = 0; sweep < sweeps_of_improvement; ++sweep)
    for (Index s : order)
      if (!is_done[s])
        is_done[s] = !Path_improvement_2(outline, spans[s], demands, is_wall, movable, paths[s], ids[s])();
  return paths;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_REPLACE_SPANS_H
