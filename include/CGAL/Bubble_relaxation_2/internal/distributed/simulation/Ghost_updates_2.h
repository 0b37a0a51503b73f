// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_GHOST_UPDATES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_GHOST_UPDATES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Finds bubbles as `Neighbor_sets_2` does, but where they are now and not by references.
class Position_index_2
{
public:
  explicit Position_index_2(const Bubbles_2& b)
    : m_buckets(1., b.size() == 0 ? 1. : b.d[0], b.size() == 0 ? 0. : b.x[0], b.size() == 0 ? 0. : b.y[0], b.size())
  {
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_gone(i))
        add(b, static_cast<Index>(i));
  }

  void add(const Bubbles_2& b, Index i) { m_buckets.insert(i, b.x[i], b.y[i], b.d[i]); }

  template <class Visitor>
  void find_within(double x, double y, double d, double near, const Visitor& visit) const
  {
    m_buckets.for_each_within(x, y, near * d, [&visit](const auto& e, double) { return visit(e.id), true; });
  }

  template <class Visitor>
  void find_large(double x, double y, double least, double near, const Visitor& visit) const
  {
    m_buckets.for_each_large(x, y, least, near, [&visit](const auto& e, double) { return visit(e.id), true; });
  }

private:
  Bubble_buckets_2 m_buckets;
};

/// The protocol of section 2.2.1 of the paper: ranks tell each other of their bubbles every so many steps only.
/// In between each takes those of others to be where they were; and a bubble that moves into another's part is
/// marked, and stays where it is until it goes there.
class Exchange_interval_2
{
public:
  /// `steps` between exchanges; 0: the protocol is not used
  explicit Exchange_interval_2(std::size_t steps) : m_steps(steps) {}

  bool is_used() const { return m_steps != 0; }
  bool is_due() const { return m_is_due || m_steps_since >= m_steps; }

  /// the next exchange is to be before the next step
  void make_due() { m_is_due = true; }

  void start_stage()
  {
    m_is_due = false;
    m_steps_since = 0;
  }

  void count_step() { ++m_steps_since; }

  /// whether bubbles may have moved since others were told of them
  bool is_stale() const { return is_used() && m_steps_since > 1; }

  /// A bubble of ours that has left our part rests, as one of others would, but keeps its velocity.
  void mark(Bubbles_2& b, Index i)
  {
    b.owner[i] = nobody;
    m_marked.push_back(Marked{i, b.vx[i], b.vy[i]});
  }

  bool has_marked() const { return !m_marked.empty(); }

  /// lets the marked bubbles move again, and calls `wake(i)` for each
  template <class Wake>
  void release(Bubbles_2& b, const Wake& wake)
  {
    for (const Marked& m : m_marked) {
      b.owner[m.bubble] = b.rank;
      b.vx[m.bubble] = m.vx;
      b.vy[m.bubble] = m.vy;
      wake(m.bubble);
    }
    m_marked.clear();
  }

private:
  static constexpr std::int32_t nobody = -1;

  struct Marked
  {
    Index bubble;
    double vx, vy;
  };

  std::size_t m_steps, m_steps_since = 0;
  bool m_is_due = false;
  std::vector<Marked> m_marked;
};

/// Tells neighbouring ranks after each step where the bubbles at the border are that took part in it. What is sent is
/// only what moved.
class Move_messages_2
{
public:
  Move_messages_2(const Communicator& comm, Traffic_2& traffic) : m_delivery(comm), m_traffic(traffic) {}

  /// for the bubbles that the halo knows now
  void connect(const Halo_2& halo, std::size_t number_of_bubbles)
  {
    const bool is_new = halo.number_of_changes() != m_number_of_changes;
    if (is_new)
      m_targets.clear();
    m_targets.resize(number_of_bubbles);
    if (!is_new)
      return;
    m_number_of_changes = halo.number_of_changes();
    m_out.clear();
    m_in.clear();
    for (const auto& list : halo.sent()) {
      m_out[list.first];
      for (std::size_t position = 0; position < list.second.size(); ++position)
        m_targets.add(list.second[position], {list.first, static_cast<std::int32_t>(position)});
    }
  }

  /// begins; `is_moving[k]` goes with the `k`-th of `active`
  void send(const Halo_2& halo, const Bubbles_2& b, const std::vector<Index>& active,
            const std::vector<char>& is_moving)
  {
    for (auto& message : m_out)
      message.second.clear();
    for (std::size_t k = 0; k < active.size(); ++k) {
      const Index i = active[k];
      for (const Target& t : m_targets[i])
        m_out[t.rank].push_back(Move{b.x[i], b.y[i], b.d[i], t.position, is_moving[k]});
    }
    for (const auto& message : m_out)
      m_traffic.add_message(message.second.size() * sizeof(Move));
    for (const auto& list : halo.received())
      m_in[list.first].resize(list.second.size()); // if all move
    m_delivery.start(m_out, m_in);
  }

  /// ends: moves the bubbles of others, adds them to `moved`, and whether they move on to `is_moving`
  void receive(const Halo_2& halo, Bubbles_2& b, std::vector<Index>& moved, std::vector<char>& is_moving)
  {
    m_delivery.finish();
    for (const auto& list : halo.received())
      for (const Move& m : m_in[list.first]) {
        const Index i = list.second[static_cast<std::size_t>(m.position)];
        b.x[i] = m.x;
        b.y[i] = m.y;
        b.d[i] = m.d;
        moved.push_back(i);
        is_moving.push_back(static_cast<char>(m.is_moving));
      }
  }

private:
  struct Move
  {
    double x, y, d;
    std::int32_t position, is_moving;
  };

  /// a bubble's place in one of the messages
  struct Target
  {
    std::int32_t rank, position;
  };

  Expected_delivery<Move> m_delivery;
  Traffic_2& m_traffic;
  std::size_t m_number_of_changes = 0; // of the halo, when it was connected
  Lists_of_few<Target> m_targets;      // of each bubble
  Messages<Move> m_out, m_in;
};

/// Tells neighbouring ranks where bubbles are at the stages of a step.
class Stage_messages_2
{
public:
  explicit Stage_messages_2(const Communicator& comm) : m_delivery(comm) {}

  /// Collective. Begins to tell where our bubbles are. `receive()` has to follow.
  void send(const Halo_2& halo, const std::vector<double>& x, const std::vector<double>& y)
  {
    m_out.clear();
    m_in.clear();
    for (const auto& list : halo.sent())
      for (Index i : list.second)
        m_out[list.first].push_back(Place{x[i], y[i]});
    for (const auto& list : halo.received())
      m_in[list.first].resize(list.second.size());
    m_delivery.start(m_out, m_in);
  }

  /// Collective. Puts in where the bubbles of others are. \pre `send()` was called, and the halo has not changed
  void receive(const Halo_2& halo, std::vector<double>& x, std::vector<double>& y)
  {
    m_delivery.finish();
    for (const auto& list : halo.received())
      for (std::size_t n = 0; n < list.second.size(); ++n) {
        x[list.second[n]] = m_in[list.first][n].x;
        y[list.second[n]] = m_in[list.first][n].y;
      }
  }

private:
  struct Place
  {
    double x, y;
  };

  Expected_delivery<Place> m_delivery;
  Messages<Place> m_out, m_in;
};

/// Neighbour sets on their way from one rank to another, as numbers of bubbles.
class Numbered_sets
{
public:
  /// the set of a bubble is to go to a rank, which has those for which `may_know(j)` holds
  template <class May_know>
  void add(int rank, const Bubbles_2& b, const Neighbor_sets_2& sets, Index i, const May_know& may_know)
  {
    std::vector<std::int64_t>& message = m_messages[rank];
    message.push_back(b.id[i]);
    const std::size_t place_of_size = message.size();
    message.push_back(0);
    for (const Index *j = sets.begin(i), *end = sets.end(i); j != end; ++j)
      if (may_know(*j))
        message.push_back(b.id[*j]);
    message[place_of_size] = static_cast<std::int64_t>(message.size() - place_of_size - 1);
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
  for (const auto& list : halo.sent())
    for (Index i : list.second)
      messages.add(list.first, bubbles, sets, i, [&](Index j) { return halo.may_know(list.first, j); });
  messages.send(comm);
  messages.for_each(bubbles, halo.indices_at_border(bubbles),
                    [&sets](Index i, const std::vector<Index>& set) { sets.assign(i, set); });
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_GHOST_UPDATES_2_H
