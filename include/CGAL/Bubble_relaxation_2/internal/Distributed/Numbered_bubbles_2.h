// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/merge_tail.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a bubble on its way from one rank to another
struct Bubble_record_2
{
  double x, y, d, vx, vy, s;
  std::int64_t number;
  Index place, tag;
  std::int32_t dimension;
};

inline Bubble_record_2 record(const Bubbles_2& b, std::size_t i, std::int64_t number)
{
  return Bubble_record_2{b.x[i], b.y[i], b.d[i], b.vx[i], b.vy[i], b.s[i],
                         number, b.place[i], b.tag[i], b.dimension[i]};
}

/// adds a bubble without its number
inline void add(Bubbles_2& bubbles, const Bubble_record_2& r)
{
  bubbles.add(Point(r.x, r.y), r.d, static_cast<Bubbles_2::Dimension>(r.dimension), r.place, r.s, r.tag);
  bubbles.vx.back() = r.vx;
  bubbles.vy.back() = r.vy;
}

/// The order in which numbers ascend, if they do not yet. Mostly few were added to those that do.
inline std::vector<Index> ascending_order(const std::vector<std::int64_t>& numbers)
{
  std::vector<Index> order;
  const auto sorted_end = std::is_sorted_until(numbers.begin(), numbers.end());
  if (sorted_end == numbers.end())
    return order;
  order.resize(numbers.size());
  std::iota(order.begin(), order.end(), Index(0));
  merge_tail(order, static_cast<std::size_t>(sorted_end - numbers.begin()),
             [&numbers](Index i, Index j) { return numbers[i] < numbers[j]; });
  return order;
}

/// Bubbles of one rank, and their places in the sequence of the bubbles of all ranks, which one rank alone would
/// hold.
struct Numbered_bubbles_2
{
  Bubbles_2 bubbles;
  std::vector<std::int64_t> numbers;

  std::size_t size() const { return bubbles.size(); }

  void add(const Bubble_record_2& r)
  {
    internal::add(bubbles, r);
    numbers.push_back(r.number);
  }

  void make_room_for(std::size_t n)
  {
    bubbles.make_room_for(n);
    internal::make_room_for(n, numbers);
  }

  void sort()
  {
    const std::vector<Index> order = ascending_order(numbers);
    if (!order.empty())
      select(order);
  }

  void forget_gone()
  {
    const std::vector<Index> left = bubbles.left();
    if (left.size() < size())
      select(left);
  }

  /// keeps the bubbles `order[0], order[1], …` in this order and forgets the others
  void select(const std::vector<Index>& order)
  {
    bubbles.select(order);
    Bubbles_2::select(numbers, order);
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_BUBBLES_2_H
