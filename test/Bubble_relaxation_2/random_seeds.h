// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_RANDOM_SEEDS_H
#define BUBBLE_RELAXATION_2_TEST_RANDOM_SEEDS_H

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random> // what draws from them

/// The seeds of random input are fixed, so that all runs are alike. `BUBBLE_RELAXATION_2_SEED=123` in the environment
/// gives others, and with `GTEST_REPEAT=50` those from 123 to 172. A test that fails tells which it had.
namespace random_seeds {

/// what all seeds are counted from
inline unsigned first(int repetition = -1)
{
  static int current = 0;
  if (repetition >= 0)
    current = repetition;
  const char* given = std::getenv("BUBBLE_RELAXATION_2_SEED");
  return (given != nullptr ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 0u) +
         static_cast<unsigned>(current);
}

class Listener : public testing::EmptyTestEventListener
{
  void OnTestIterationStart(const testing::UnitTest&, int repetition) override { first(repetition); }

  void OnTestPartResult(const testing::TestPartResult& result) override
  {
    if (result.failed())
      std::cerr << "with BUBBLE_RELAXATION_2_SEED=" << first() << std::endl;
  }
};

/// a seed, another one for each `k`
inline unsigned seed(unsigned k = 0)
{
  static const bool is_told = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new Listener); // which owns it
    return true;
  }();
  return is_told ? first() + k : 0;
}

} // namespace random_seeds

#endif // BUBBLE_RELAXATION_2_TEST_RANDOM_SEEDS_H
