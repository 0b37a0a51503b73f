// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors
#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_SETS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_SETS_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Neighbour sets on their way from one rank to another, as numbers of bubbles.
class Numbered_sets
{
public:
  /// the set of a bubble is to go to a rank
  void add(int rank, const Bubbles_2& b, const Neighbor_sets_2& sets, Index i)
  {
    std::vector<std::int64_t>& message = m_messages[rank];
    message.push_back(b.number[i]);
    message.push_back(sets.end(i) - sets.begin(i));
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
      message.push_back(b.number[*j]);
  }

  /// Collective. Sends them, and gets those that are for this rank.
  void exchange(Sparse_exchange& exchange) { m_messages = exchange(m_messages); }

  /// calls `take(bubble, set)` for each set that this rank got, with the bubbles that it knows
  template <class Take>
  void for_each(const Bubbles_2& b, const Take& take) const
  {
    std::unordered_map<std::int64_t, Index> indices;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_gone(i))
        indices[b.number[i]] = static_cast<Index>(i);
    std::vector<Index> set;
    for (const auto& message : m_messages)
      for (std::size_t k = 0; k < message.second.size();) {
        const std::int64_t number = message.second[k];
        const std::size_t first = k + 2;
        k = first + static_cast<std::size_t>(message.second[k + 1]);
        set.clear();
        for (std::size_t n = first; n < k; ++n) {
          const auto found = indices.find(message.second[n]);
          if (found != indices.end())
            set.push_back(found->second);
        }
        const auto bubble = indices.find(number);
        if (bubble != indices.end()) // else it is gone
          take(bubble->second, set);
      }
  }

private:
  Messages<std::int64_t> m_messages;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_NUMBERED_SETS_H
