// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_CENSUS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_CENSUS_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Bubble_state_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// How many bubbles all ranks have, and the sum of their numbers, which no migration may change.
class Bubble_census
{
public:
  /// Collective. Bubbles that stay, and those that are sent away.
  Bubble_census(const Communicator& comm, const std::vector<Bubble_state_2>& here,
                const Messages<Bubble_state_2>& leaving)
    : m_comm(comm)
  {
    add(here);
    for (const auto& message : leaving)
      add(message.second);
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, m_values.data(), 2, MPI_UINT64_T, MPI_SUM, comm.handle()));
  }

  /// \throws std::logic_error on all ranks if another census has another result
  void check(const Bubble_census& after) const
  {
    if (m_values == after.m_values)
      return;
    m_comm.all_throw();
    throw std::logic_error("Bubble_relaxation_2: of " + std::to_string(m_values[0]) + " bubbles " +
                           std::to_string(after.m_values[0]) + " have arrived on other ranks, or not the same");
  }

private:
  void add(const std::vector<Bubble_state_2>& states)
  {
    m_values[0] += states.size();
    for (const Bubble_state_2& s : states)
      m_values[1] += static_cast<std::uint64_t>(s.bubble.number);
  }

  const Communicator& m_comm;
  std::array<std::uint64_t, 2> m_values{0, 0}; // sums modulo 2^64 will do
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_CENSUS_H
