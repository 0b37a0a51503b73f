// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ADD_UP_REPORT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ADD_UP_REPORT_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. Makes of what each rank did in the simulation what all did together.
template <class Report>
void add_up_report(const Communicator& comm, Report& report)
{
  const std::array<std::size_t*, 4> counts{&report.number_of_moves, &report.number_of_insertions,
                                           &report.number_of_deletions, &report.number_of_returns};
  std::array<std::uint64_t, 4> sums;
  for (std::size_t k = 0; k < counts.size(); ++k)
    sums[k] = *counts[k];
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_UINT64_T, MPI_SUM,
                          comm.handle()));
  for (std::size_t k = 0; k < counts.size(); ++k)
    *counts[k] = static_cast<std::size_t>(sums[k]);
}

/// Collective. Each phase takes as long as on the slowest rank.
template <class Seconds>
void find_slowest(const Communicator& comm, Seconds& s)
{
  const std::array<double*, 8> phases{&s.reading,    &s.placement, &s.renewal, &s.motion,
                                      &s.population, &s.treatment, &s.writing, &s.evaluation};
  std::array<double, 8> seconds;
  for (std::size_t k = 0; k < phases.size(); ++k)
    seconds[k] = *phases[k];
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, seconds.data(), static_cast<int>(seconds.size()), MPI_DOUBLE, MPI_MAX,
                          comm.handle()));
  for (std::size_t k = 0; k < phases.size(); ++k)
    *phases[k] = seconds[k];
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ADD_UP_REPORT_H
