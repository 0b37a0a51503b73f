// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_RANK_COUNTS_H
#define BUBBLE_RELAXATION_2_BENCHMARK_RANK_COUNTS_H

#include "../../test/Bubble_relaxation_2/counted_memory.h"
#include "ranks.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Distributed/npbs_mesh.h>
#include <CGAL/Point_set_3.h>

#include <mpi.h>

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>

/// the mean and the largest of what the ranks have
struct Mean_and_most
{
  double mean, most;
  double imbalance() const { return mean > 0 ? most / mean : 1; }
};

/// What the ranks of a simulation hold and send: of each rank, and what is sent in each step.
struct Rank_counts
{
  int number_of_ranks;
  double steps, all_moves;
  Mean_and_most bubbles, moves, ghosts, neighbors, messages, bytes;
  Mean_and_most input, memory; ///< bytes of the input as each rank reads it, and the most while a mesh is made
  double waits; ///< bubbles of all ranks that had to wait for an exchange (the paper's protocol)
};

inline Mean_and_most mean_and_most(double value, MPI_Comm comm)
{
  double sum = 0, most = 0;
  int size = 1;
  MPI_Comm_size(comm, &size);
  MPI_Allreduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, comm);
  MPI_Allreduce(&value, &most, 1, MPI_DOUBLE, MPI_MAX, comm);
  return Mean_and_most{sum / size, most};
}

/// the most bytes that `make()` holds at once, with what it returns
template <class Make>
double most_bytes(const Make& make)
{
  const std::size_t before = counted_memory::most_memory = counted_memory::memory;
  make();
  return double(counted_memory::most_memory - before);
}

/// Collective. Simulates a domain on all ranks of a communicator, and makes its mesh.
template <class NamedParameters>
Rank_counts count_of_ranks(MPI_Comm ranks, const paper::Domain& domain, const NamedParameters& parameters)
{
  using namespace CGAL::Bubble_relaxation_2::internal;
  Communicator comm(ranks);
  const paper::CDT cdt = paper::triangulate(domain);
  const auto np = parameters.sizing_function(domain.d);
  const std::size_t bytes_before = counted_memory::memory;
  const Input_2<paper::CDT> input(cdt, np, std::make_shared<Progress>());
  const double bytes_of_input = double(counted_memory::memory - bytes_before);
  Report report;
  Traffic_2 traffic;
  const Placed_part_2 part = simulate_distributed(comm, input.problem(), report, {}, &traffic);
  const auto in_a_step = [&](std::int64_t count) {
    return mean_and_most(double(count) / double(report.number_of_steps), ranks);
  };
  const Mean_and_most moves = mean_and_most(double(report.number_of_moves), ranks);
  CGAL::Point_set_3<paper::Point, paper::K::Vector_2> points;
  const double bytes_of_mesh = most_bytes([&] { return CGAL::Distributed::npbs_mesh(points, cdt, ranks, np); });
  const double waits = mean_and_most(double(traffic.waits), ranks).mean * comm.size();
  return Rank_counts{comm.size(), double(report.number_of_steps), moves.mean * comm.size(),
                     mean_and_most(double(part.bubbles.size()), ranks), moves, in_a_step(traffic.ghosts),
                     in_a_step(traffic.neighbors),
                     in_a_step(traffic.messages), in_a_step(traffic.bytes),
                     mean_and_most(bytes_of_input, ranks), mean_and_most(bytes_of_mesh, ranks), waits};
}

inline void print_header_of_counts()
{
  std::cout << std::fixed << std::left << std::setw(20) << "domain" << std::setw(18) << "exchange" << std::right
            << std::setw(6) << "ranks" << std::setw(7) << "steps" << std::setw(18) << "bubbles mean/max"
            << std::setw(11) << "imbalance" << std::setw(10) << "of moves" << std::setw(16) << "ghosts"
            << std::setw(14) << "neighbours"
            << std::setw(10) << "messages" << std::setw(9) << "kB" << std::setw(9) << "waits" << std::setw(10)
            << "input, MB" << std::setw(18) << "most MB, mean/max" << '\n';
}

inline void print(const std::string& domain, const std::string& exchange, const Rank_counts& c)
{
  const auto print_both = [](const Mean_and_most& m, int width, int digits) {
    std::cout << std::setprecision(digits) << std::setw(width - 7) << m.mean << '/' << std::setprecision(0) << std::left
              << std::setw(6) << m.most << std::right;
  };
  std::cout << std::left << std::setw(20) << domain << std::setw(18) << exchange << std::right << std::setw(6)
            << c.number_of_ranks << std::setprecision(0) << std::setw(7) << c.steps;
  print_both(c.bubbles, 18, 0);
  std::cout << std::setprecision(3) << std::setw(11) << c.bubbles.imbalance() << std::setw(10) << c.moves.imbalance();
  print_both(c.ghosts, 16, 0);
  print_both(c.neighbors, 14, 1);
  std::cout << std::setprecision(2) << std::setw(10) << c.messages.mean << std::setw(9) << c.bytes.mean / 1e3
            << std::setprecision(0) << std::setw(9) << c.waits << std::setprecision(2) << std::setw(10)
            << c.input.most / 1e6 << std::setw(9) << c.memory.mean / 1e6 << '/' << c.memory.most / 1e6 << std::endl;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_RANK_COUNTS_H
