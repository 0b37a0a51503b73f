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

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
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
/// on the order of sources that come together nor on former queries.
class Outline_field_2
{
public:
  /// `growth`: g \pre there are sources
  Outline_field_2(const std::vector<Size_source_2>& sources, const Bbox_2& box, double growth)
    : m_growth(growth), m_leaves({0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                                  0.5 * (std::max)(box.x_span(), box.y_span()), 0})
  {
    add(sources);
  }

  /// Takes more sources, and looks only where they count. If this throws, the field is not to be used any more.
  void add(const std::vector<Size_source_2>& more)
  {
    m_sources.insert(m_sources.end(), more.begin(), more.end());
    m_leaves.put(Range{0, static_cast<Index>(more.size())}, Insertion(*this, more.size()));
  }

  double operator()(double x, double y) const
  {
    const Range& leaf = m_leaves(x, y);
    double least = size_from(m_sources[m_in_leaves[leaf.first]], x, y);
    for (Index k = leaf.first + 1; k < leaf.last; ++k)
      least = (std::min)(least, size_from(m_sources[m_in_leaves[k]], x, y));
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

  double size_from(const Size_source_2& s, double x, double y) const
  {
    const double dx = x - s.point.x(), dy = y - s.point.y();
    return s.d + m_growth * std::sqrt(dx * dx + dy * dy);
  }

  /// Brings sources to the leaves where they count: finds what counts in a square among what counts in the square
  /// around it.
  class Insertion
  {
  public:
    /// `number`: of sources to be inserted, the last ones of the field
    Insertion(Outline_field_2& field, std::size_t number) : m_field(field)
    {
      for (std::size_t s = field.m_sources.size() - number; s < field.m_sources.size(); ++s)
        push(static_cast<Index>(s));
    }

    template <class Divide>
    void operator()(const Tree::Square& c, const Range& around, Range* leaf, const Divide& divide)
    {
      if (around.size() == 0)
        return;
      tick();
      const std::size_t before = m_stack.size();
      const Range all = leaf != nullptr ? with_leaf(around, *leaf) : around;
      const Index best = nearest(all, c.x, c.y);
      // of former sources a square that is divided knows the size alone
      const double least = leaf != nullptr ? m_stack[best].size : (std::min)(m_stack[best].size, m_field(c.x, c.y));
      const Range kept = keep(c, all, best, least);
      // far from a finely divided outline many sources stay, but d hardly changes within the square
      const bool is_even = most_change(c) <= 0.5 * least || c.depth == deepest;
      if (leaf != nullptr && (kept.size() <= most_sources || is_even))
        fill_leaf(c, kept, *leaf);
      else
        divide([&kept](int) -> const Range& { return kept; });
      m_stack.resize(before);
    }

  private:
    struct Candidate
    {
      Index number;
      double size; // that it asks for at the place that was looked at last
    };

    void push(Index s) { m_stack.push_back(Candidate{s, 0}); }
    const Size_source_2& source(const Candidate& s) const { return m_field.m_sources[s.number]; }

    Range with_leaf(const Range& around, const Range& leaf)
    {
      if (leaf.size() == 0)
        return around;
      const Index first = static_cast<Index>(m_stack.size());
      for (Index k = around.first; k < around.last; ++k)
        m_stack.push_back(Candidate(m_stack[k]));
      for (Index k = leaf.first; k < leaf.last; ++k)
        push(m_field.m_in_leaves[k]);
      return Range{first, static_cast<Index>(m_stack.size())};
    }

    /// which candidate asks for the least at a place
    Index nearest(const Range& candidates, double x, double y)
    {
      Index best = candidates.first;
      for (Index k = candidates.first; k < candidates.last; ++k) {
        tick(static_cast<std::size_t>(k));
        Candidate &s = m_stack[k], &b = m_stack[best];
        s.size = m_field.size_from(source(s), x, y);
        if (s.size < b.size || (s.size == b.size && std::tie(source(s).point, source(s).d) <
                                                      std::tie(source(b).point, source(b).d)))
          best = k;
      }
      return best;
    }

    /// by how much the sizes that two sources ask for can come nearer to each other from the centre of a square to a
    /// place in it
    double most_change(const Tree::Square& c) const { return 2 * m_field.m_growth * std::sqrt(2.) * c.half; }

    /// those that may ask for the least somewhere in a square
    Range keep(const Tree::Square& c, const Range& candidates, Index best, double least)
    {
      const double change = most_change(c);
      Range kept{static_cast<Index>(m_stack.size()), 0};
      for (Index k = candidates.first; k < candidates.last; ++k) {
        tick(static_cast<std::size_t>(k));
        if (m_stack[k].size <= least + change && !is_beaten(m_stack[k], m_stack[best], change))
          m_stack.push_back(Candidate(m_stack[k]));
      }
      kept.last = static_cast<Index>(m_stack.size());
      return kept;
    }

    /// Whether `s` asks for more than `b` in all of a square. Two sources with a distance t are seen from places with
    /// distances u and v in directions that differ by no more than 2 t / (u + v) (Dunkl and Williams 1964): far from both
    /// the sizes change alike.
    bool is_beaten(const Candidate& s, const Candidate& b, double change) const
    {
      const Size_source_2 &p = source(s), &q = source(b);
      const double dx = p.point.x() - q.point.x(), dy = p.point.y() - q.point.y();
      const double both_distances = s.size - p.d + b.size - q.d - change; // times g
      return both_distances > 0 &&
             (s.size - b.size) * both_distances >
               change * m_field.m_growth * std::sqrt(dx * dx + dy * dy);
    }

    void fill_leaf(const Tree::Square& c, const Range& candidates, Range& leaf)
    {
      boost::container::small_vector<Index, most_sources> result;
      if (candidates.size() > most_sources) {
        for (int k = 0; k < 9; ++k)
          result.push_back(m_stack[nearest(candidates, c.x + (k % 3 - 1) * c.half, c.y + (k / 3 - 1) * c.half)].number);
        sort_each_once(result);
      } else
        for (Index k = candidates.first; k < candidates.last; ++k)
          result.push_back(m_stack[k].number);
      std::vector<Index>& all = m_field.m_in_leaves;
      const Index number = static_cast<Index>(result.size());
      if (number > leaf.size()) { // else they have the place of those that were there
        leaf.first = static_cast<Index>(all.size());
        all.insert(all.end(), result.begin(), result.end());
      } else
        std::copy(result.begin(), result.end(), all.begin() + leaf.first);
      leaf.last = leaf.first + number;
    }

    Outline_field_2& m_field;
    std::vector<Candidate> m_stack; // what counts in the squares from the root down to the present one
  };

  double m_growth;
  std::vector<Size_source_2> m_sources;
  std::vector<Index> m_in_leaves; // numbers of sources, leaf by leaf
  Tree m_leaves;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_OUTLINE_FIELD_2_H
