// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARED_SETS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARED_SETS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Tells the ranks that have bubbles of ours which neighbours these have. The two ranks of a message name a bubble
/// that one has of the other by its place in the lists of the halo, which are the same on both sides; others that
/// both may have, those of third ranks, by their numbers. What else is in a set the other rank does not know.
class Shared_sets_2
{
public:
  Shared_sets_2(const Halo_2& halo, const Bubbles_2& bubbles) : m_halo(halo), m_bubbles(bubbles) {}

  /// Collective. The sets of others' bubbles become what their owners say, as far as the neighbours are known here.
  void operator()(Communicator& comm, Neighbor_sets_2& sets)
  {
    Messages<std::int64_t> messages;
    for (const auto& list : m_halo.sent())
      tell(list.first, list.second, sets, messages[list.first]);
    const Messages<std::int64_t> in = deliver(comm, messages);
    for (const auto& message : in)
      take(message.first, message.second, sets);
  }

private:
  /// of a bubble that another rank does not know, for all we know
  static constexpr std::int64_t no_name = std::numeric_limits<std::int64_t>::min();

  static std::int64_t name_of_number(std::int64_t number) { return -1 - number; }
  static std::int64_t number_of_name(std::int64_t name) { return -1 - name; }

  static const std::vector<Index>& list_of(const Messages<Index>& lists, int rank)
  {
    static const std::vector<Index> none;
    const auto found = lists.find(rank);
    return found == lists.end() ? none : found->second;
  }

  /// for each bubble of ours that another rank has: how many neighbours are named, and their names
  void tell(int rank, const std::vector<Index>& ours, const Neighbor_sets_2& sets, std::vector<std::int64_t>& message)
  {
    name_bubbles(ours, list_of(m_halo.received(), rank));
    for (Index i : ours) {
      const std::size_t place_of_size = message.size();
      message.push_back(0);
      for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
        if (m_names[*j] != no_name)
          message.push_back(m_names[*j]);
      message[place_of_size] = static_cast<std::int64_t>(message.size() - place_of_size - 1);
    }
  }

  void name_bubbles(const std::vector<Index>& ours, const std::vector<Index>& theirs)
  {
    m_names.resize(m_bubbles.size());
    for (std::size_t i = 0; i < m_names.size(); ++i)
      m_names[i] = m_bubbles.is_ours(i) ? no_name : name_of_number(m_bubbles.id[i]);
    std::int64_t name = 0;
    for (const std::vector<Index>* list : {&ours, &theirs})
      for (Index i : *list)
        m_names[i] = name++;
  }

  void take(int rank, const std::vector<std::int64_t>& message, Neighbor_sets_2& sets)
  {
    const std::vector<Index>&theirs = list_of(m_halo.received(), rank), &ours = list_of(m_halo.sent(), rank);
    const std::int64_t first_of_ours = static_cast<std::int64_t>(theirs.size());
    std::vector<Index> set;
    auto next = message.begin();
    for (Index i : theirs) {
      set.clear();
      for (std::int64_t left = *next++; left > 0; --left) {
        const std::int64_t name = *next++;
        const Index j = name < 0                ? index_of(number_of_name(name))
                        : name < first_of_ours ? theirs[static_cast<std::size_t>(name)]
                                               : ours[static_cast<std::size_t>(name - first_of_ours)];
        if (j != no_index && !m_bubbles.is_gone(j))
          set.push_back(j);
      }
      if (!m_bubbles.is_gone(i))
        sets.assign(i, set);
    }
  }

  /// of one that is here
  Index index_of(std::int64_t number)
  {
    if (m_indices.empty())
      for (std::size_t i = 0; i < m_bubbles.size(); ++i)
        if (!m_bubbles.is_gone(i))
          m_indices[m_bubbles.id[i]] = static_cast<Index>(i);
    const auto found = m_indices.find(number);
    return found == m_indices.end() ? no_index : found->second;
  }

  const Halo_2& m_halo;
  const Bubbles_2& m_bubbles;
  std::vector<std::int64_t> m_names;                 // for the rank that a message is for
  std::unordered_map<std::int64_t, Index> m_indices; // of all, if any is asked for
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SHARED_SETS_2_H
