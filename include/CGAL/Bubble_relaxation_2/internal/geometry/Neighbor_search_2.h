// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the neighbour sets of consecutive bubbles, one after the other
struct Neighbor_block
{
  std::vector<Index> found;
  std::vector<std::size_t> sizes;
};

/// Finds neighbour sets with buckets. Bubbles that follow each other mostly lie together: what may be near to any of
/// a group is looked for once, and lies in memory in a row when each of them is compared with it.
class Neighbor_search_2
{
public:
  /// `x`, `y`, `d`: of the bubbles, as they are in the buckets; those that are not there have an empty set.
  /// `radius`: the reach of the buckets
  Neighbor_search_2(const Bubble_buckets_2& buckets, const std::vector<double>& x, const std::vector<double>& y,
                    const std::vector<double>& d, double radius)
    : m_buckets(buckets), m_x(x), m_y(y), m_d(d), m_radius(radius)
  {}

  /// Replaces `block` by the sets of the bubbles from `first` to `last`, without this, each in the order of
  /// `is_before`. `is_gone(i)`: whether bubble `i` is not in the buckets
  template <class Is_gone, class Is_before>
  void operator()(std::size_t first, std::size_t last, const Is_gone& is_gone, const Is_before& is_before,
                  Neighbor_block& block) const
  {
    block.found.clear();
    block.sizes.clear();
    Candidates candidates;
    for (; first < last; first = (std::min)(first + group_size, last))
      find_in_group(first, (std::min)(first + group_size, last), is_gone, is_before, candidates, block);
  }

  /// adds the neighbours of one bubble, in any order
  void find_neighbors(std::size_t i, std::vector<Index>& found) const
  {
    m_buckets.for_each_near(m_x[i], m_y[i], m_d[i], [&](Index j, double, double) {
      if (static_cast<std::size_t>(j) != i)
        found.push_back(j);
      return true;
    });
  }

  static constexpr std::size_t block_size = 512; ///< so many bubbles make a block that stays in a cache

private:
  static constexpr std::size_t group_size = 8;
  /// a group lies together if, in units of its smallest bubble, no bubble is larger, and it is no wider
  static constexpr double largest = 1.5, widest = 8;

  struct Candidates
  {
    std::vector<double> x, y, d;
    std::vector<Index> index;

    void clear()
    {
      for (std::vector<double>* a : {&x, &y, &d})
        a->clear();
      index.clear();
    }
  };

  template <class Is_gone, class Is_before>
  void find_in_group(std::size_t first, std::size_t last, const Is_gone& is_gone, const Is_before& is_before,
                     Candidates& candidates, Neighbor_block& block) const
  {
    const bool is_together = find_candidates(first, last, candidates);
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t before = block.found.size();
      if (is_gone(i)) {
        block.sizes.push_back(0);
        continue;
      }
      if (is_together)
        choose_neighbors(i, candidates, block.found);
      else
        find_neighbors(i, block.found);
      std::sort(block.found.begin() + static_cast<std::ptrdiff_t>(before), block.found.end(), is_before);
      block.sizes.push_back(block.found.size() - before);
    }
  }

  /// all that may be near to any of the group; returns whether the group lies together, else there are none
  bool find_candidates(std::size_t first, std::size_t last, Candidates& candidates) const
  {
    const auto x = range(m_x, first, last), y = range(m_y, first, last), d = range(m_d, first, last);
    const double width = x.second - x.first, height = y.second - y.first;
    if (!(d.second <= largest * d.first && (std::max)(width, height) <= widest * d.first))
      return false;
    const double cx = x.first + 0.5 * width, cy = y.first + 0.5 * height; // rounded: what counts is how far from there
    const double dx = (std::max)(x.second - cx, cx - x.first), dy = (std::max)(y.second - cy, cy - y.first);
    candidates.clear();
    m_buckets.for_each_near_some(cx, cy, std::sqrt(dx * dx + dy * dy), d.second,
                                 [&candidates](const Bubble_buckets_2::Entry& e) {
                                   candidates.x.push_back(e.x);
                                   candidates.y.push_back(e.y);
                                   candidates.d.push_back(e.d);
                                   candidates.index.push_back(e.id);
                                 });
    return true;
  }

  static std::pair<double, double> range(const std::vector<double>& values, std::size_t first, std::size_t last)
  {
    const auto ends = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(first),
                                          values.begin() + static_cast<std::ptrdiff_t>(last));
    return {*ends.first, *ends.second};
  }

  void choose_neighbors(std::size_t i, const Candidates& candidates, std::vector<Index>& found) const
  {
    const std::size_t n = candidates.index.size(), before = found.size();
    found.resize(before + n);
    Index* next = found.data() + before;
    const double x = m_x[i], y = m_y[i], d = m_d[i], half = 0.5 * m_radius;
    for (std::size_t k = 0; k < n; ++k) {
      const double dx = candidates.x[k] - x, dy = candidates.y[k] - y, reach = half * (d + candidates.d[k]);
      *next = candidates.index[k]; // without a branch
      next += (dx * dx + dy * dy < reach * reach) & (candidates.index[k] != static_cast<Index>(i));
    }
    found.resize(static_cast<std::size_t>(next - found.data()));
  }

  const Bubble_buckets_2& m_buckets;
  const std::vector<double>&m_x, &m_y, &m_d;
  const double m_radius;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_NEIGHBOR_SEARCH_2_H
