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

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

inline MPI_Datatype mpi_type(double) { return MPI_DOUBLE; }
inline MPI_Datatype mpi_type(std::int32_t) { return MPI_INT32_T; }
inline MPI_Datatype mpi_type(std::int64_t) { return MPI_INT64_T; }
inline MPI_Datatype mpi_type(std::uint64_t) { return MPI_UINT64_T; }

/// MPI's words for what a call returned
inline std::string mpi_error_text(int result)
{
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(result, text, &length);
  return std::string(text, static_cast<std::size_t>(length));
}

/// \throws std::runtime_error if a call of MPI failed
inline void check_mpi(int result)
{
  if (result != MPI_SUCCESS)
    throw std::runtime_error("Bubble_relaxation_2: MPI: " + mpi_error_text(result));
}

/// A communicator of our own, so that messages never mix with the user's. Its reductions are those whose
/// results do not depend on the number of ranks: smallest, largest, and sums of integers.
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

  template <class T>
  T smallest(T value) const
  {
    return reduce(value, MPI_MIN);
  }

  template <class T>
  T largest(T value) const
  {
    return reduce(value, MPI_MAX);
  }

  std::int64_t sum(std::int64_t value) const { return reduce(value, MPI_SUM); }

  /// modulo 2^64
  std::uint64_t sum_modulo(std::uint64_t value) const { return reduce(value, MPI_SUM); }

  /// the sum of the values of all ranks before this one
  std::int64_t sum_before(std::int64_t value) const
  {
    std::int64_t result = 0;
    check_mpi(MPI_Exscan(&value, &result, 1, MPI_INT64_T, MPI_SUM, m_comm));
    return m_rank == 0 ? 0 : result;
  }

  /// whether it holds on any rank
  bool any(bool value) const { return largest(std::int32_t(value)) != 0; }

  /// all ranks are about to throw the same
  void all_throw() const { m_has_agreed = true; }

private:
  template <class T>
  T reduce(T value, MPI_Op operation) const
  {
    T result = value;
    check_mpi(MPI_Allreduce(&value, &result, 1, mpi_type(T()), operation, m_comm));
    return result;
  }

  MPI_Comm m_comm = MPI_COMM_NULL;
  int m_rank = 0, m_size = 1;
  int m_exceptions = std::uncaught_exceptions();
  mutable bool m_has_agreed = false;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_COMMUNICATOR_H
