// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_RANKS_H
#define BUBBLE_RELAXATION_2_BENCHMARK_RANKS_H

#include "benchmark_domains.h"

#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

/// Waits for all ranks of a communicator without taking the time of a core from those that still work, as
/// `MPI_Barrier()` would.
inline void wait_asleep(MPI_Comm comm)
{
  MPI_Request request;
  MPI_Ibarrier(comm, &request);
  for (int is_done = 0; MPI_Test(&request, &is_done, MPI_STATUS_IGNORE), is_done == 0;)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// calls `run()` on the first rank while the others sleep
template <class Run>
void on_first_rank(const Run& run)
{
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0)
    run();
  wait_asleep(MPI_COMM_WORLD);
}

/// the domain with about `n` vertices, the same on all ranks
inline paper::Domain domain_of_all(const Domain_maker& make, double n)
{
  double f = 1;
  on_first_rank([&] { f = scale_for_vertices(make, n); });
  MPI_Bcast(&f, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return make(f);
}

/// how many processes have wanted a core, on average over the last minute
inline double load_average()
{
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : -1;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_RANKS_H
