// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVEN_PARTITION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVEN_PARTITION_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hilbert_partition_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. Cuts the curve so that all ranks own equally many of some keys, which are on any ranks. All cuts
/// are searched at once by halving: 64 times each rank counts its keys before each cut.
/// \param keys this rank's, sorted
inline Hilbert_partition_2 even_partition(const Communicator& comm, const Hilbert_curve_2& curve,
                                          const std::vector<Hilbert_curve_2::Key>& keys)
{
  using Key = Hilbert_curve_2::Key;
  const std::int64_t all = comm.sum(static_cast<std::int64_t>(keys.size()));
  const std::size_t cuts = static_cast<std::size_t>(comm.size() - 1);
  std::vector<Key> first(cuts, 0); // the largest keys that are known to be enough
  std::vector<std::int64_t> counts(cuts);
  for (int bit = 63; bit >= 0 && cuts > 0; --bit) {
    const Key half = Key(1) << bit;
    for (std::size_t k = 0; k < cuts; ++k)
      counts[k] = std::lower_bound(keys.begin(), keys.end(), first[k] | half) - keys.begin();
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, counts.data(), static_cast<int>(cuts), MPI_INT64_T, MPI_SUM,
                            comm.handle()));
    for (std::size_t k = 0; k < cuts; ++k)
      if (counts[k] <= all * static_cast<std::int64_t>(k + 1) / comm.size())
        first[k] |= half;
  }
  return Hilbert_partition_2(curve, first);
}

/// the same of the keys of sorted elements
template <class Keyed>
Hilbert_partition_2 even_partition(const Communicator& comm, const Hilbert_curve_2& curve,
                                   const std::vector<Keyed>& sorted)
{
  std::vector<Hilbert_curve_2::Key> keys;
  keys.reserve(sorted.size());
  for (const Keyed& element : sorted)
    keys.push_back(element.key);
  return even_partition(comm, curve, keys);
}

/// cuts the curve so that all ranks own equally many of some bubbles, which all of them have
inline Hilbert_partition_2 partition_of_common(const Hilbert_curve_2& curve, const Bubbles_2& common, int ranks)
{
  std::vector<Hilbert_curve_2::Key> keys, first;
  for (std::size_t i = 0; i < common.size(); ++i)
    keys.push_back(curve.key(common.x[i], common.y[i]));
  std::sort(keys.begin(), keys.end());
  for (int rank = 1; rank < ranks; ++rank)
    first.push_back(keys[keys.size() * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks)]);
  return Hilbert_partition_2(curve, first);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EVEN_PARTITION_H
