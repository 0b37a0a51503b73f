// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_IN_CHILD_PROCESS_H
#define BUBBLE_RELAXATION_2_BENCHMARK_IN_CHILD_PROCESS_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <type_traits>

/// bytes of the most memory that this process has had so far
inline double peak_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return double(usage.ru_maxrss);
#else
  return 1024. * double(usage.ru_maxrss);
#endif
}

/// Calls `run` in a process of its own, so that neither its peak memory nor what it leaves in the heap meets
/// the next one. The caller must have no other threads.
/// \throws std::runtime_error if the process fails, also for lack of memory
template <class Result, class Run>
Result in_child_process(const Run& run)
{
  static_assert(std::is_trivially_copyable<Result>::value, "a result goes through a pipe");
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  std::cout.flush();
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no process");
  if (child == 0) {
    bool is_written = false;
    try {
      const Result result = run();
      is_written = write(ends[1], &result, sizeof result) == ssize_t(sizeof result);
    } catch (const std::exception& e) {
      std::cerr << e.what() << std::endl;
    }
    _exit(is_written ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  Result result;
  const bool is_read = read(ends[0], &result, sizeof result) == ssize_t(sizeof result);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!is_read || status != 0)
    throw std::runtime_error("a measurement failed");
  return result;
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_IN_CHILD_PROCESS_H
