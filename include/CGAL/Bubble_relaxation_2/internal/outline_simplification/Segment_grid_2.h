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

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Segments by place, long and short ones alike: each lies in the at most four cells that its box touches of a grid with
/// cells no smaller than the box. Cells have powers of two as sizes, so that scaling by one changes nothing.
class Segment_grid_2
{
public:
  Index insert(const Point& a, const Point& b)
  {
    const Index id = static_cast<Index>(m_segments.size());
    m_segments.push_back({a, b, 0, false});
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
    const Bbox_2 b = box(id);
    s.level = std::ilogb((std::max)({b.xmax() - b.xmin(), b.ymax() - b.ymin(), smallest_size()})) + 1;
    s.is_there = true;
    for_each_cell(b, s.level, [&](std::vector<Index>& cell) { cell.push_back(id); });
  }

  /// the least size that cells distinguish, where segments may be points
  void set_smallest_size(double size) { m_smallest_size = size; }

  const Point& source(Index id) const { return m_segments[id].a; }
  const Point& target(Index id) const { return m_segments[id].b; }
  bool is_there(Index id) const { return m_segments[id].is_there; }
  std::size_t number_of_ids() const { return m_segments.size(); }

  Bbox_2 box(Index id) const { return m_segments[id].a.bbox() + m_segments[id].b.bbox(); }

  /// Calls `visit(id)` once for each segment whose box meets a box.
  template <class Visitor>
  void for_each_near(const Bbox_2& query, const Visitor& visit) const
  {
    m_found.clear();
    for (const auto& level : m_levels) {
      const double size = std::ldexp(1., level.first);
      const std::int64_t x0 = cell(query.xmin(), size), x1 = cell(query.xmax(), size),
                         y0 = cell(query.ymin(), size), y1 = cell(query.ymax(), size);
      if (static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1) >
          static_cast<double>(level.second.size())) { // more cells than there are: look at all
        for (const auto& c : level.second)
          m_found.insert(m_found.end(), c.second.begin(), c.second.end());
        continue;
      }
      for (std::int64_t x = x0; x <= x1; ++x)
        for (std::int64_t y = y0; y <= y1; ++y) {
          const auto c = level.second.find(key(x, y));
          if (c != level.second.end())
            m_found.insert(m_found.end(), c->second.begin(), c->second.end());
        }
    }
    std::sort(m_found.begin(), m_found.end());
    m_found.erase(std::unique(m_found.begin(), m_found.end()), m_found.end());
    for (Index id : m_found)
      if (do_overlap(box(id), query))
        visit(id);
  }

private:
  struct Segment
  {
    Point a, b;
    int level;
    bool is_there;
  };
  using Level = std::unordered_map<std::uint64_t, std::vector<Index>>;

  double smallest_size() const { return m_smallest_size; }

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
  double m_smallest_size = 1e-300;
  mutable std::vector<Index> m_found;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SEGMENT_GRID_2_H
