// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// bubbles that are kept, in whatever order; of those in one place one stays, of the lowest dimension, and of these the
// first

#include "random_seeds.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace test_bubbles {

using namespace CGAL::Bubble_relaxation_2::internal;

/// of each place the bubble that stays
std::vector<Index> expected_to_stay(const Bubbles_2& b)
{
  std::map<std::pair<double, double>, std::pair<int, Index>> best;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (b.is_gone(i))
      continue;
    const std::pair<int, Index> rank(b.dimension[i], static_cast<Index>(i));
    const auto place = best.emplace(std::make_pair(b.x[i], b.y[i]), rank).first;
    place->second = (std::min)(place->second, rank);
  }
  std::vector<Index> result;
  for (const auto& place : best)
    result.push_back(place.second.second);
  std::sort(result.begin(), result.end());
  return result;
}

void expect_right_ones_stay(Bubbles_2 b)
{
  const std::vector<Index> expected = expected_to_stay(b);
  remove_those_in_one_place(b);
  EXPECT_EQ(b.left(), expected);
}

/// a bubble with values that tell which it is
void add_bubble(Bubbles_2& b, int i)
{
  b.add(Point(i, 2 * i), 3 * i + 1, static_cast<Bubbles_2::Dimension>(i % 3), 4 * i, 0.5 * i, 5 * i);
  b.vx.back() = 6 * i;
  b.vy.back() = 7 * i;
}

TEST(Bubbles, those_that_are_selected_stay_in_their_order)
{
  std::vector<std::vector<Index>> orders{{}, {0}, {9}, {0, 1, 2}, {1, 4, 9}, {4, 1, 9}, {0, 0}, {3, 3, 3, 3, 3}};
  orders.emplace_back(10);
  std::iota(orders.back().begin(), orders.back().end(), 0);
  orders.push_back(orders.back());
  std::reverse(orders.back().begin(), orders.back().end());
  for (const std::vector<Index>& order : orders)
    for (const bool has_parts : {false, true}) {
      Bubbles_2 all, expected;
      for (int i = 0; i < 10; ++i) {
        add_bubble(all, i);
        if (has_parts) {
          all.id.push_back(100 + i);
          all.owner.push_back(i % 2);
        }
      }
      for (Index i : order)
        add_bubble(expected, i);
      all.select(order);
      EXPECT_EQ(all.x, expected.x);
      EXPECT_EQ(all.y, expected.y);
      EXPECT_EQ(all.d, expected.d);
      EXPECT_EQ(all.vx, expected.vx);
      EXPECT_EQ(all.vy, expected.vy);
      EXPECT_EQ(all.s, expected.s);
      EXPECT_EQ(all.dimension, expected.dimension);
      EXPECT_EQ(all.host, expected.host);
      EXPECT_EQ(all.pin, expected.pin);
      ASSERT_EQ(all.id.size(), has_parts ? order.size() : 0);
      ASSERT_EQ(all.owner.size(), all.id.size());
      for (std::size_t k = 0; k < all.id.size(); ++k) {
        EXPECT_EQ(all.id[k], 100 + order[k]);
        EXPECT_EQ(all.owner[k], order[k] % 2);
        EXPECT_EQ(all.is_ours(k), order[k] % 2 == 0);
      }
    }
}

TEST(Coincident_bubbles, few_places)
{
  std::mt19937 engine(random_seeds::seed(1));
  for (int n : {0, 1, 2, 10, 1000}) {
    Bubbles_2 b;
    for (int i = 0; i < n; ++i)
      b.add(Point(double(engine() % 20), double(engine() % 20)), 1, static_cast<Bubbles_2::Dimension>(engine() % 3), 0);
    expect_right_ones_stay(b);
  }
}

TEST(Coincident_bubbles, many_places)
{
  std::mt19937 engine(random_seeds::seed(2));
  std::uniform_real_distribution<double> uniform(-1, 1);
  Bubbles_2 b;
  for (int i = 0; i < 50000; ++i)
    b.add(Point(uniform(engine), uniform(engine)), 1, Bubbles_2::FACE, 0);
  Bubbles_2 distinct = b;
  remove_those_in_one_place(distinct);
  EXPECT_EQ(distinct.left().size(), b.size());
  for (int i = 0; i < 50000; i += 100) // far from each other in memory
    b.add(b.point(static_cast<std::size_t>(i)), 1, Bubbles_2::EDGE, 0);
  for (std::size_t i = 0; i < b.size(); i += 77)
    b.remove(i);
  expect_right_ones_stay(b);
}

TEST(Coincident_bubbles, coordinates_that_differ_in_a_bit_are_different)
{
  Bubbles_2 b;
  double x = 1;
  for (int i = 0; i < 1000; ++i) {
    b.add(Point(x, 0.), 1, Bubbles_2::FACE, 0);
    b.add(Point(0.5, x), 1, Bubbles_2::FACE, 0);
    b.add(Point(x, x), 1, Bubbles_2::FACE, 0);
    x = std::nextafter(x, 2.);
  }
  expect_right_ones_stay(b);
}

TEST(Coincident_bubbles, zeros_are_one_place)
{
  Bubbles_2 b;
  for (double x : {0., -0.})
    for (double y : {-0., 0.})
      b.add(Point(x, y), 1, Bubbles_2::FACE, 0);
  expect_right_ones_stay(b);
  remove_those_in_one_place(b);
  EXPECT_EQ(b.left(), std::vector<Index>{0});
}

TEST(Coincident_bubbles, few_are_looked_at_if_none_coincide)
{
  std::mt19937_64 engine(random_seeds::seed(3));
  std::uniform_real_distribution<double> uniform(0, 1);
  for (double scale : {1e-9, 1., 1e9}) {
    Bubbles_2 lattice, random;
    for (int i = 0; i < 200; ++i)
      for (int j = 0; j < 200; ++j) {
        lattice.add(Point(scale * i, scale * j), scale, Bubbles_2::FACE, 0);
        random.add(Point(scale * uniform(engine), scale * uniform(engine)), scale, Bubbles_2::FACE, 0);
      }
    // of n in 16 n or more places one of 16 meets another, so two of 16 are there
    EXPECT_LT(perhaps_in_one_place(lattice).size(), lattice.size() / 7);
    EXPECT_LT(perhaps_in_one_place(random).size(), random.size() / 7);
  }
}

} // namespace test_bubbles
