// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_COMPACT_NUMBERS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_COMPACT_NUMBERS_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/exchange_known.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Replaces distinct numbers below `end`, of which each rank has some, by 0, 1, … in their order. Each rank counts
/// those of an interval of numbers, which are mostly its own. \pre they ascend
inline void compact_numbers(const Communicator& comm, Sparse_exchange& exchange, std::int64_t end,
                            std::vector<std::int64_t>& numbers)
{
  const std::int64_t ranks = comm.size();
  const auto counting_rank = [&](std::int64_t number) { return static_cast<int>(number * ranks / end); };
  Messages<std::int64_t> out, replies;
  for (auto first = numbers.begin(); first != numbers.end();) { // they ascend, and so do the ranks
    const int rank = counting_rank(*first);
    const auto last = std::find_if(first, numbers.end(), [&](std::int64_t n) { return counting_rank(n) != rank; });
    out[rank].assign(first, last);
    first = last;
  }
  const Messages<std::int64_t> in = exchange(out);
  std::vector<std::int64_t> all;
  for (const auto& message : in)
    all.insert(all.end(), message.second.begin(), message.second.end());
  if (!std::is_sorted(all.begin(), all.end()))
    std::sort(all.begin(), all.end());
  const std::int64_t before = comm.sum_before(static_cast<std::int64_t>(all.size()));
  for (const auto& message : in) {
    auto place = all.begin();
    for (std::int64_t number : message.second) {
      while (*place != number)
        ++place;
      replies[message.first].push_back(before + (place - all.begin()));
    }
  }
  Messages<std::int64_t> answers;
  for (const auto& message : out)
    answers[message.first].resize(message.second.size());
  exchange_known(comm, replies, answers);
  numbers.clear();
  for (const auto& message : answers)
    numbers.insert(numbers.end(), message.second.begin(), message.second.end());
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_COMPACT_NUMBERS_H
