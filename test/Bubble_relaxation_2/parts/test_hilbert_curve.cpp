// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Hilbert's curve: it goes through all cells, from each to one beside it, quarter by quarter, whatever the depth.

#include "random_seeds.h"

#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace test_hilbert_curve {

using CGAL::Bubble_relaxation_2::internal::Hilbert_curve_2;

struct Cell
{
  std::uint32_t x, y;
};

const CGAL::Bbox_2 box(0, 0, 1, 1);

/// Quarter by quarter, the first one below on the left, the last one below on the right; in both of these the curve is
/// mirrored at a diagonal. The parts of ranks rely on this curve.
Hilbert_curve_2::Key key_by_quarters(std::uint32_t x, std::uint32_t y, int depth)
{
  Hilbert_curve_2::Key key = 0;
  for (int level = depth - 1; level >= 0; --level) {
    const std::uint32_t side = std::uint32_t(1) << level, last = side - 1;
    const bool right = (x & side) != 0, up = (y & side) != 0;
    key = 4 * key + (right ? (up ? 2 : 3) : (up ? 1 : 0));
    const std::uint32_t u = x & last, v = y & last; // in the quarter
    x = up ? u : right ? last - v : v;
    y = up ? v : right ? last - u : u;
  }
  return key;
}

class Curve : public testing::TestWithParam<bool>
{
protected:
  const Hilbert_curve_2 curve{box, GetParam()};
};

TEST_P(Curve, visits_all_cells_one_beside_the_other)
{
  for (int depth = 1; depth <= 9; ++depth) {
    SCOPED_TRACE(depth);
    const std::uint32_t side = std::uint32_t(1) << depth;
    std::vector<Cell> cells(side * side, Cell{side, side});
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::uint32_t y = 0; y < side; ++y) {
        const Hilbert_curve_2::Key key = curve.key_of_cell(x, y, depth);
        ASSERT_LT(key, cells.size());
        ASSERT_EQ(cells[key].x, side) << "two cells with one key";
        cells[key] = Cell{x, y};
      }
    for (std::size_t k = 1; k < cells.size(); ++k)
      ASSERT_EQ(std::abs(int(cells[k].x) - int(cells[k - 1].x)) + std::abs(int(cells[k].y) - int(cells[k - 1].y)), 1);
    // the first half is left of the second, or below it
    const Cell& last = cells[side * side / 2 - 1];
    EXPECT_LT(GetParam() ? last.y : last.x, side / 2);
  }
}

TEST_P(Curve, is_the_one_by_quarters)
{
  std::mt19937 engine(random_seeds::seed(1));
  for (int k = 0; k < 10000; ++k) {
    const int depth = k % (Hilbert_curve_2::levels + 1);
    const std::uint32_t side = depth == 0 ? 0 : ~std::uint32_t(0) >> (Hilbert_curve_2::levels - depth);
    const std::uint32_t x = engine() & side, y = engine() & side;
    ASSERT_EQ(curve.key_of_cell(x, y, depth), GetParam() ? key_by_quarters(y, x, depth) : key_by_quarters(x, y, depth));
  }
}

TEST_P(Curve, goes_through_a_cell_before_it_leaves_it)
{
  std::mt19937 engine(random_seeds::seed(1));
  for (int k = 0; k < 1000; ++k) {
    const std::uint32_t x = engine(), y = engine();
    const Hilbert_curve_2::Key key = curve.key_of_cell(x, y, Hilbert_curve_2::levels);
    for (int depth = 1; depth < Hilbert_curve_2::levels; ++depth) {
      const int finer = Hilbert_curve_2::levels - depth;
      ASSERT_EQ(curve.key_of_cell(x >> finer, y >> finer, depth), key >> 2 * finer);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lying_and_upright, Curve, testing::Bool());

} // namespace test_hilbert_curve
