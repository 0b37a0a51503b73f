// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// numbers of bubbles that ranks have are compacted

#include "../random_seeds.h"
#include "same_exception.h"

#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace test_distributed_numbers {

using namespace CGAL::Bubble_relaxation_2::internal;
using distributed::rank;
using distributed::size;

/// `owner(number)`: the rank that has it, or one that is not there
template <class Owner>
void expect_compact(std::int64_t end, const Owner& owner)
{
  Communicator comm(MPI_COMM_WORLD);
  std::vector<std::int64_t> numbers, expected;
  std::int64_t next = 0;
  for (std::int64_t n = 0; n < end; ++n) {
    const int o = owner(n);
    if (o < 0)
      continue;
    if (o == rank()) {
      numbers.push_back(n);
      expected.push_back(next);
    }
    ++next;
  }
  compact_numbers(comm, end, numbers);
  EXPECT_EQ(numbers, expected);
}

TEST(Compact_numbers, numbers_of_whatever_ranks)
{
  for (const std::int64_t end : {0, 1, 2, 7, 1000}) {
    SCOPED_TRACE(end);
    for (unsigned seed = 0; seed < 5; ++seed)
      expect_compact(end, [seed](std::int64_t n) {
        std::mt19937 engine(random_seeds::seed(seed + 10 * static_cast<unsigned>(n)));
        return static_cast<int>(engine() % static_cast<unsigned>(size() + 1)) - 1; // some are gone
      });
    expect_compact(end, [](std::int64_t) { return size() - 1; });
    expect_compact(end, [](std::int64_t) { return -1; });
    expect_compact(end, [end](std::int64_t n) { return static_cast<int>(n * size() / end); });
    expect_compact(end, [end](std::int64_t n) { return size() - 1 - static_cast<int>(n * size() / end); });
    expect_compact(end, [end](std::int64_t n) { return n % 7 == 3 ? -1 : static_cast<int>(n * size() / end); });
  }
}

} // namespace test_distributed_numbers
