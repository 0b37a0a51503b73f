// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EXCHANGE_KNOWN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EXCHANGE_KNOWN_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Exchanges messages between ranks that know who sends how much at most: the messages in `in` have that size,
/// and afterwards that of what came.
template <class T>
void exchange_known(const Communicator& comm, const Messages<T>& out, Messages<T>& in)
{
  constexpr int tag = 2; // not those of exchanges with unknown senders
  const auto bytes = [](const std::vector<T>& records) { return static_cast<int>(records.size() * sizeof(T)); };
  std::vector<MPI_Request> requests;
  requests.reserve(in.size() + out.size());
  for (auto& message : in) {
    requests.emplace_back();
    check_mpi(MPI_Irecv(message.second.data(), bytes(message.second), MPI_BYTE, message.first, tag,
                        comm.handle(), &requests.back()));
  }
  for (const auto& message : out) {
    requests.emplace_back();
    check_mpi(MPI_Isend(message.second.data(), bytes(message.second), MPI_BYTE, message.first, tag,
                        comm.handle(), &requests.back()));
  }
  std::vector<MPI_Status> statuses(requests.size());
  check_mpi(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), statuses.data()));
  std::size_t k = 0;
  for (auto& message : in) {
    int size = 0;
    MPI_Get_count(&statuses[k++], MPI_BYTE, &size);
    message.second.resize(static_cast<std::size_t>(size) / sizeof(T));
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EXCHANGE_KNOWN_H
