// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MPI_SESSION_H
#define BUBBLE_RELAXATION_2_DEMO_MPI_SESSION_H

#include <mpi.h>

#include <exception>
#include <iostream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// MPI from the first line of `main()` to the last one.
class Mpi_session
{
public:
  Mpi_session(int& argc, char**& argv)
  {
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
    MPI_Comm_size(MPI_COMM_WORLD, &m_number_of_ranks);
  }
  ~Mpi_session() { MPI_Finalize(); }
  Mpi_session(const Mpi_session&) = delete;
  Mpi_session& operator=(const Mpi_session&) = delete;

  int rank() const { return m_rank; }
  int number_of_ranks() const { return m_number_of_ranks; }
  bool is_first() const { return m_rank == 0; }

  /// Calls `run()`, which may fail on some ranks only, but must not wait for others.
  /// \throws std::runtime_error on all ranks, with the message of the first one that failed
  template <class Run>
  void all_or_none(const Run& run) const
  {
    std::string message;
    int failed = m_number_of_ranks;
    try {
      run();
    } catch (const std::exception& e) {
      message = e.what();
      failed = m_rank;
    }
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (failed == m_number_of_ranks)
      return;
    int length = static_cast<int>(message.size());
    MPI_Bcast(&length, 1, MPI_INT, failed, MPI_COMM_WORLD);
    message.resize(static_cast<std::size_t>(length));
    MPI_Bcast(&message[0], length, MPI_CHAR, failed, MPI_COMM_WORLD);
    throw std::runtime_error(message);
  }

  /// What all ranks have, one after the other, on the first one; nothing on others. For pictures: what does not
  /// fit into the memory of one rank cannot be gathered.
  template <class T>
  std::vector<T> gather(const std::vector<T>& own) const
  {
    static_assert(std::is_trivially_copyable<T>::value, "goes to another process as bytes");
    const int size = static_cast<int>(own.size() * sizeof(T));
    std::vector<int> sizes(static_cast<std::size_t>(m_number_of_ranks)), begins(sizes.size());
    MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::partial_sum(sizes.begin(), sizes.end() - 1, begins.begin() + 1);
    std::vector<T> all(is_first() ? static_cast<std::size_t>(begins.back() + sizes.back()) / sizeof(T) : 0);
    MPI_Gatherv(own.data(), size, MPI_BYTE, all.data(), sizes.data(), begins.data(), MPI_BYTE, 0, MPI_COMM_WORLD);
    return all;
  }

private:
  int m_rank = 0, m_number_of_ranks = 1;
};

/// A `main()` for all ranks: calls `run(session)`, which throws on all ranks or on none, and prints an error once.
/// \returns the exit code
template <class Run>
int run_with_mpi(int& argc, char**& argv, const char* program, const Run& run)
{
  const Mpi_session session(argc, argv);
  try {
    return run(session);
  } catch (const std::exception& e) {
    if (session.is_first())
      std::cerr << program << ": " << e.what() << std::endl;
    return 1;
  }
}

#endif // BUBBLE_RELAXATION_2_DEMO_MPI_SESSION_H
