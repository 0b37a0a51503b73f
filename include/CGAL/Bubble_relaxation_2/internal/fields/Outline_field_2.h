// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Triangle_quadtree_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A place on the outline of a domain and the size that is wanted there.
struct Size_source_2
{
  Point point;
  double d;
};

/// The size d(x) = min over all sources s of d_s + g |x - s|, which grows by no more than g per unit.
///
/// A quadtree holds in each leaf the few sources that are the least somewhere in it, so a query does not
/// look at all of them; where there would be many, d may be a little too large. The result depends neither
/// on the order of the sources nor on former queries.
class Outline_field_2
{
public:
  static constexpr double gradation = 0.2;

  Outline_field_2(const std::vector<Size_source_2>& sources, const Bbox_2& box)
    : m_sources({0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                 0.5 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), 0},
                sources, Fill())
  {}

  double operator()(double x, double y) const
  {
    const Sources& sources = m_sources(x, y);
    double least = size_from(sources.front(), x, y);
    for (const Size_source_2& s : sources)
      least = (std::min)(least, size_from(s, x, y));
    return least;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  static constexpr std::size_t most_sources = 8; // in a leaf
  static constexpr int deepest = 40;

  using Sources = std::vector<Size_source_2>;
  using Tree = Quadtree_2<Sources>;

  static double size_from(const Size_source_2& s, double x, double y)
  {
    const double dx = x - s.point.x(), dy = y - s.point.y();
    return s.d + gradation * std::sqrt(dx * dx + dy * dy);
  }

  static const Size_source_2& nearest(const Sources& sources, double x, double y)
  {
    const Size_source_2* best = &sources.front();
    for (const Size_source_2& s : sources) {
      const double d = size_from(s, x, y), least = size_from(*best, x, y);
      if (d < least || (d == least && s.point < best->point))
        best = &s;
    }
    return *best;
  }

  struct Fill
  {
    template <class Divide>
    void operator()(const Tree::Square& c, const Sources& sources, Sources& leaf, const Divide& divide) const
    {
      // within the cell two sources cannot change their order if they differ by more than this
      const double slack = 2 * gradation * std::sqrt(2.) * c.half;
      const double least = size_from(nearest(sources, c.x, c.y), c.x, c.y);
      Sources kept;
      std::copy_if(sources.begin(), sources.end(), std::back_inserter(kept),
                   [&](const Size_source_2& s) { return size_from(s, c.x, c.y) <= least + slack; });
      // far from a finely divided outline many sources stay, but d hardly changes within the cell
      const bool is_even = slack <= 0.5 * least || c.depth == deepest;
      if (kept.size() > most_sources && !is_even)
        divide([&kept](int) -> const Sources& { return kept; });
      else if (kept.size() > most_sources)
        for (int k = 0; k < 9; ++k)
          leaf.push_back(nearest(kept, c.x + (k % 3 - 1) * c.half, c.y + (k / 3 - 1) * c.half));
      else
        leaf = std::move(kept);
    }
  };

  Tree m_sources;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_OUTLINE_FIELD_2_H
