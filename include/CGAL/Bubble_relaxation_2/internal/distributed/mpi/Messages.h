// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_MESSAGES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_MESSAGES_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// records for each of some ranks, or from each
template <class T>
using Messages = std::map<int, std::vector<T>>;

/// the bytes of a message
template <class T>
int bytes_of(const std::vector<T>& records)
{
  static_assert(std::is_trivially_copyable<T>::value, "records are sent as bytes");
  const std::size_t n = records.size() * sizeof(T);
  if (n > static_cast<std::size_t>((std::numeric_limits<int>::max)()))
    throw std::length_error("Bubble_relaxation_2: a message to one rank has more than 2^31 bytes");
  return static_cast<int>(n);
}

/// receives a message, if there is one
template <class T>
void receive_if_any(const Communicator& comm, int tag, Messages<T>& in)
{
  int is_there = 0, size = 0;
  MPI_Status status;
  check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, tag, comm.handle(), &is_there, &status));
  if (!is_there)
    return;
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::vector<T>& records = in[status.MPI_SOURCE];
  records.resize(static_cast<std::size_t>(size) / sizeof(T));
  check_mpi(MPI_Recv(records.data(), size, MPI_BYTE, status.MPI_SOURCE, tag, comm.handle(), MPI_STATUS_IGNORE));
}

/// Collective. Delivers messages between ranks that do not know beforehand who will send: each rank sends to few, and
/// nothing is of the size of the communicator (non-blocking consensus, Hoefler, Siebert and Lumsdaine 2010). What a
/// rank sends to itself it gets as well.
template <class T>
Messages<T> deliver(Communicator& comm, const Messages<T>& out)
{
  Messages<T> in;
  const int tag = comm.next_tag();
  std::vector<MPI_Request> sends;
  for (const auto& message : out) {
    if (message.second.empty())
      continue;
    if (message.first == comm.rank()) {
      in[message.first] = message.second;
      continue;
    }
    sends.emplace_back();
    check_mpi(MPI_Issend(message.second.data(), bytes_of(message.second), MPI_BYTE, message.first, tag, comm.handle(),
                         &sends.back()));
  }
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool is_waiting = false;
  for (int is_done = 0; !is_done;) {
    receive_if_any(comm, tag, in);
    if (is_waiting) {
      check_mpi(MPI_Test(&barrier, &is_done, MPI_STATUS_IGNORE));
      continue;
    }
    int all_sent = 0; // and received: the sends are synchronous
    check_mpi(MPI_Testall(static_cast<int>(sends.size()), sends.data(), &all_sent, MPI_STATUSES_IGNORE));
    if (all_sent) {
      check_mpi(MPI_Ibarrier(comm.handle(), &barrier));
      is_waiting = true;
    }
  }
  return in;
}

/// Delivers messages between ranks that know who sends how much at most, while they do something else: something that
/// does not throw, since what was begun has to be ended.
template <class T>
class Expected_delivery
{
public:
  explicit Expected_delivery(const Communicator& comm) : m_comm(comm) {}

  Expected_delivery(const Expected_delivery&) = delete;
  Expected_delivery& operator=(const Expected_delivery&) = delete;

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
      check_mpi(MPI_Irecv(message.second.data(), bytes_of(message.second), MPI_BYTE, message.first, tag,
                          m_comm.handle(), &m_requests.back()));
    }
    for (const auto& message : out) {
      m_requests.emplace_back();
      check_mpi(MPI_Isend(message.second.data(), bytes_of(message.second), MPI_BYTE, message.first, tag,
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
  static constexpr int tag = 2; // not those of deliveries from unknown senders

  const Communicator& m_comm;
  Messages<T>* m_in = nullptr;
  std::vector<MPI_Request> m_requests; // those of `in` first
  std::vector<MPI_Status> m_statuses;
};

/// The same at once.
template <class T>
void deliver_expected(const Communicator& comm, const Messages<T>& out, Messages<T>& in)
{
  Expected_delivery<T> delivery(comm);
  delivery.start(out, in);
  delivery.finish();
}

/// What a rank shares with others: the indices of what it owns and they have, and of what they own and it has, in one
/// order on both sides.
struct Shared_lists
{
  Messages<Index> sent, received;

  /// what is `here` the k-th goes to a rank
  template <class T>
  void send(int rank, const std::vector<T>& here, std::size_t k, Messages<T>& out)
  {
    sent[rank].push_back(static_cast<Index>(k));
    out[rank].push_back(here[k]);
  }

  /// Collective. Delivers it, and adds what comes after the last that is here.
  template <class T>
  void deliver_to(std::vector<T>& here, const Messages<T>& out, Communicator& comm)
  {
    for (const auto& message : deliver(comm, out))
      for (const T& record : message.second) {
        received[message.first].push_back(static_cast<Index>(here.size()));
        here.push_back(record);
      }
  }

  /// Puts in the values of what others own.
  template <class T>
  void share(const Communicator& comm, std::vector<T>& values) const
  {
    Messages<T> out, in;
    for (const auto& list : sent)
      for (Index i : list.second)
        out[list.first].push_back(values[i]);
    for (const auto& list : received)
      in[list.first].resize(list.second.size());
    deliver_expected(comm, out, in);
    for (const auto& list : received)
      for (std::size_t n = 0; n < list.second.size(); ++n)
        values[list.second[n]] = in[list.first][n];
  }
};

/// Collective. The records of all ranks, one rank after the other: for what is small against the bubbles.
/// \throws std::length_error on all ranks if they have more than 2^31 bytes
template <class T>
std::vector<T> gather_records(const Communicator& comm, const std::vector<T>& own)
{
  static_assert(std::is_trivially_copyable<T>::value, "records are sent as bytes");
  const std::int64_t bytes = static_cast<std::int64_t>(own.size() * sizeof(T)), all_bytes = comm.sum(bytes);
  if (all_bytes > (std::numeric_limits<int>::max)())
    comm.throw_on_all(
      std::length_error("Bubble_relaxation_2: what all ranks tell each other at once has more than 2^31 bytes"));
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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_MESSAGES_H
