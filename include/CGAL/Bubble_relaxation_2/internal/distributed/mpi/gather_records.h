// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_GATHER_RECORDS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_GATHER_RECORDS_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. The records of all ranks, one rank after the other: for what is small against the bubbles.
/// \throws std::length_error on all ranks if they have more than 2^31 bytes
template <class T>
std::vector<T> gather_records(const Communicator& comm, const std::vector<T>& own)
{
  static_assert(std::is_trivially_copyable<T>::value, "records are sent as bytes");
  const std::int64_t bytes = static_cast<std::int64_t>(own.size() * sizeof(T)), all_bytes = comm.sum(bytes);
  if (all_bytes > (std::numeric_limits<int>::max)()) {
    comm.all_throw();
    throw std::length_error("Bubble_relaxation_2: the bubbles on the edges of the domain have more than "
                            "2^31 bytes");
  }
  const int size = static_cast<int>(bytes);
  std::vector<int> sizes(static_cast<std::size_t>(comm.size())), offsets(sizes.size(), 0);
  check_mpi(MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm.handle()));
  for (std::size_t k = 1; k < sizes.size(); ++k)
    offsets[k] = offsets[k - 1] + sizes[k - 1];
  std::vector<T> all(static_cast<std::size_t>(all_bytes) / sizeof(T));
  check_mpi(MPI_Allgatherv(own.data(), size, MPI_BYTE, all.data(), sizes.data(), offsets.data(), MPI_BYTE,
                           comm.handle()));
  return all;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_GATHER_RECORDS_H
