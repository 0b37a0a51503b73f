// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARE_SETS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARE_SETS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

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
    message.push_back(b.id[i]);
    message.push_back(sets.end(i) - sets.begin(i));
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
      message.push_back(b.id[*j]);
  }

  /// Collective. Sends them, and gets those that are for this rank.
  void send(Communicator& comm) { m_messages = deliver(comm, m_messages); }

  /// calls `take(bubble, set)` for each set that this rank got, with the bubbles that it knows
  template <class Take>
  void for_each(const Bubbles_2& b, const Take& take) const
  {
    std::unordered_map<std::int64_t, Index> indices;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_gone(i))
        indices[b.id[i]] = static_cast<Index>(i);
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

/// Collective. Tells the ranks that have bubbles of ours which neighbours these have: the sets of others' bubbles become
/// what their owners say, as far as the neighbours are known here. Sets come in the order of the lists of the halo, which
/// is the same on both sides.
inline void share_sets(Communicator& comm, const Halo_2& halo, const Bubbles_2& bubbles, Neighbor_sets_2& sets)
{
  Messages<std::int64_t> out; // for each bubble how many neighbours are named, and their numbers
  for (const auto& list : halo.sent()) {
    std::vector<std::int64_t>& message = out[list.first];
    for (Index i : list.second) {
      const std::size_t place_of_size = message.size();
      message.push_back(0);
      for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
        if (halo.may_know(list.first, *j))
          message.push_back(bubbles.id[*j]);
      message[place_of_size] = static_cast<std::int64_t>(message.size() - place_of_size - 1);
    }
  }
  const std::unordered_map<std::int64_t, Index> indices = halo.indices_at_border(bubbles);
  std::vector<Index> set;
  for (const auto& message : deliver(comm, out)) {
    auto next = message.second.begin();
    for (Index i : halo.received().at(message.first)) {
      set.clear();
      for (std::int64_t left = *next++; left > 0; --left) {
        const auto found = indices.find(*next++);
        if (found != indices.end() && !bubbles.is_gone(found->second))
          set.push_back(found->second);
      }
      if (!bubbles.is_gone(i))
        sets.assign(i, set);
    }
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARE_SETS_H
