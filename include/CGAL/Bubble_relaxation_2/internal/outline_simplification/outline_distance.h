// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_DISTANCE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_DISTANCE_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Segment_grid_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The largest distance of a point of some segments from others: each segment is halved until it is known up to a
/// relative error, or that it is no larger than another one. The distance from one segment is a convex function, so it
/// is no larger between two points than at them.
class One_sided_distance_2
{
public:
  using Segments = std::vector<std::pair<Point, Point>>;
  static constexpr double relative_error = 1e-6;

  /// \param size about as long as the segments `to` are
  One_sided_distance_2(const Segments& to, double size) : m_size(size)
  {
    for (const auto& s : to)
      m_grid.insert(s.first, s.second, size);
  }

  /// not less than the largest distance, and no more than that and `least` by the relative error
  double operator()(const Segments& from, double least)
  {
    m_largest = least;
    for (const auto& s : from) {
      find_near(s.first, s.second);
      look_at(s.first, s.second, 0, 0);
    }
    return m_largest;
  }

private:
  static constexpr int most_halvings = 60;

  /// all segments that may be the nearest to some point between `a` and `b`
  void find_near(const Point& a, const Point& b)
  {
    double reach = m_size;
    do { // until one is within reach of all of them
      m_near.clear();
      m_grid.for_each_near(box(a, b, reach), [&](Index id) { m_near.push_back(id); });
      double bound = (std::numeric_limits<double>::infinity)();
      for (Index id : m_near)
        bound = (std::min)(bound, (std::max)(distance_to(a, id), distance_to(b, id)));
      if (bound <= reach)
        return;
      reach = (std::min)(2 * reach, (std::max)(bound, reach * (1 + 1e-9)));
    } while (reach < (std::numeric_limits<double>::max)());
  }

  static Bbox_2 box(const Point& a, const Point& b, double reach)
  {
    const Bbox_2 box = a.bbox() + b.bbox();
    return Bbox_2(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach);
  }

  double distance_to(const Point& p, Index id) const
  {
    return distance_to_segment(p, m_grid.source(id), m_grid.target(id));
  }

  /// \param first of those in `m_near` that may be the nearest; they are all behind it
  void look_at(const Point& a, const Point& b, int halvings, std::size_t first)
  {
    const double infinity = (std::numeric_limits<double>::infinity)();
    double from_a = infinity, from_b = infinity, between = infinity;
    const std::size_t end = m_near.size();
    for (std::size_t k = first; k < end; ++k) {
      const double da = distance_to(a, m_near[k]), db = distance_to(b, m_near[k]);
      from_a = (std::min)(from_a, da);
      from_b = (std::min)(from_b, db);
      between = (std::min)(between, (std::max)(da, db));
    }
    if (between <= m_largest)
      return;
    const double known = (std::max)(from_a, from_b);
    if (between <= known * (1 + relative_error) || halvings == most_halvings) {
      m_largest = between;
      return;
    }
    m_largest = (std::max)(m_largest, known);
    // a distance changes by no more than the way: others are nowhere as near as `between`, but who gave that always is
    const double length = distance(a, b);
    for (std::size_t k = first; k < end; ++k)
      if (distance_to(a, m_near[k]) + distance_to(b, m_near[k]) - length <= 2 * between)
        m_near.push_back(m_near[k]);
    const Point middle((a.x() + b.x()) / 2, (a.y() + b.y()) / 2);
    look_at(a, middle, halvings + 1, end);
    look_at(middle, b, halvings + 1, end);
    m_near.resize(end);
  }

  Segment_grid_2 m_grid;
  std::vector<Index> m_near; // of a segment, behind them of its half that is looked at, and so on
  double m_size, m_largest = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_DISTANCE_H
