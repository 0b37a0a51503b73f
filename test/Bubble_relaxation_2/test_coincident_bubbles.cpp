// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// bubbles in one place: one stays, of the lowest dimension, and of these the first

#include <CGAL/Bubble_relaxation_2/internal/remove_coincident.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace {

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

TEST(Coincident_bubbles, few_places)
{
  std::mt19937 engine(1);
  for (int n : {0, 1, 2, 10, 1000}) {
    Bubbles_2 b;
    for (int i = 0; i < n; ++i)
      b.add(Point(double(engine() % 20), double(engine() % 20)), 1, static_cast<Bubbles_2::Dimension>(engine() % 3), 0);
    expect_right_ones_stay(b);
  }
}

TEST(Coincident_bubbles, many_places)
{
  std::mt19937 engine(2);
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
  std::mt19937_64 engine(3);
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

} // namespace
