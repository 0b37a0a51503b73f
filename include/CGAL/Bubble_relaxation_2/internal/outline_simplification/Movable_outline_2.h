// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_MOVABLE_OUTLINE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_MOVABLE_OUTLINE_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Segment_grid_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The outline as it is at a time, on its way from the old one to the new one. A path between two of its points is
/// replaced by another one only if no other part of it is touched, and none is passed: no other vertex lies between the
/// two paths. So nothing crosses, and what lies inside of what stays as it is. All is decided exactly.
class Movable_outline_2
{
public:
  using Path = std::vector<Point>;

  Segment_grid_2& grid() { return m_grid; }
  const Segment_grid_2& grid() const { return m_grid; }

  /// a segment, or a point if both ends are the same; where pieces are about as long as `size`
  Index insert(const Point& a, const Point& b, double size) { return m_grid.insert(a, b, 0.5 * size); }
  void remove(Index id) { m_grid.remove(id); }
  void put_back(Index id) { m_grid.put_back(id); }

  /// Whether the segments `removed`, which are the path `from`, may be replaced by the path `to` with the same ends.
  bool is_free(const std::vector<Index>& removed, const Path& from, const Path& to) const
  {
    const Bbox_2 box = bbox_2(from.begin(), from.end()) + bbox_2(to.begin(), to.end());
    // all of both but the last segments, which may be long: what they leave of an old one
    const Bbox_2 head = bbox_2(from.begin(), from.end() - 1) + bbox_2(to.begin(), to.end() - 1);
    const double reach = (std::max)(head.xmax() - head.xmin(), head.ymax() - head.ymin());
    bool is_free = is_simple(to);
    m_between = from;
    m_between.insert(m_between.end(), to.rbegin() + 1, to.rend() - 1);
    m_grid.for_each_near(to.end()[-2], to.back(), reach, box, [&](Index id) {
      if (!is_free || std::find(removed.begin(), removed.end(), id) != removed.end())
        return;
      const Point &a = m_grid.source(id), &b = m_grid.target(id);
      for (std::size_t k = 1; k < to.size() && is_free; ++k)
        is_free = !meet(to[k - 1], to[k], a, b, from.front(), from.back());
      if (is_free && joins_ends(a, b, from))
        is_free = is_left_of_chord(from) == is_left_of_chord(to);
      for (const Point* p : {&a, &b})
        if (is_free && *p != from.front() && *p != from.back())
          is_free = winding_number(*p) == 0;
    });
    return is_free;
  }

private:
  static bool is_simple(const Path& path)
  {
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (path[i - 1] == path[i])
        return false;
      for (std::size_t j = 1; j < i; ++j)
        if (meet(path[i - 1], path[i], path[j - 1], path[j], j + 1 == i ? path[j] : path.front(), path.back()))
          return false;
    }
    return true;
  }

  /// whether two segments have more in common than one of two points, which may be an end of both
  static bool meet(const Point& a, const Point& b, const Point& c, const Point& d, const Point& first,
                   const Point& last)
  {
    if ((std::max)(a.x(), b.x()) < (std::min)(c.x(), d.x()) || (std::max)(c.x(), d.x()) < (std::min)(a.x(), b.x()) ||
        (std::max)(a.y(), b.y()) < (std::min)(c.y(), d.y()) || (std::max)(c.y(), d.y()) < (std::min)(a.y(), b.y()))
      return false;
    const bool a_is_shared = a == c || a == d, b_is_shared = b == c || b == d;
    if (a_is_shared && b_is_shared)
      return true;
    if (a_is_shared || b_is_shared) {
      const Point &common = a_is_shared ? a : b, &p = a_is_shared ? b : a, &q = common == c ? d : c;
      return (common != first && common != last) || q == common ||
             (CGAL::orientation(common, p, q) == COLLINEAR &&
              !CGAL::collinear_are_strictly_ordered_along_line(p, common, q));
    }
    const Orientation c_side = CGAL::orientation(a, b, c), d_side = CGAL::orientation(a, b, d),
                      a_side = CGAL::orientation(c, d, a), b_side = CGAL::orientation(c, d, b);
    if (c == d)
      return c_side == COLLINEAR && CGAL::collinear_are_ordered_along_line(a, c, b);
    if (c_side == COLLINEAR && d_side == COLLINEAR)
      return true; // on a line, where the boxes overlap
    return c_side != d_side && a_side != b_side;
  }

  static bool joins_ends(const Point& a, const Point& b, const Path& path)
  {
    return a != b && ((a == path.front() && b == path.back()) || (b == path.front() && a == path.back()));
  }

  /// Whether a path turns counterclockwise back to its start. It does not meet the segment between its ends, so its
  /// lexicographically least vertex tells.
  static bool is_left_of_chord(const Path& path)
  {
    const std::size_t n = path.size(),
                      k = static_cast<std::size_t>(std::min_element(path.begin(), path.end()) - path.begin());
    return CGAL::orientation(path[(k + n - 1) % n], path[k], path[(k + 1) % n]) == LEFT_TURN;
  }

  /// how often what is between two paths goes around a point that is not on them
  int winding_number(const Point& p) const
  {
    int n = 0;
    for (std::size_t k = 0; k < m_between.size(); ++k) {
      const Point &a = m_between[k], &b = m_between[k + 1 == m_between.size() ? 0 : k + 1];
      if ((a.y() <= p.y()) == (b.y() <= p.y()))
        continue;
      const bool upward = a.y() <= p.y();
      if (CGAL::orientation(a, b, p) == (upward ? LEFT_TURN : RIGHT_TURN))
        n += upward ? 1 : -1;
    }
    return n;
  }

  Segment_grid_2 m_grid;
  mutable Path m_between;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_MOVABLE_OUTLINE_2_H
