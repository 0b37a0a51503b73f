// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_H

#include <mpi.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline MPI_Datatype mpi_type(char) { return MPI_SIGNED_CHAR; }
inline MPI_Datatype mpi_type(double) { return MPI_DOUBLE; }
inline MPI_Datatype mpi_type(std::int32_t) { return MPI_INT32_T; }
inline MPI_Datatype mpi_type(std::int64_t) { return MPI_INT64_T; }
inline MPI_Datatype mpi_type(std::uint64_t) { return MPI_UINT64_T; }

/// \throws std::runtime_error, with MPI's words, if a call of MPI failed
inline void check_mpi(int result)
{
  if (result == MPI_SUCCESS)
    return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(result, text, &length);
  throw std::runtime_error("Bubble_relaxation_2: MPI: " + std::string(text, static_cast<std::size_t>(length)));
}

/// A communicator of our own, so that messages never mix with the user's. Its reductions are those whose
/// results do not depend on the number of ranks: smallest, largest, and sums of integers.
///
/// It is also where ranks agree on failures: a rank that throws alone leaves the others waiting, so what is thrown is
/// kept until a place where all ranks are, and all throw the same.
class Communicator
{
public:
  /// Collective.
  /// \throws std::invalid_argument if there is no communicator
  explicit Communicator(MPI_Comm users)
  {
    if (users == MPI_COMM_NULL)
      throw std::invalid_argument("Bubble_relaxation_2: the communicator is MPI_COMM_NULL");
    check_mpi(MPI_Comm_dup(users, &m_comm));
    MPI_Comm_set_errhandler(m_comm, MPI_ERRORS_RETURN);
    MPI_Comm_rank(m_comm, &m_rank);
    MPI_Comm_size(m_comm, &m_size);
  }

  /// An exception that not all ranks throw would leave the others waiting for ever: then all are ended.
  ~Communicator()
  {
    if (std::uncaught_exceptions() > m_exceptions && !m_has_agreed)
      MPI_Abort(m_comm, 1);
    MPI_Comm_free(&m_comm);
  }

  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  MPI_Comm handle() const { return m_comm; }
  int rank() const { return m_rank; }
  int size() const { return m_size; }

  /// \name Reductions
  /// Collective.
  /// @{

  template <class T>
  T smallest(T value) const { return reduce(value, MPI_MIN); }

  template <class T>
  T largest(T value) const { return reduce(value, MPI_MAX); }

  /// of unsigned numbers modulo 2^64
  template <class T>
  T sum(T value) const
  {
    static_assert(std::is_integral<T>::value, "sums of others depend on their order");
    return reduce(value, MPI_SUM);
  }

  /// the sum of the values of all ranks before this one
  std::int64_t sum_before(std::int64_t value) const
  {
    std::int64_t result = 0;
    check_mpi(MPI_Exscan(&value, &result, 1, MPI_INT64_T, MPI_SUM, m_comm));
    return m_rank == 0 ? 0 : result;
  }

  /// whether it holds on any rank
  bool any(bool value) const { return largest(std::int32_t(value)) != 0; }

  /// the same for each of several values
  template <class Values>
  void reduce_each(Values& values, MPI_Op operation) const
  {
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()),
                            mpi_type(typename Values::value_type()), operation, m_comm));
  }

  /// sums of counts, so many
  void add_up(std::size_t* counts, std::size_t n) const
  {
    std::vector<std::uint64_t> sums(counts, counts + n);
    reduce_each(sums, MPI_SUM);
    std::copy(sums.begin(), sums.end(), counts);
  }

  /// @}
  /// \name Agreement
  /// @{

  /// calls `f`, which has nothing to do with other ranks, and keeps what it throws, the first of all; threads may
  template <class Function>
  void keep(const Function& f)
  {
    try {
      f();
    } catch (...) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if (!m_failure)
        m_failure = std::current_exception();
      m_has_failed = true;
    }
  }

  bool has_failed() const { return m_has_failed; }

  /// Collective. If any rank keeps a failure, all ranks throw that of the first of them.
  void agree()
  {
    const std::int32_t none = (std::numeric_limits<std::int32_t>::max)();
    const std::int32_t failed = smallest(m_failure ? std::int32_t(m_rank) : none);
    if (failed != none)
      throw_that_of(failed);
  }

  /// the same, of something that each rank does for itself
  template <class Function>
  void agree_after(const Function& f)
  {
    keep(f);
    agree();
  }

  /// Collective. All ranks throw the same.
  template <class Exception>
  [[noreturn]] void throw_on_all(const Exception& exception) const
  {
    m_has_agreed = true;
    throw exception;
  }

  /// @}

  /// the tag of the next delivery from unknown senders: a fast rank may be one ahead of a slow one, never two
  int next_tag() { return m_tag = 1 - m_tag; }

private:
  template <class T>
  T reduce(T value, MPI_Op operation) const
  {
    T result = value;
    m_has_agreed = false; // what all have thrown before was handled
    check_mpi(MPI_Allreduce(&value, &result, 1, mpi_type(T()), operation, m_comm));
    return result;
  }

  enum Kind : std::int32_t { INVALID_ARGUMENT, LENGTH_ERROR, DOMAIN_ERROR, NO_MEMORY, OTHER };

  [[noreturn]] void throw_that_of(int rank)
  {
    std::string text;
    std::int32_t kind = OTHER;
    if (m_rank == rank)
      kind = describe(text);
    m_failure = nullptr;
    m_has_failed = false;
    std::int32_t header[2] = {kind, static_cast<std::int32_t>(text.size())};
    check_mpi(MPI_Bcast(header, 2, MPI_INT32_T, rank, m_comm));
    text.resize(static_cast<std::size_t>(header[1]));
    check_mpi(MPI_Bcast(&text[0], header[1], MPI_CHAR, rank, m_comm));
    m_has_agreed = true;
    switch (header[0]) {
    case INVALID_ARGUMENT:
      throw std::invalid_argument(text);
    case LENGTH_ERROR:
      throw std::length_error(text);
    case DOMAIN_ERROR:
      throw std::domain_error(text);
    case NO_MEMORY:
      throw std::bad_alloc();
    default:
      throw std::runtime_error(text);
    }
  }

  Kind describe(std::string& text) const
  {
    try {
      std::rethrow_exception(m_failure);
    } catch (const std::exception& e) {
      text = e.what();
      return dynamic_cast<const std::bad_alloc*>(&e)          ? NO_MEMORY
             : dynamic_cast<const std::invalid_argument*>(&e) ? INVALID_ARGUMENT
             : dynamic_cast<const std::length_error*>(&e)     ? LENGTH_ERROR
             : dynamic_cast<const std::domain_error*>(&e)     ? DOMAIN_ERROR
                                                              : OTHER;
    } catch (...) {
      text = "Bubble_relaxation_2: an exception that is no std::exception on rank " + std::to_string(m_rank);
      return OTHER;
    }
  }

  MPI_Comm m_comm = MPI_COMM_NULL;
  int m_rank = 0, m_size = 1;
  int m_exceptions = std::uncaught_exceptions();
  int m_tag = 0;
  mutable bool m_has_agreed = false;
  std::exception_ptr m_failure;
  std::atomic<bool> m_has_failed{false}; // other threads may ask
  std::mutex m_mutex;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_H
