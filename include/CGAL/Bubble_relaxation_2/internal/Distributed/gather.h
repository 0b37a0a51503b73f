// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_GATHER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_GATHER_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The records of all ranks, one rank's after another's, on each of them: for what all have to have.
template <class T>
std::vector<T> gather_on_all(const Communicator& comm, const std::vector<T>& ours)
{
  static_assert(std::is_trivially_copyable<T>::value, "records are sent as bytes");
  MPI_Datatype record;
  check_mpi(MPI_Type_contiguous(static_cast<int>(sizeof(T)), MPI_BYTE, &record));
  check_mpi(MPI_Type_commit(&record));
  const int n = static_cast<int>(ours.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size())), firsts(counts.size());
  check_mpi(MPI_Allgather(&n, 1, MPI_INT, counts.data(), 1, MPI_INT, comm.handle()));
  int all = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    firsts[k] = all;
    all += counts[k];
  }
  std::vector<T> result(static_cast<std::size_t>(all));
  check_mpi(MPI_Allgatherv(ours.data(), n, record, result.data(), counts.data(), firsts.data(), record, comm.handle()));
  MPI_Type_free(&record);
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_GATHER_H
