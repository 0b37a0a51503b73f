// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_FIND_SORTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_FIND_SORTED_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. What sorting the elements of all ranks would bring to some positions. All are searched at once by
/// halving: 64 times each rank counts its elements before each. No rank gets elements of others.
/// \param sorted this rank's
/// \param bits the number in whose order an element is
/// \returns these numbers; the largest one that there is, for positions where there is no element
template <class T, class Bits>
std::vector<std::uint64_t> find_sorted(const Communicator& comm, const std::vector<T>& sorted, const Bits& bits,
                                       const std::vector<std::int64_t>& positions)
{
  std::vector<std::uint64_t> found(positions.size(), 0); // the largest that are known to be small enough
  std::vector<std::int64_t> counts(positions.size());
  for (int bit = 63; bit >= 0 && !positions.empty(); --bit) {
    const std::uint64_t half = std::uint64_t(1) << bit;
    for (std::size_t k = 0; k < found.size(); ++k)
      counts[k] = std::lower_bound(sorted.begin(), sorted.end(), found[k] | half,
                                   [&bits](const T& t, std::uint64_t number) { return bits(t) < number; }) -
                  sorted.begin();
    comm.reduce_each(counts, MPI_SUM);
    for (std::size_t k = 0; k < found.size(); ++k)
      if (counts[k] <= positions[k])
        found[k] |= half;
  }
  return found;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_FIND_SORTED_H
