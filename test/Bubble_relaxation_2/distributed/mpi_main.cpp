// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#include <mpi.h>

#include <gtest/gtest.h>

#include <iostream>

namespace {

/// What fails on another rank than the first is told with its rank; the rest of its output is not.
class Print_failures : public ::testing::EmptyTestEventListener
{
public:
  explicit Print_failures(int rank) : m_rank(rank) {}

private:
  void OnTestPartResult(const ::testing::TestPartResult& result) override
  {
    if (result.failed())
      std::cerr << "rank " << m_rank << ": " << (result.file_name() ? result.file_name() : "?") << ":"
                << result.line_number() << ": " << result.message() << std::endl;
  }

  int m_rank;
};

} // namespace

int main(int argc, char** argv)
{
  MPI_Init(&argc, &argv);
  ::testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
  if (rank != 0) {
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new Print_failures(rank));
  }
  const int own = RUN_ALL_TESTS();
  int all = own;
  MPI_Allreduce(&own, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return all;
}
