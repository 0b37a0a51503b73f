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
    int is_there = 0, size = 0;
    MPI_Status status;
    check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, tag, comm.handle(), &is_there, &status));
    if (is_there) {
      MPI_Get_count(&status, MPI_BYTE, &size);
      std::vector<T>& records = in[status.MPI_SOURCE];
      records.resize(static_cast<std::size_t>(size) / sizeof(T));
      check_mpi(MPI_Recv(records.data(), size, MPI_BYTE, status.MPI_SOURCE, tag, comm.handle(), MPI_STATUS_IGNORE));
    }
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

/// Collective. Delivers messages, and calls `take(rank, record)` for what comes, from lower ranks first.
template <class T, class Take>
void deliver(Communicator& comm, const Messages<T>& out, const Take& take)
{
  for (const auto& message : deliver(comm, out))
    for (const T& record : message.second)
      take(message.first, record);
}

/// What a rank shares with others: the indices of what it owns and they have, and of what they own and it has, in one
/// order on both sides.
struct Shared_lists
{
  Messages<Index> sent, received;
};

/// Tells ranks of what they share, at most a record of each thing, while they do something else: something that does
/// not throw, since what was begun has to be ended.
template <class T>
class Shared_delivery
{
public:
  explicit Shared_delivery(const Communicator& comm) : m_comm(comm) {}

  Shared_delivery(const Shared_delivery&) = delete;
  Shared_delivery& operator=(const Shared_delivery&) = delete;

  /// Begins. `tell(i, position, message)` may add to a message what is told of `i`, which has this position in the
  /// lists of both ranks. \pre what was begun before is ended
  template <class Tell>
  void start(const Shared_lists& lists, const Tell& tell)
  {
    m_in.clear();
    m_out.clear();
    m_requests.clear();
    m_requests.reserve(lists.received.size() + lists.sent.size());
    for (const auto& list : lists.received) {
      std::vector<T>& message = m_in[list.first];
      message.resize(list.second.size());
      m_requests.emplace_back();
      check_mpi(MPI_Irecv(message.data(), bytes_of(message), MPI_BYTE, list.first, tag, m_comm.handle(),
                          &m_requests.back()));
    }
    for (const auto& list : lists.sent) {
      std::vector<T>& message = m_out[list.first];
      for (std::size_t position = 0; position < list.second.size(); ++position)
        tell(list.second[position], position, message);
      m_requests.emplace_back();
      check_mpi(MPI_Isend(message.data(), bytes_of(message), MPI_BYTE, list.first, tag, m_comm.handle(),
                          &m_requests.back()));
    }
  }

  /// what this rank tells
  const Messages<T>& out() const { return m_out; }

  /// Ends, and calls `take(list, message)` with each message that came, and the list of what it tells about.
  template <class Take>
  void finish(const Shared_lists& lists, const Take& take)
  {
    std::vector<MPI_Status> statuses(m_requests.size()); // those of `m_in` first
    check_mpi(MPI_Waitall(static_cast<int>(m_requests.size()), m_requests.data(), statuses.data()));
    std::size_t k = 0;
    for (auto& message : m_in) {
      int size = 0;
      MPI_Get_count(&statuses[k++], MPI_BYTE, &size);
      message.second.resize(static_cast<std::size_t>(size) / sizeof(T));
      take(lists.received.at(message.first), message.second);
    }
  }

private:
  static constexpr int tag = 2; // not those of deliveries from unknown senders

  const Communicator& m_comm;
  Messages<T> m_out, m_in;
  std::vector<MPI_Request> m_requests;
};

/// Collective. Puts in the values of what others own.
template <class T>
void share_values(const Communicator& comm, const Shared_lists& lists, std::vector<T>& values)
{
  Shared_delivery<T> delivery(comm);
  delivery.start(lists, [&](Index i, std::size_t, std::vector<T>& message) { message.push_back(values[i]); });
  delivery.finish(lists, [&](const std::vector<Index>& list, const std::vector<T>& message) {
    for (std::size_t n = 0; n < list.size(); ++n)
      values[list[n]] = message[n];
  });
}

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
