// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_NUMBERED_SETS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_NUMBERED_SETS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Neighbour sets on their way from one rank to another, as numbers of bubbles.
class Numbered_sets
{
public:
  /// the set of a bubble is to go to a rank
  void add(int rank, const Bubbles_2& b, const Neighbor_sets_2& sets, Index i)
  {
    std::vector<std::int64_t>& message = m_messages[rank];
    message.insert(message.end(), {b.id[i], sets.end(i) - sets.begin(i)});
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
      message.push_back(b.id[*j]);
  }

  /// Collective. Sends them, and gets those that are for this rank.
  void send(Communicator& comm) { m_messages = deliver(comm, m_messages); }

  /// Calls `take(bubble, set)` for each set that this rank got, with the bubbles that it knows. `indices`: by numbers
  template <class Take>
  void for_each(const Bubbles_2& b, const std::unordered_map<std::int64_t, Index>& indices, const Take& take) const
  {
    const auto index = [&](std::int64_t number) {
      const auto found = indices.find(number);
      return found == indices.end() || b.is_gone(found->second) ? no_index : found->second;
    };
    std::vector<Index> set;
    for (const auto& message : m_messages)
      for (auto next = message.second.begin(); next != message.second.end();) {
        const Index i = index(*next++);
        set.clear();
        for (std::int64_t left = *next++; left > 0; --left) {
          const Index j = index(*next++);
          if (j != no_index)
            set.push_back(j);
        }
        if (i != no_index)
          take(i, set);
      }
  }

private:
  Messages<std::int64_t> m_messages;
};

/// Collective. Tells the ranks that have bubbles of ours which neighbours these have: the sets of others' bubbles
/// become what their owners say, as far as the neighbours are known here.
inline void share_sets(Communicator& comm, const Halo_2& halo, const Bubbles_2& bubbles, Neighbor_sets_2& sets)
{
  Numbered_sets messages;
  for (const auto& list : halo.lists().sent)
    for (Index i : list.second)
      messages.add(list.first, bubbles, sets, i);
  messages.send(comm);
  messages.for_each(bubbles, halo.indices_at_border(bubbles),
                    [&sets](Index i, const std::vector<Index>& set) { sets.assign(i, set); });
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_NUMBERED_SETS_H
