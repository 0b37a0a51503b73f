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
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The way of simulated bubbles to the ranks that own their places, and the parts of the ranks, which are cut anew when
/// one has too many.
class Migration_2
{
public:
  Migration_2(Communicator& comm, Traffic_2& traffic)
    : m_comm(comm), m_traffic(traffic)
  {}

  void start(const Hilbert_partition_2& partition)
  {
    m_partition = std::make_unique<Hilbert_partition_2>(partition);
  }

  /// who owns what; it stays in one place
  const Hilbert_partition_2& partition() const { return *m_partition; }

  /// Collective. Whether a rank has so many more bubbles than the mean that all should migrate.
  bool is_due(const Bubbles_2& bubbles) const { return is_unbalanced(bubbles, too_many); }

  /// Collective. Cuts the curve anew so that each rank has as many bubbles, if that is worth while. When bubbles
  /// migrate often it is so less often.
  void balance(const Bubbles_2& bubbles, bool is_often)
  {
    if (!is_unbalanced(bubbles, is_often ? too_many : many))
      return;
    std::vector<Hilbert_curve_2::Key> keys;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (is_here(bubbles, i))
        keys.push_back(m_partition->curve().key(bubbles.x[i], bubbles.y[i]));
    std::sort(keys.begin(), keys.end());
    *m_partition = even_partition(m_comm, m_partition->curve(), keys);
  }

  /// Collective. Brings each bubble to the rank that owns its place now, and what the simulation knows of it.
  void send_home(Simulation_2& simulation, Bubbles_2& bubbles) const
  {
    std::vector<Bubble_state_2> ours;
    Messages<Bubble_state_2> out;
    Census census{}; // before and after
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      if (!is_here(bubbles, i))
        continue;
      ++census[0];
      census[1] += static_cast<std::uint64_t>(bubbles.id[i]);
      const int owner = m_partition->owner(bubbles.x[i], bubbles.y[i]);
      (owner == m_comm.rank() ? ours : out[owner])
        .push_back(bubble_state(bubbles, i, simulation.memory(static_cast<Index>(i))));
    }
    m_traffic.add_messages(out);
    for (const auto& message : deliver(m_comm, out))
      ours.insert(ours.end(), message.second.begin(), message.second.end());
    std::sort(ours.begin(), ours.end());
    bubbles = Bubbles_2();
    bubbles.rank = m_comm.rank();
    bubbles.make_room_for(ours.size());
    std::vector<Bubble_memory_2> memories;
    for (const Bubble_state_2& s : ours) {
      add(bubbles, s.bubble(), m_comm.rank());
      memories.push_back(s.memory());
      ++census[2];
      census[3] += static_cast<std::uint64_t>(s.id);
    }
    check(census);
    simulation.restart(memories, simulation.is_roused());
  }

private:
  /// more bubbles than the mean: so many that all migrate, and so many that they migrate to other parts if they do
  static constexpr double too_many = 1.1, many = 1.01;

  /// How many bubbles there are, and the sum of their numbers modulo 2^64, before and after a migration, which may not
  /// change these for all ranks together.
  using Census = std::array<std::uint64_t, 4>;

  /// Collective. \throws std::logic_error on all ranks if bubbles were lost
  void check(Census census) const
  {
    m_comm.reduce_each(census, MPI_SUM);
    if (census[0] != census[2] || census[1] != census[3])
      m_comm.throw_on_all(std::logic_error("Bubble_relaxation_2: of " + std::to_string(census[0]) + " bubbles " +
                                           std::to_string(census[2]) + " have arrived on other ranks, or not the same"));
  }

  static bool is_here(const Bubbles_2& bubbles, std::size_t i) { return bubbles.is_ours(i) && !bubbles.is_gone(i); }

  /// Collective. Whether a rank has so many times more bubbles than the mean that others wait for it.
  bool is_unbalanced(const Bubbles_2& bubbles, double most) const
  {
    const double few = 160 * (most - 1); // bubbles more than that make no difference
    std::int64_t n = 0;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      n += is_here(bubbles, i);
    return double(m_comm.largest(n)) > most * double(m_comm.sum(n)) / m_comm.size() + few;
  }

  Communicator& m_comm;
  Traffic_2& m_traffic;
  std::unique_ptr<Hilbert_partition_2> m_partition;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_MIGRATION_2_H
