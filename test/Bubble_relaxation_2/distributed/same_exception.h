// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_SAME_EXCEPTION_H
#define BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_SAME_EXCEPTION_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>

#include <gtest/gtest.h>
#include <mpi.h>

#include <exception>
#include <string>
#include <vector>

/// Exceptions that all ranks throw.
namespace distributed {

inline int rank()
{
  int result;
  MPI_Comm_rank(MPI_COMM_WORLD, &result);
  return result;
}

inline int size()
{
  int result;
  MPI_Comm_size(MPI_COMM_WORLD, &result);
  return result;
}

inline int last_rank() { return size() - 1; }

/// calls f, which has to throw an E with the same text on all ranks, in which `part` occurs
template <class E, class Function>
void expect_same_exception(const std::string& part, const Function& f)
{
  std::string text;
  try {
    f();
    ADD_FAILURE() << "nothing was thrown";
  } catch (const E& e) {
    text = e.what();
  } catch (const std::exception& e) {
    ADD_FAILURE() << "another exception: " << e.what();
  }
  EXPECT_NE(text.find(part), std::string::npos) << text;
  const std::vector<char> own(text.begin(), text.end());
  using namespace CGAL::Bubble_relaxation_2::internal;
  const std::vector<char> all = gather_records(Communicator(MPI_COMM_WORLD), own);
  std::string repeated;
  for (int r = 0; r < size(); ++r)
    repeated += text;
  EXPECT_EQ(std::string(all.begin(), all.end()), repeated);
}

} // namespace distributed

#endif // BUBBLE_RELAXATION_2_TEST_DISTRIBUTED_SAME_EXCEPTION_H
