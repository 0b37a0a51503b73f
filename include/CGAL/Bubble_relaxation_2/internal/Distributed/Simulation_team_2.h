// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Moves_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/place_distributed.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The ranks that simulate bubbles together: each moves its own, and is told of others' before the next step.
class Simulation_team_2
{
public:
  static constexpr bool is_alone = false;

  Simulation_team_2(const Communicator& comm, Sparse_exchange& exchange, Agreement& agreement, bool may_be_stopped)
    : m_comm(comm), m_exchange(exchange), m_agreement(agreement), m_halo(comm, exchange), m_moves(comm),
      m_may_be_stopped(comm.any(may_be_stopped))
  {}

  /// Begins with bubbles that are numbered from 0 on, each on the rank that owns its place, sorted.
  void start(const Placed_part_2& part, Bubbles_2& bubbles)
  {
    m_partition = std::make_unique<Hilbert_partition_2>(part.partition);
    m_number_of_all = static_cast<std::size_t>(m_comm.sum(static_cast<std::int64_t>(part.bubbles.size())));
    std::vector<Bubble_state_2> ours;
    for (std::size_t i = 0; i < part.bubbles.size(); ++i)
      ours.push_back(initial_state(part.bubbles.bubbles, i, part.bubbles.numbers[i]));
    std::vector<Bubble_memory_2> memories;
    surround(ours, bubbles, memories);
  }

  /// Brings each bubble to the rank that owns its place now, and surrounds all anew.
  template <class Simulation>
  void surround_anew(Simulation& simulation, Bubbles_2& bubbles)
  {
    std::vector<Bubble_state_2> ours;
    Messages<Bubble_state_2> out;
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      if (!bubbles.is_ours(i) || bubbles.is_gone(i))
        continue;
      const int owner = m_partition->owner(bubbles.x[i], bubbles.y[i]);
      const Index index = static_cast<Index>(i);
      (owner == m_comm.rank() ? ours : out[owner])
        .push_back(Bubble_state_2{record(bubbles, i, bubbles.number[i]), simulation.memory(index)});
    }
    const Census before = census(ours, out);
    for (const auto& message : m_exchange(out))
      ours.insert(ours.end(), message.second.begin(), message.second.end());
    check_census(before, census(ours, {}));
    std::sort(ours.begin(), ours.end());
    std::vector<Bubble_memory_2> memories;
    surround(ours, bubbles, memories);
    simulation.restart(memories);
  }

  std::size_t number_of_all(const Bubbles_2&) const { return m_number_of_all; }

  bool is_at_border(Index i) const { return m_halo.is_at_border(i); }

  void send_moves(const Bubbles_2& b, const std::vector<Index>& active, const std::vector<char>& is_moving)
  {
    m_moves.send(b, active, is_moving);
  }

  const std::vector<Index>& receive_moves(Bubbles_2& b, const std::vector<Index>& active,
                                          std::vector<char>& is_moving)
  {
    for (Index i : active)
      m_is_outgrown_here = m_is_outgrown_here || m_halo.is_outgrown_by(b, i);
    m_others.clear();
    m_moves.receive(b, m_others, is_moving);
    return m_others;
  }

  Step_sums sum(const Step_sums& sums)
  {
    std::array<std::int64_t, 4> values{static_cast<std::int64_t>(sums.restless),
                                       static_cast<std::int64_t>(sums.outrun), m_agreement.has_failed(),
                                       m_is_outgrown_here};
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, values.data(), 4, MPI_INT64_T, MPI_SUM, m_comm.handle()));
    if (values[2] != 0)
      m_agreement.reach();
    m_is_outgrown = values[3] != 0;
    m_is_outgrown_here = false;
    return Step_sums{static_cast<std::size_t>(values[0]), static_cast<std::size_t>(values[1])};
  }

  bool goes_on(bool here) const { return m_may_be_stopped ? !m_comm.any(!here) : here; }

  /// whether a bubble of any rank has gone so far that the halo is to be made anew
  bool is_outgrown() const { return m_is_outgrown; }

  const Halo_2& halo() const { return m_halo; }

private:
  /// how many bubbles all ranks have, and the sum of their numbers
  struct Census
  {
    std::int64_t count, sum;
  };

  Census census(const std::vector<Bubble_state_2>& ours, const Messages<Bubble_state_2>& leaving) const
  {
    std::array<std::uint64_t, 2> values{0, 0}; // sums modulo 2^64 will do
    const auto add = [&values](const std::vector<Bubble_state_2>& states) {
      values[0] += states.size();
      for (const Bubble_state_2& s : states)
        values[1] += static_cast<std::uint64_t>(s.bubble.number);
    };
    add(ours);
    for (const auto& message : leaving)
      add(message.second);
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, values.data(), 2, MPI_UINT64_T, MPI_SUM, m_comm.handle()));
    return Census{static_cast<std::int64_t>(values[0]), static_cast<std::int64_t>(values[1])};
  }

  void check_census(const Census& before, const Census& after)
  {
    if (before.count == after.count && before.sum == after.sum)
      return;
    m_comm.all_throw(); // all have the same sums
    throw std::logic_error("Bubble_relaxation_2: of " + std::to_string(before.count) + " bubbles " +
                           std::to_string(after.count) + " have arrived on other ranks, or not the same");
  }

  void surround(const std::vector<Bubble_state_2>& ours, Bubbles_2& bubbles, std::vector<Bubble_memory_2>& memories)
  {
    m_halo.surround(*m_partition, ours, bubbles, memories);
    m_moves.connect(m_halo, bubbles.size());
    m_is_outgrown = false;
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  Agreement& m_agreement;
  std::unique_ptr<Hilbert_partition_2> m_partition;
  Halo_2 m_halo;
  Moves_exchange_2 m_moves;
  std::size_t m_number_of_all = 0;
  bool m_may_be_stopped, m_is_outgrown_here = false, m_is_outgrown = false;
  std::vector<Index> m_others;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_TEAM_2_H
