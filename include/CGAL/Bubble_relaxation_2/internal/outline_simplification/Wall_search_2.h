// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WALL_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WALL_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Which segments are of walls, straight over at least ten pieces: sides of a box or the like, that give way to nothing,
/// wherever spans begin and end.
class Wall_search_2
{
public:
  /// `size`: at the vertices
  Wall_search_2(const Outline_2& outline, const std::vector<double>& size)
    : m_outline(outline), m_size(size), m_at(segments_at_vertices(outline))
  {}

  std::vector<char> operator()()
  {
    constexpr double long_wall = 10;
    std::vector<char> is_wall(m_outline.segments.size(), 0), is_seen(is_wall);
    const auto judge = [&] {
      const bool is_long = number_of_pieces() >= long_wall;
      for (Index part : m_segments) {
        is_seen[part] = 1;
        is_wall[part] = is_wall[part] || is_long;
      }
    };
    for (std::size_t e = 0; e < is_wall.size(); ++e) {
      if (is_seen[e])
        continue;
      const Index first = m_outline.segments[e].source;
      go_straight_on(first, static_cast<Index>(e), other_end(static_cast<Index>(e), first));
      judge();
      go_straight_on(m_vertices.back(), m_segments.back(), first); // and back, as far as it goes
      judge();
    }
    return is_wall;
  }

private:
  const Point& point(Index v) const { return m_outline.points[v]; }

  Index other_end(Index e, Index v) const { return m_outline.segments[e].other_end(v); }

  /// The way from a vertex along a segment, and those behind it, on which no vertex is farther from the straight line to
  /// the last one than text files round coordinates. That leaves a range of slopes against the direction to `aim`: that
  /// of a first segment which is no longer than they round may be any.
  void go_straight_on(Index first, Index e, Index aim)
  {
    constexpr double tolerated = 1e-3; // in units of d
    m_segments.clear();
    m_vertices.assign(1, first);
    const Kernel::Vector_2 along = (point(aim) - point(first)) / distance(point(first), point(aim));
    double farthest = 0, least_slope = -std::numeric_limits<double>::infinity(), largest_slope = -least_slope;
    const auto take = [&](Index part) {
      const Index v = other_end(part, m_vertices.back());
      const Kernel::Vector_2 way = point(v) - point(first);
      const double x = way * along, y = CGAL::determinant(along, way), tolerance = tolerated * m_size[v];
      if (!(x > farthest && y >= least_slope * x && y <= largest_slope * x))
        return false;
      farthest = x;
      least_slope = (std::max)(least_slope, (y - tolerance) / x);
      largest_slope = (std::min)(largest_slope, (y + tolerance) / x);
      m_segments.push_back(part);
      m_vertices.push_back(v);
      return true;
    };
    for (bool goes_on = take(e); goes_on;) {
      const auto& next = m_at[m_vertices.back()];
      const Index last = m_segments.back();
      goes_on = std::any_of(next.begin(), next.end(), [&](Index part) { return part != last && take(part); });
    }
  }

  double number_of_pieces() const
  {
    double sum = 0;
    for (std::size_t k = 1; k < m_vertices.size(); ++k) {
      const Index u = m_vertices[k - 1], v = m_vertices[k];
      sum += distance(point(u), point(v)) / std::sqrt(m_size[u] * m_size[v]); // d is about linear in between
    }
    return sum;
  }

  const Outline_2& m_outline;
  const std::vector<double>& m_size;
  Segments_at_vertices_2 m_at; // the segments at each vertex
  std::vector<Index> m_segments, m_vertices;                  // of the way
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WALL_SEARCH_2_H
