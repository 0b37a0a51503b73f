// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_KNOWN_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_KNOWN_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Sorts a sequence whose first elements are sorted, so many of them: mostly few came after these.
template <class T, class Is_before = std::less<T>>
void merge_tail(std::vector<T>& sequence, std::size_t sorted, const Is_before& is_before = Is_before())
{
  const auto middle = sequence.begin() + static_cast<std::ptrdiff_t>(sorted);
  std::sort(middle, sequence.end(), is_before);
  std::inplace_merge(sequence.begin(), middle, sequence.end(), is_before);
}

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

/// The bubbles that a rank knows, its own and others', in the order of their numbers.
struct Known_bubbles_2
{
  Bubbles_2 bubbles;
  std::vector<std::int64_t> numbers; ///< the same on all ranks
  std::vector<std::int32_t> owners;  ///< ranks

  Known_bubbles_2() = default;

  /// bubbles of one rank
  Known_bubbles_2(const Numbered_bubbles_2& own, int rank)
  {
    make_room_for(own.size() + own.size() / 8); // with some of others
    bubbles = own.bubbles;
    numbers = own.numbers;
    owners.assign(own.size(), rank);
  }

  std::size_t size() const { return numbers.size(); }

  /// of a bubble with a number, `no_index` if there is none
  /// \pre they are sorted
  Index index(std::int64_t number) const
  {
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
    return found != numbers.end() && *found == number ? static_cast<Index>(found - numbers.begin()) : no_index;
  }

  /// tells the bubbles which of them are others'
  void mark_foreign(int rank)
  {
    bubbles.is_foreign.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
      bubbles.is_foreign[i] = owners[i] != rank;
  }

  void add(const Bubble_record_2& r, int owner)
  {
    internal::add(bubbles, r);
    numbers.push_back(r.number);
    owners.push_back(owner);
  }

  /// makes room for `n` more
  void make_room_for(std::size_t n)
  {
    bubbles.make_room_for(n);
    internal::make_room_for(n, numbers);
    internal::make_room_for(n, owners);
  }

  void sort()
  {
    const std::vector<Index> order = ascending_order(numbers);
    if (!order.empty())
      select(order);
  }

  /// keeps the bubbles `order[0], order[1], …` in this order and forgets the others
  void select(const std::vector<Index>& order)
  {
    bubbles.select(order);
    Bubbles_2::select(numbers, order);
    Bubbles_2::select(owners, order);
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_KNOWN_BUBBLES_2_H
