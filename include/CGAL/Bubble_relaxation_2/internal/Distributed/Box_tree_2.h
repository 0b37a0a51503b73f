// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BOX_TREE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BOX_TREE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Finds points in boxes. Boxes around eight consecutive points, around eight such boxes, and so on: points that
/// follow each other should be near to each other.
class Box_tree_2
{
public:
  Box_tree_2() = default;

  explicit Box_tree_2(std::vector<Point> points) : m_points(std::move(points))
  {
    add_level(m_points.size(), [this](std::size_t i) { return m_points[i].bbox(); });
    while (m_levels.back().size() > 1) {
      const std::size_t below = m_levels.size() - 1;
      add_level(m_levels[below].size(), [this, below](std::size_t i) { return m_levels[below][i]; });
    }
  }

  /// calls `f` with the index of each point in the box
  template <class Function>
  void for_each_in(const Bbox_2& box, const Function& f) const
  {
    if (!m_points.empty())
      visit(m_levels.size() - 1, 0, box, f);
  }

private:
  static constexpr std::size_t fan = 8;

  template <class Box_of>
  void add_level(std::size_t n, const Box_of& box_of)
  {
    std::vector<Bbox_2> boxes((n + fan - 1) / fan);
    for (std::size_t i = 0; i < n; ++i)
      boxes[i / fan] += box_of(i);
    m_levels.push_back(std::move(boxes));
  }

  template <class Function>
  void visit(std::size_t level, std::size_t k, const Bbox_2& box, const Function& f) const
  {
    if (!do_overlap(m_levels[level][k], box))
      return;
    const std::size_t n = level == 0 ? m_points.size() : m_levels[level - 1].size();
    for (std::size_t i = fan * k; i < (std::min)(fan * (k + 1), n); ++i)
      if (level > 0)
        visit(level - 1, i, box, f);
      else if (do_overlap(m_points[i].bbox(), box))
        f(i);
  }

  std::vector<Point> m_points;
  std::vector<std::vector<Bbox_2>> m_levels; // of boxes around points, around those boxes, and so on
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BOX_TREE_2_H
