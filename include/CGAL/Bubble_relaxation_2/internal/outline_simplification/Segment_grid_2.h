// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Segments by place, long and short ones alike: each lies in the at most four cells that its box touches of a grid
/// with cells no smaller than the box, nor than what is told. The box of a long slanted one would be near to much that
/// is not near to itself: it lies where boxes of parts of it do. Cells have powers of two as sizes, so that scaling by
/// one changes nothing.
class Segment_grid_2
{
  static constexpr double long_part = 8; // in units of the smallest cells
  static constexpr int most_parts = 64;

public:
  /// \param cell_size of the smallest cells that it is worth to look at there
  Index insert(const Point& a, const Point& b, double cell_size)
  {
    const Index id = static_cast<Index>(m_segments.size());
    const int parts = number_of_parts(a, b, cell_size);
    const double size = (std::max)({std::abs(b.x() - a.x()) / parts, std::abs(b.y() - a.y()) / parts, cell_size});
    m_segments.push_back({a, b, std::ilogb(size) + 1, parts, 0, false});
    put_back(id);
    return id;
  }

  void remove(Index id)
  {
    Segment& s = m_segments[id];
    s.is_there = false;
    for_each_cell(s, [&](std::vector<Index>& cell) { cell.erase(std::find(cell.begin(), cell.end(), id)); });
  }

  /// inserts a segment again that was removed
  void put_back(Index id)
  {
    Segment& s = m_segments[id];
    s.is_there = true;
    for_each_cell(s, [&](std::vector<Index>& cell) { cell.push_back(id); });
  }

  const Point& source(Index id) const { return m_segments[id].a; }
  const Point& target(Index id) const { return m_segments[id].b; }
  bool is_there(Index id) const { return m_segments[id].is_there; }

  Bbox_2 box(Index id) const { return m_segments[id].a.bbox() + m_segments[id].b.bbox(); }

  /// Calls `visit(id)` once for each segment that meets a box, and for some others near by, in no particular order.
  template <class Visitor>
  void for_each_near(const Bbox_2& query, const Visitor& visit) const
  {
    ++m_query;
    visit_others_near(query, visit);
  }

  /// the same for what is in a box and, in both coordinates, within `reach` of the segment from `a` to `b`
  template <class Visitor>
  void for_each_near(const Point& a, const Point& b, double reach, const Bbox_2& box, const Visitor& visit) const
  {
    ++m_query;
    const int parts = number_of_parts(a, b, reach);
    for (int i = 0; i < parts; ++i) {
      const Bbox_2 part = box_of_part(a, b, i, parts);
      visit_others_near({(std::max)(box.xmin(), part.xmin() - reach), (std::max)(box.ymin(), part.ymin() - reach),
                         (std::min)(box.xmax(), part.xmax() + reach), (std::min)(box.ymax(), part.ymax() + reach)},
                        visit);
    }
  }

private:
  struct Segment
  {
    Point a, b;
    int level, parts;
    mutable std::uint64_t query; // the last one that found it
    bool is_there;
  };
  using Level = std::unordered_map<std::uint64_t, std::vector<Index>>;

  /// as many as have small boxes, where a slanted segment is much longer than `size`
  static int number_of_parts(const Point& a, const Point& b, double size)
  {
    const double dx = std::abs(b.x() - a.x()), dy = std::abs(b.y() - a.y());
    if ((std::min)(dx, dy) <= long_part * size)
      return 1;
    return static_cast<int>((std::min)(1. * most_parts, std::ceil((std::max)(dx, dy) / (long_part * size))));
  }

  /// of one of some equal parts of a segment, with room for roundings
  static Bbox_2 box_of_part(const Point& a, const Point& b, int i, int parts)
  {
    if (parts == 1)
      return a.bbox() + b.bbox();
    const auto at = [&](double t) {
      return Point(a.x() + t * (b.x() - a.x()), a.y() + t * (b.y() - a.y())).bbox();
    };
    const Bbox_2 box = at(static_cast<double>(i) / parts) + at(static_cast<double>(i + 1) / parts);
    const double rounding =
      rounding_of((std::max)({std::abs(a.x()), std::abs(a.y()), std::abs(b.x()), std::abs(b.y())}));
    return {box.xmin() - rounding, box.ymin() - rounding, box.xmax() + rounding, box.ymax() + rounding};
  }

  /// visits those that the query has not found yet
  template <class Visitor>
  void visit_others_near(const Bbox_2& query, const Visitor& visit) const
  {
    const auto visit_cell = [&](const std::vector<Index>& ids) {
      for (Index id : ids)
        if (m_segments[id].query != m_query && do_overlap(box(id), query)) {
          m_segments[id].query = m_query;
          visit(id);
        }
    };
    for (const auto& level : m_levels) {
      const double size = std::ldexp(1., level.first);
      const std::int64_t x0 = cell(query.xmin(), size), x1 = cell(query.xmax(), size),
                         y0 = cell(query.ymin(), size), y1 = cell(query.ymax(), size);
      if (static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1) >
          static_cast<double>(level.second.size())) { // more cells than there are: look at all
        for (const auto& c : level.second)
          visit_cell(c.second);
        continue;
      }
      for (std::int64_t x = x0; x <= x1; ++x)
        for (std::int64_t y = y0; y <= y1; ++y) {
          const auto c = level.second.find(key(x, y));
          if (c != level.second.end())
            visit_cell(c->second);
        }
    }
  }

  static std::int64_t cell(double c, double size) { return static_cast<std::int64_t>(std::floor(c / size)); }

  static std::uint64_t key(std::int64_t x, std::int64_t y)
  {
    return hash_of_two(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
  }

  template <class Visitor>
  void for_each_cell(const Segment& s, const Visitor& visit)
  {
    const double size = std::ldexp(1., s.level);
    Level& cells = m_levels[s.level];
    for (int i = 0; i < s.parts; ++i) {
      const Bbox_2 b = box_of_part(s.a, s.b, i, s.parts);
      for (std::int64_t x = cell(b.xmin(), size); x <= cell(b.xmax(), size); ++x)
        for (std::int64_t y = cell(b.ymin(), size); y <= cell(b.ymax(), size); ++y)
          visit(cells[key(x, y)]);
    }
  }

  std::vector<Segment> m_segments;
  std::map<int, Level> m_levels;
  mutable std::uint64_t m_query = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H
