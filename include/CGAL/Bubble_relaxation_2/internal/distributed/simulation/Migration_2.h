// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_MIGRATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_MIGRATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
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

/// The way of simulated bubbles to the ranks that own their places, and the parts of the ranks, which are cut anew when
/// one has too many.
class Migration_2
{
public:
  Migration_2(Communicator& comm, Traffic_2& traffic)
    : m_comm(comm), m_traffic(traffic)
  {}

  void start(const Hilbert_partition_2& partition) { m_partition = std::make_unique<Hilbert_partition_2>(partition); }

  /// who owns what; it stays in one place
  const Hilbert_partition_2& partition() const { return *m_partition; }

  /// notes how many bubbles took part in a step, here and on all ranks
  void note_step(std::int64_t awake, std::int64_t all_awake)
  {
    constexpr double usual = 1.1; // times the mean
    m_excess = (std::max)(0., m_excess + double(awake) - usual * double(all_awake) / m_comm.size());
  }

  /// whether others have waited so long for this rank since the last migration that `all` bubbles should migrate
  bool is_waited_for(std::int64_t all) const
  {
    constexpr double few = 50; // more bubbles than that make no difference
    return m_excess > m_patience * (double(all) / m_comm.size() + few);
  }

  /// Collective. Cuts the curve anew so that as many moves are to come on each rank, about, if that is worth while.
  void balance(const Simulation_2& simulation, const Bubbles_2& bubbles)
  {
    balance(bubbles, many, [&](std::size_t i) {
      return simulation.memory(static_cast<Index>(i)).is_active != 0 ? moves_of_awake : 1;
    });
    m_excess = 0;
    m_patience = (std::min)(1.25 * m_patience, most_patience);
  }

  /// The same so that each rank has as many bubbles. `most`: there may be so many times more than the mean on one
  void balance(const Bubbles_2& bubbles, double most = many) const
  {
    balance(bubbles, most, [](std::size_t) { return std::int64_t(1); });
  }

  /// Collective. Brings each bubble to the rank that owns its place now, and what the simulation knows of it.
  void send_home(Simulation_2& simulation, Bubbles_2& bubbles) const
  {
    std::vector<Bubble_state_2> ours;
    Messages<Bubble_state_2> out;
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      if (!is_here(bubbles, i))
        continue;
      const int owner = m_partition->owner(bubbles.x[i], bubbles.y[i]);
      (owner == m_comm.rank() ? ours : out[owner])
        .push_back(Bubble_state_2{record(bubbles, i), simulation.memory(static_cast<Index>(i))});
    }
    m_traffic.add(out);
    deliver(m_comm, out, [&](int, const Bubble_state_2& s) { ours.push_back(s); });
    std::sort(ours.begin(), ours.end(),
              [](const Bubble_state_2& s, const Bubble_state_2& t) { return s.bubble.id < t.bubble.id; });
    bubbles = Bubbles_2();
    bubbles.rank = m_comm.rank();
    bubbles.make_room_for(ours.size());
    std::vector<Bubble_memory_2> memories;
    for (const Bubble_state_2& s : ours) {
      add(bubbles, s.bubble, m_comm.rank());
      memories.push_back(s.memory);
    }
    simulation.restart(memories, simulation.is_roused());
  }

private:
  static constexpr double many = 1.01; // times the mean

  /// A migration takes as long as so many moves of each bubble. The first one is not put off until others have waited
  /// as long, since nobody knows how many moves will come; each next one is put off a bit longer than the last.
  static constexpr double most_patience = 8;

  /// How often a bubble that is awake will still move, about; one that sleeps does so once, when all are roused.
  static constexpr std::int64_t moves_of_awake = 40;

  static bool is_here(const Bubbles_2& bubbles, std::size_t i) { return bubbles.is_ours(i) && !bubbles.is_gone(i); }

  /// if a rank has `most` times more work than the mean, so that others wait for it; `work(i)`: of a bubble
  template <class Work>
  void balance(const Bubbles_2& bubbles, double most, const Work& work) const
  {
    std::int64_t here = 0;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      here += is_here(bubbles, i) ? work(i) : 0;
    const double few = 160 * (most - 1); // more than that makes no difference
    const double mean = double(m_comm.sum(here)) / m_comm.size();
    if (!(double(m_comm.largest(here)) > most * mean + few))
      return;
    std::vector<std::pair<Hilbert_curve_2::Key, std::int64_t>> places;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (is_here(bubbles, i))
        places.emplace_back(m_partition->curve().key(bubbles.x[i], bubbles.y[i]), work(i));
    std::sort(places.begin(), places.end());
    std::vector<std::int64_t> before(1, 0); // the work of all before
    for (const auto& place : places)
      before.push_back(before.back() + place.second);
    *m_partition = even_partition(
      m_comm, m_partition->curve(), places, [](const auto& place) { return place.first; },
      [&before](std::int64_t n) { return before[static_cast<std::size_t>(n)]; });
  }

  Communicator& m_comm;
  Traffic_2& m_traffic;
  std::unique_ptr<Hilbert_partition_2> m_partition;
  double m_excess = 0;     // moves here, more than usual, since the last migration
  double m_patience = 0.3; // until the next one, in moves of each bubble
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_MIGRATION_2_H
