// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_KNOWN_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_KNOWN_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_KNOWN_BUBBLES_2_H
