// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/Bbox_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A segment of an outline, and the sides on which the domain lies. `origin`: the segment of the user's outline that it
/// stands for, `no_index` if a rule made it
struct Outline_segment_2
{
  Index source, target;
  bool inside_left, inside_right;
  Index origin;

  bool is_in_domain() const { return inside_left || inside_right; }
  Index other_end(Index v) const { return source == v ? target : source; }
};

/// Segments that meet in vertices only. Vertices are numbered in the lexicographic order of their points, so that
/// nothing depends on the order in which the user inserted them.
struct Outline_2
{
  std::vector<Point> points;
  std::vector<char> is_fixed; ///< of each vertex whether it is to stay, whatever the rules do
  std::vector<Index> given;   ///< the number that each vertex has in the user's outline, `no_index` if it is not of it
  std::vector<Outline_segment_2> segments;

  /// a segment whose ends are in any order
  void add(Outline_segment_2 s)
  {
    if (s.target < s.source) {
      std::swap(s.source, s.target);
      std::swap(s.inside_left, s.inside_right);
    }
    segments.push_back(s);
  }

  void sort_segments()
  {
    std::sort(segments.begin(), segments.end(), [](const Outline_segment_2& s, const Outline_segment_2& t) {
      return s.source != t.source ? s.source < t.source : s.target < t.target;
    });
  }
};

/// the segments at each vertex, nearly always two
using Segments_at_vertices_2 = std::vector<boost::container::small_vector<Index, 2>>;

/// in their order
inline Segments_at_vertices_2 segments_at_vertices(const Outline_2& outline)
{
  Segments_at_vertices_2 result(outline.points.size());
  for (std::size_t e = 0; e < outline.segments.size(); ++e)
    for (Index v : {outline.segments[e].source, outline.segments[e].target})
      result[v].push_back(static_cast<Index>(e));
  return result;
}

/// The outline without vertices that are of no segment, unless they are to stay. Else those of a mesh, or of an island
/// that is gone, would be taken for something that the domain is narrow beside.
inline Outline_2 without_idle_vertices(const Outline_2& outline)
{
  std::vector<char> is_kept(outline.is_fixed);
  for (const Outline_segment_2& s : outline.segments)
    is_kept[s.source] = is_kept[s.target] = 1;
  Outline_2 result;
  std::vector<Index> number(is_kept.size(), no_index);
  for (std::size_t v = 0; v < is_kept.size(); ++v)
    if (is_kept[v]) {
      number[v] = static_cast<Index>(result.points.size());
      result.points.push_back(outline.points[v]);
      result.is_fixed.push_back(outline.is_fixed[v]);
      result.given.push_back(outline.given[v]);
    }
  result.segments = outline.segments;
  for (Outline_segment_2& s : result.segments) {
    s.source = number[s.source];
    s.target = number[s.target];
  }
  return result;
}

/// First few, far from each other in a given order, then twice as many in each round, those in between. Points that come
/// along a line would be joined by edges to all that are there on the other side of the domain.
inline std::vector<Index> in_rounds(const std::vector<Index>& order)
{
  std::vector<Index> result(order.begin(), order.begin() + (order.empty() ? 0 : 1));
  std::size_t step = 1;
  while (step < order.size())
    step *= 2;
  for (step /= 2; step > 0; step /= 2)
    for (std::size_t k = step; k < order.size(); k += 2 * step)
      result.push_back(order[k]);
  return result;
}

/// An outline as it is triangulated: its vertices in an order in which each is near to the one before, so that there
/// are no long walks; which triangles come about depends on it where four vertices are on a circle only.
struct Ordered_outline_2
{
  std::vector<Index> order; ///< of the points the vertices
  std::vector<Point> points;
  std::vector<Domain_edge_2> edges; ///< the segments
};

inline Ordered_outline_2 along_curve(const Outline_2& outline)
{
  Ordered_outline_2 result;
  const Hilbert_curve_2 curve(bbox_2(outline.points.begin(), outline.points.end()));
  result.order = in_rounds(hilbert_order(curve, outline.points));
  for (Index v : result.order)
    result.points.push_back(outline.points[v]);
  const std::vector<Index> number = inverse(result.order);
  for (const Outline_segment_2& s : outline.segments)
    result.edges.push_back({number[s.source], number[s.target], s.inside_left, s.inside_right});
  return result;
}

/// What is asked at the vertices of an outline: the wanted length of pieces, and how far they may be from it.
struct Outline_demands_2
{
  std::vector<double> size, tolerance;
};

/// A part of the outline that is replaced as a whole: the vertices from one that stays to the next that does. A ring
/// without one that stays has its first vertex at its end again.
struct Outline_span_2
{
  std::vector<Index> vertices;
  std::vector<Index> segments; ///< of the outline, one less than `vertices`
  bool is_ring = false;
  bool inside_left = false, inside_right = false; ///< seen from the first vertex to the last

  std::size_t size() const { return segments.size(); }
  bool is_in_domain() const { return inside_left || inside_right; }

  /// the place of a segment in `segments`; a ring goes on around from both ends
  std::size_t place(Index segment) const
  {
    const Index n = static_cast<Index>(size());
    return static_cast<std::size_t>(is_ring ? (segment % n + n) % n : segment);
  }

  /// the first vertex of a segment, or the last of the span
  Index vertex(Index segment) const { return vertices[place(segment)]; }
};

/// A vertex of what replaces a span. It belongs to a place on the segment `segment` of the span; the points of the span
/// between two such places belong to the piece between the two vertices.
struct Fitted_vertex_2
{
  Point point;
  Index segment;
  Index vertex;            ///< of the outline, if it is one of those, else `no_index`
  bool is_settled = false; ///< it cannot move, nor go, while its neighbours stay
};

using Fitted_path_2 = std::vector<Fitted_vertex_2>;

/// a span as it is
inline Fitted_path_2 path_along(const Outline_2& outline, const Outline_span_2& span)
{
  Fitted_path_2 path;
  for (std::size_t k = 0; k <= span.size(); ++k)
    path.push_back({outline.points[span.vertices[k]], static_cast<Index>(k), span.vertices[k]});
  return path;
}

inline double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

/// the point of the segment from `a` to `b` that is nearest to `p`
inline Point nearest_on_segment(const Point& p, const Point& a, const Point& b)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), l = dx * dx + dy * dy;
  const double s = l > 0 ? ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / l : 0;
  return s <= 0 ? a : s >= 1 ? b : Point(a.x() + s * dx, a.y() + s * dy);
}

inline double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  return distance(p, nearest_on_segment(p, a, b));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_2_H
