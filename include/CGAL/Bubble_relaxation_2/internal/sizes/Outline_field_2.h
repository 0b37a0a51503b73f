// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Triangle_quadtree_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

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
  /// `growth`: g
  Outline_field_2(const std::vector<Size_source_2>& sources, const Bbox_2& box, double growth)
    : m_growth(growth), m_sources(sources),
      m_leaves({0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                0.5 * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), 0},
               Range{0, static_cast<Index>(sources.size())}, Fill(*this))
  {}

  double operator()(double x, double y) const
  {
    const Range& leaf = m_leaves(x, y);
    double least = size_from(m_in_leaves[leaf.first], x, y);
    for (Index k = leaf.first + 1; k < leaf.last; ++k)
      least = (std::min)(least, size_from(m_in_leaves[k], x, y));
    return least;
  }

  double operator()(const Point& p) const { return (*this)(p.x(), p.y()); }

private:
  static constexpr Index most_sources = 12; // in a leaf
  static constexpr int deepest = 40;

  /// of a list of sources
  struct Range
  {
    Index first = 0, last = 0;

    Index size() const { return last - first; }
  };

  using Tree = Quadtree_2<Range>;

  double size_from(Index source, double x, double y) const
  {
    const Size_source_2& s = m_sources[source];
    const double dx = x - s.point.x(), dy = y - s.point.y();
    return s.d + m_growth * std::sqrt(dx * dx + dy * dy);
  }

  /// Finds what counts in a square among what counts in the square around it.
  class Fill
  {
  public:
    explicit Fill(Outline_field_2& field) : m_field(field), m_stack(field.m_sources.size())
    {
      std::iota(m_stack.begin(), m_stack.end(), 0);
    }

    template <class Divide>
    void operator()(const Tree::Square& c, const Range& around, Range& leaf, const Divide& divide)
    {
      tick();
      // within the cell two sources cannot change their order if they differ by more than this
      const double slack = 2 * m_field.m_growth * std::sqrt(2.) * c.half;
      const double least = find_sizes(c, around);
      Range kept{static_cast<Index>(m_stack.size()), 0};
      for (Index k = around.first; k < around.last; ++k)
        if (m_sizes[k - around.first] <= least + slack)
          m_stack.push_back(Index(m_stack[k]));
      kept.last = static_cast<Index>(m_stack.size());
      // far from a finely divided outline many sources stay, but d hardly changes within the cell
      const bool is_even = slack <= 0.5 * least || c.depth == deepest;
      if (kept.size() > most_sources && !is_even)
        divide([&kept](int) -> const Range& { return kept; });
      else
        fill_leaf(c, kept, leaf);
      m_stack.resize(kept.first);
    }

  private:
    /// the sizes that sources ask for at the centre of a square; returns the least
    double find_sizes(const Tree::Square& c, const Range& sources)
    {
      m_sizes.clear();
      for (Index k = sources.first; k < sources.last; ++k)
        m_sizes.push_back(m_field.size_from(m_stack[k], c.x, c.y));
      return *std::min_element(m_sizes.begin(), m_sizes.end());
    }

    void fill_leaf(const Tree::Square& c, const Range& sources, Range& leaf)
    {
      std::vector<Index>& result = m_field.m_in_leaves;
      leaf.first = static_cast<Index>(result.size());
      if (sources.size() > most_sources)
        for (int k = 0; k < 9; ++k)
          result.push_back(nearest(sources, c.x + (k % 3 - 1) * c.half, c.y + (k / 3 - 1) * c.half));
      else
        for (Index k = sources.first; k < sources.last; ++k)
          result.push_back(m_stack[k]);
      leaf.last = static_cast<Index>(result.size());
    }

    Index nearest(const Range& sources, double x, double y) const
    {
      Index best = m_stack[sources.first];
      double least = m_field.size_from(best, x, y);
      for (Index k = sources.first + 1; k < sources.last; ++k) {
        const Index s = m_stack[k];
        const double d = m_field.size_from(s, x, y);
        if (d < least || (d == least && m_field.m_sources[s].point < m_field.m_sources[best].point)) {
          best = s;
          least = d;
        }
      }
      return best;
    }

    Outline_field_2& m_field;
    std::vector<Index> m_stack; // what counts in the squares from the root down to the present one
    std::vector<double> m_sizes;
  };

  const double m_growth;
  const std::vector<Size_source_2> m_sources;
  std::vector<Index> m_in_leaves; // numbers of sources, leaf by leaf
  Tree m_leaves;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_FIELD_2_H
