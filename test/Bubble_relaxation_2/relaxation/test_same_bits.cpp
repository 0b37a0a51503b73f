// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Meshes have the same bits on every machine, and with every compiler: those that are stored.

#include "same_bits/meshes.h"

#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

namespace test_same_bits {

class Same_bits : public testing::TestWithParam<same_bits::Case>
{};

std::string name_of(const testing::TestParamInfo<same_bits::Case>& info)
{
  std::string name = info.param.name;
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == ',' || c == '\''; }), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

TEST_P(Same_bits, of)
{
  const std::uint64_t hash = GetParam()();
  std::cout << "0x" << std::hex << hash << std::endl;
  EXPECT_EQ(hash, GetParam().hash) << "Meshes have changed, or differ on this machine. If they were to change, and are "
                                      "no worse, this hash belongs into same_bits/meshes.h.";
}

INSTANTIATE_TEST_SUITE_P(all, Same_bits, testing::ValuesIn(same_bits::cases()), name_of);

} // namespace test_same_bits
