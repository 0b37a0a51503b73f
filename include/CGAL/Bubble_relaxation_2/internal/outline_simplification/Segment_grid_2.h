// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H

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
/// with cells no smaller than the box, nor than what is told. Cells have powers of two as sizes, so that scaling by one
/// changes nothing.
class Segment_grid_2
{
public:
  /// \param cell_size of the smallest cells that it is worth to look at there
  Index insert(const Point& a, const Point& b, double cell_size)
  {
    const Index id = static_cast<Index>(m_segments.size());
    const double size = (std::max)({std::abs(b.x() - a.x()), std::abs(b.y() - a.y()), cell_size});
    m_segments.push_back({a, b, std::ilogb(size) + 1, 0, false});
    put_back(id);
    return id;
  }

  void remove(Index id)
  {
    Segment& s = m_segments[id];
    s.is_there = false;
    for_each_cell(box(id), s.level, [&](std::vector<Index>& cell) {
      cell.erase(std::find(cell.begin(), cell.end(), id));
    });
  }

  /// inserts a segment again that was removed
  void put_back(Index id)
  {
    Segment& s = m_segments[id];
    s.is_there = true;
    for_each_cell(box(id), s.level, [&](std::vector<Index>& cell) { cell.push_back(id); });
  }

  const Point& source(Index id) const { return m_segments[id].a; }
  const Point& target(Index id) const { return m_segments[id].b; }
  bool is_there(Index id) const { return m_segments[id].is_there; }

  Bbox_2 box(Index id) const { return m_segments[id].a.bbox() + m_segments[id].b.bbox(); }

  /// Calls `visit(id)` once for each segment whose box meets a box, in no particular order.
  template <class Visitor>
  void for_each_near(const Bbox_2& query, const Visitor& visit) const
  {
    ++m_query;
    const auto visit_cell = [&](const std::vector<Index>& ids) {
      for (Index id : ids)
        if (m_segments[id].query != m_query) {
          m_segments[id].query = m_query;
          if (do_overlap(box(id), query))
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

private:
  struct Segment
  {
    Point a, b;
    int level;
    mutable std::uint64_t query; // the last one that found it
    bool is_there;
  };
  using Level = std::unordered_map<std::uint64_t, std::vector<Index>>;

  static std::int64_t cell(double c, double size) { return static_cast<std::int64_t>(std::floor(c / size)); }

  static std::uint64_t key(std::int64_t x, std::int64_t y)
  {
    return hash_of_two(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y));
  }

  template <class Visitor>
  void for_each_cell(const Bbox_2& b, int level, const Visitor& visit)
  {
    const double size = std::ldexp(1., level);
    Level& cells = m_levels[level];
    for (std::int64_t x = cell(b.xmin(), size); x <= cell(b.xmax(), size); ++x)
      for (std::int64_t y = cell(b.ymin(), size); y <= cell(b.ymax(), size); ++y)
        visit(cells[key(x, y)]);
  }

  std::vector<Segment> m_segments;
  std::map<int, Level> m_levels;
  mutable std::uint64_t m_query = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H
