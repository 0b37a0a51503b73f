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
#include <numeric>
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
    : bubbles(own.bubbles), numbers(own.numbers), owners(own.numbers.size(), rank)
  {}

  std::size_t size() const { return numbers.size(); }

  /// of a bubble with a number, `no_index` if there is none
  /// \pre they are sorted
  Index index(std::int64_t number) const
  {
    const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
    return found != numbers.end() && *found == number ? static_cast<Index>(found - numbers.begin()) : no_index;
  }

  void add(const Bubble_record_2& r, int owner)
  {
    internal::add(bubbles, r);
    numbers.push_back(r.number);
    owners.push_back(owner);
  }

  void sort()
  {
    if (std::is_sorted(numbers.begin(), numbers.end()))
      return;
    std::vector<Index> order(size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(), [this](Index i, Index j) { return numbers[i] < numbers[j]; });
    select(order);
  }

  /// keeps the bubbles `order[0], order[1], …` in this order and forgets the others
  void select(const std::vector<Index>& order)
  {
    bubbles.select(order);
    std::vector<std::int64_t> selected_numbers;
    std::vector<std::int32_t> selected_owners;
    for (Index i : order) {
      selected_numbers.push_back(numbers[i]);
      selected_owners.push_back(owners[i]);
    }
    numbers.swap(selected_numbers);
    owners.swap(selected_owners);
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_KNOWN_BUBBLES_2_H
