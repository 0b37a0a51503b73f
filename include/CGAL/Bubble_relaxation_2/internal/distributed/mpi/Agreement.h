// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_AGREEMENT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_AGREEMENT_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What all ranks throw when one of them has failed. A rank that throws alone leaves the others waiting, so
/// failures are kept until a place where all ranks are.
class Agreement
{
public:
  explicit Agreement(const Communicator& comm) : m_comm(comm) {}

  /// calls `f`, which has nothing to do with other ranks, and keeps what it throws; several threads may
  template <class Function>
  void keep(const Function& f)
  {
    try {
      f();
    } catch (...) {
      keep_current();
    }
  }

  /// keeps the exception that is being handled, the first of all
  void keep_current()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (!m_failure)
      m_failure = std::current_exception();
  }

  bool has_failed() const { return m_failure != nullptr; }

  /// Collective. If any rank keeps a failure, all ranks throw that of the first of them.
  void reach()
  {
    const std::int32_t none = (std::numeric_limits<std::int32_t>::max)();
    const std::int32_t failed = m_comm.smallest(m_failure ? std::int32_t(m_comm.rank()) : none);
    if (failed != none)
      throw_that_of(failed);
  }

  /// the same, of something that each rank does for itself
  template <class Function>
  void reach_after(const Function& f)
  {
    keep(f);
    reach();
  }

private:
  enum Kind : std::int32_t { INVALID_ARGUMENT, LENGTH_ERROR, DOMAIN_ERROR, NO_MEMORY, OTHER };

  [[noreturn]] void throw_that_of(int rank)
  {
    std::string text;
    std::int32_t kind = OTHER;
    if (m_comm.rank() == rank)
      kind = describe(text);
    m_failure = nullptr;
    std::int32_t header[2] = {kind, static_cast<std::int32_t>(text.size())};
    check_mpi(MPI_Bcast(header, 2, MPI_INT32_T, rank, m_comm.handle()));
    text.resize(static_cast<std::size_t>(header[1]));
    check_mpi(MPI_Bcast(&text[0], header[1], MPI_CHAR, rank, m_comm.handle()));
    m_comm.all_throw();
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
    } catch (const std::bad_alloc& e) {
      return NO_MEMORY;
    } catch (const std::invalid_argument& e) {
      text = e.what();
      return INVALID_ARGUMENT;
    } catch (const std::length_error& e) {
      text = e.what();
      return LENGTH_ERROR;
    } catch (const std::domain_error& e) {
      text = e.what();
      return DOMAIN_ERROR;
    } catch (const std::exception& e) {
      text = e.what();
    } catch (...) {
      text = "Bubble_relaxation_2: an exception that is no std::exception on rank " +
             std::to_string(m_comm.rank());
    }
    return OTHER;
  }

  const Communicator& m_comm;
  std::exception_ptr m_failure;
  std::mutex m_mutex;
};

/// the value of a parameter on this rank, in a form that any rank can compare and put into words
struct Parameter_value
{
  const char* name;
  std::uint64_t bits;
  std::string (*text)(std::uint64_t bits);
};

/// Collective. All ranks have values of the same parameters, in the same order.
/// \throws std::invalid_argument on all ranks if a value is not the same on all, naming the first such parameter
/// and two of its values
inline void check_same_values(const Communicator& comm, const std::vector<Parameter_value>& values)
{
  const std::size_t n = values.size();
  std::vector<std::uint64_t> first(n);
  for (std::size_t k = 0; k < n; ++k)
    first[k] = values[k].bits;
  check_mpi(MPI_Bcast(first.data(), static_cast<int>(n), MPI_UINT64_T, 0, comm.handle()));
  std::size_t k = 0;
  while (k < n && values[k].bits == first[k])
    ++k;
  const std::int64_t ranks = comm.size();
  const std::int64_t different = comm.smallest(static_cast<std::int64_t>(k) * ranks + comm.rank());
  const std::size_t parameter = static_cast<std::size_t>(different / ranks);
  if (parameter == n)
    return;
  const int rank = static_cast<int>(different % ranks);
  std::uint64_t other = values[parameter].bits;
  check_mpi(MPI_Bcast(&other, 1, MPI_UINT64_T, rank, comm.handle()));
  const Parameter_value& p = values[parameter];
  const std::string text = std::string("Bubble_relaxation_2: parameter ") + p.name + " = " +
                           p.text(first[parameter]) + " on rank 0, but " + p.text(other) + " on rank " +
                           std::to_string(rank);
  comm.all_throw();
  throw std::invalid_argument(text);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MPI_AGREEMENT_H
