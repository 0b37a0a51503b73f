// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_HALO_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_HALO_2_H

#include <CGAL/Bubble_relaxation_2/internal/Boundary_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Bubble_state_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The bubbles of other ranks that lie around those of one, and who knows which of its own. Two bubbles nearer to
/// each other than `reach` times the size of the larger one are known to the owners of both: each is sent to the
/// ranks whose parts a disc around it meets, and a rank that gets to know one that is larger than its own sends
/// those to its owner.
///
/// This holds for where the bubbles were when the halo was made. It stays good enough, for `needed_reach`,
/// while none has gone far; `is_outgrown_by()` tells.
class Halo_2
{
public:
  using Ranks = Hilbert_partition_2::Ranks;

  /// In sizes: a star is looked for up to 5.1 sizes away. Bubbles may go as far as the second until the halo is
  /// to be renewed, and then with the step in which they do.
  static constexpr double needed_reach = 5.1, most_moved = 0.3,
                          reach = needed_reach + 2 * (most_moved + Boundary_2::longest_step);

  Halo_2(const Communicator& comm, Sparse_exchange& exchange) : m_comm(comm), m_exchange(exchange) {}

  /// the bubbles of this rank, sorted by their numbers, and those of others around them
  void surround(const Hilbert_partition_2& partition, const std::vector<Bubble_state_2>& ours,
                Bubbles_2& bubbles, std::vector<Bubble_memory_2>& memories)
  {
    m_partition = &partition;
    m_places.clear();
    std::vector<Ranks> holders(ours.size());
    Messages<Bubble_state_2> out;
    for (std::size_t k = 0; k < ours.size(); ++k)
      find_holders(ours, k, holders[k], out);
    std::vector<Owned> others;
    receive(out, others);
    send_smaller_ones(ours, others, holders, out);
    receive(out, others);
    merge(ours, others, holders, bubbles, memories);
  }

  /// for each neighbouring rank, the bubbles that it has of ours, and those that we have of it, by their numbers
  const Messages<Index>& sent() const { return m_sent; }
  const Messages<Index>& received() const { return m_received; }

  bool is_at_border(Index i) const { return m_is_at_border[i] != 0; }

  /// whether a bubble of ours has gone so far, or grown so much, that the halo may lack something
  bool is_outgrown_by(const Bubbles_2& b, Index i) const
  {
    const Place& p = m_places[i];
    const double moved = std::hypot(b.x[i] - p.x, b.y[i] - p.y);
    return moved > p.most_moved || needed_reach * b.d[i] + moved > p.largest_disc;
  }

private:
  /// a bubble of another rank
  struct Owned
  {
    int owner;
    Bubble_state_2 state;
  };

  /// Where a bubble of ours was when the halo was made, and how far it may go and its disc may reach.
  struct Place
  {
    double x, y, clearance, most_moved, largest_disc;
  };

  static constexpr double look_ahead = 4;

  /// the ranks near a bubble of ours
  void find_holders(const std::vector<Bubble_state_2>& ours, std::size_t k, Ranks& holders,
                    Messages<Bubble_state_2>& out)
  {
    const Bubble_record_2& b = ours[k].bubble;
    double clearance = 0; // nothing of others is nearer
    if (k > 0) {
      const Place& last = m_places.back();
      clearance = (1 - 1e-9) * last.clearance - std::hypot(b.x - last.x, b.y - last.y);
    }
    const double far = reach * b.d;
    if (clearance < far) {
      const Ranks all = m_partition->owners_in_disc(b.x, b.y, look_ahead * far);
      clearance = all == Ranks(1, m_comm.rank()) ? look_ahead * far : 0;
    }
    // a larger bubble of others, this far away, has as much of a margin in its own size
    const double margin = most_moved * (std::max)(b.d, clearance / (reach + most_moved)),
                 own_margin = (most_moved + Boundary_2::longest_step) * b.d;
    m_places.push_back(Place{b.x, b.y, clearance, margin, (std::max)(clearance, far) - own_margin});
    if (clearance == 0)
      for (int rank : m_partition->owners_in_disc(b.x, b.y, far))
        if (rank != m_comm.rank()) {
          holders.push_back(rank);
          out[rank].push_back(ours[k]);
        }
  }

  void receive(Messages<Bubble_state_2>& out, std::vector<Owned>& others)
  {
    for (const auto& message : m_exchange(out))
      for (const Bubble_state_2& s : message.second)
        others.push_back(Owned{message.first, s});
    out.clear();
  }

  void send_smaller_ones(const std::vector<Bubble_state_2>& ours, const std::vector<Owned>& others,
                         std::vector<Ranks>& holders, Messages<Bubble_state_2>& out) const
  {
    if (others.empty() || ours.empty())
      return;
    const Bubble_record_2& first = ours.front().bubble;
    Bubble_buckets_2 buckets(2 * reach, first.d, first.x, first.y, ours.size());
    for (std::size_t k = 0; k < ours.size(); ++k)
      buckets.insert(static_cast<Index>(k), ours[k].bubble.x, ours[k].bubble.y, ours[k].bubble.d);
    for (const Owned& other : others) {
      const Bubble_record_2& b = other.state.bubble;
      const double far = reach * b.d;
      buckets.for_each_near(b.x, b.y, b.d, [&](Index k, double squared, double) {
        Ranks& ranks = holders[k];
        if (squared < far * far && std::find(ranks.begin(), ranks.end(), other.owner) == ranks.end()) {
          ranks.push_back(other.owner);
          out[other.owner].push_back(ours[k]);
        }
        return true;
      });
    }
  }

  /// all in the order of their numbers, with lists of who tells whom of which
  void merge(const std::vector<Bubble_state_2>& ours, std::vector<Owned>& others,
             const std::vector<Ranks>& holders, Bubbles_2& bubbles, std::vector<Bubble_memory_2>& memories)
  {
    std::sort(others.begin(), others.end(), [](const Owned& a, const Owned& b) { return a.state < b.state; });
    bubbles = Bubbles_2();
    bubbles.make_room_for(ours.size() + others.size());
    memories.clear();
    m_sent.clear();
    m_received.clear();
    m_is_at_border.clear();
    std::vector<Place> places;
    std::size_t k = 0, l = 0;
    while (k < ours.size() || l < others.size()) {
      const Index i = static_cast<Index>(bubbles.size());
      const bool is_foreign = k == ours.size() || (l < others.size() && others[l].state < ours[k]);
      const Bubble_state_2& s = is_foreign ? others[l].state : ours[k];
      add(bubbles, s.bubble, is_foreign);
      memories.push_back(s.memory);
      m_is_at_border.push_back(!is_foreign && !holders[k].empty());
      places.push_back(is_foreign ? Place{} : m_places[k]);
      if (is_foreign)
        m_received[others[l++].owner].push_back(i);
      else
        for (int rank : holders[k++])
          m_sent[rank].push_back(i);
    }
    m_places.swap(places);
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  const Hilbert_partition_2* m_partition = nullptr;
  Messages<Index> m_sent, m_received;
  std::vector<char> m_is_at_border;
  std::vector<Place> m_places; // of each bubble; meaningless for those of others
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_HALO_2_H
