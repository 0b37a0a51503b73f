// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_SAME_VALUES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_SAME_VALUES_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the value of a parameter on this rank, in a form that any rank can compare and put into words
struct Parameter_value
{
  const char* name;
  std::uint64_t bits;
  std::string (*text)(std::uint64_t bits);
};

/// Collective. All ranks have values of the same parameters, in the same order.
/// \throws std::invalid_argument on all ranks if a value is not the same on all, naming the first such parameter
/// and two of its values
inline void check_same_values(const Communicator& comm, const std::vector<Parameter_value>& values)
{
  const std::size_t n = values.size();
  std::vector<std::uint64_t> first(n);
  for (std::size_t k = 0; k < n; ++k)
    first[k] = values[k].bits;
  check_mpi(MPI_Bcast(first.data(), static_cast<int>(n), MPI_UINT64_T, 0, comm.handle()));
  std::size_t k = 0;
  while (k < n && values[k].bits == first[k])
    ++k;
  const std::int64_t ranks = comm.size();
  const std::int64_t different = comm.smallest(static_cast<std::int64_t>(k) * ranks + comm.rank());
  const std::size_t parameter = static_cast<std::size_t>(different / ranks);
  if (parameter == n)
    return;
  const int rank = static_cast<int>(different % ranks);
  std::uint64_t other = values[parameter].bits;
  check_mpi(MPI_Bcast(&other, 1, MPI_UINT64_T, rank, comm.handle()));
  const Parameter_value& p = values[parameter];
  const std::string text = std::string("Bubble_relaxation_2: parameter ") + p.name + " = " +
                           p.text(first[parameter]) + " on rank 0, but " + p.text(other) + " on rank " +
                           std::to_string(rank);
  comm.all_throw();
  throw std::invalid_argument(text);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECK_SAME_VALUES_H
