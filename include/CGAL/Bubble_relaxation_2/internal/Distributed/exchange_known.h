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

/// Exchanges messages between ranks that know who sends how much at most, while they do something else: something that does
/// not throw, since what was begun has to be ended.
template <class T>
class Known_exchange
{
public:
  explicit Known_exchange(const Communicator& comm) : m_comm(comm) {}

  Known_exchange(const Known_exchange&) = delete;
  Known_exchange& operator=(const Known_exchange&) = delete;

  /// Begins. `in`: messages of the sizes that those that come have at most. Until `finish()` nobody else may touch `in`
  /// and `out`. \pre what was begun before is ended
  void start(const Messages<T>& out, Messages<T>& in)
  {
    m_in = &in;
    m_requests.clear();
    m_requests.reserve(in.size() + out.size());
    m_statuses.resize(in.size() + out.size());
    for (auto& message : in) {
      m_requests.emplace_back();
      check_mpi(MPI_Irecv(message.second.data(), bytes(message.second), MPI_BYTE, message.first, tag,
                          m_comm.handle(), &m_requests.back()));
    }
    for (const auto& message : out) {
      m_requests.emplace_back();
      check_mpi(MPI_Isend(message.second.data(), bytes(message.second), MPI_BYTE, message.first, tag,
                          m_comm.handle(), &m_requests.back()));
    }
  }

  /// Ends: the messages in `in` get the sizes of what came.
  void finish()
  {
    check_mpi(MPI_Waitall(static_cast<int>(m_requests.size()), m_requests.data(), m_statuses.data()));
    std::size_t k = 0;
    for (auto& message : *m_in) {
      int size = 0;
      MPI_Get_count(&m_statuses[k++], MPI_BYTE, &size);
      message.second.resize(static_cast<std::size_t>(size) / sizeof(T));
    }
  }

private:
  static constexpr int tag = 2; // not those of exchanges with unknown senders

  static int bytes(const std::vector<T>& records) { return static_cast<int>(records.size() * sizeof(T)); }

  const Communicator& m_comm;
  Messages<T>* m_in = nullptr;
  std::vector<MPI_Request> m_requests; // those of `in` first
  std::vector<MPI_Status> m_statuses;
};

/// The same at once.
template <class T>
void exchange_known(const Communicator& comm, const Messages<T>& out, Messages<T>& in)
{
  Known_exchange<T> exchange(comm);
  exchange.start(out, in);
  exchange.finish();
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_EXCHANGE_KNOWN_H
