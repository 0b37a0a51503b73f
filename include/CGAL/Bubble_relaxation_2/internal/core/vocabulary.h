// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_VOCABULARY_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_VOCABULARY_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_arithmetic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <vector>

// What is compiled once is declared in headers, and defined in headers whose names end in `_impl.h`. A program that is
// linked with the compiled core (target `CGAL::Bubble_relaxation_2_core`) sees declarations only.
#ifdef CGAL_BUBBLE_RELAXATION_2_COMPILED
#define CGAL_BUBBLE_RELAXATION_2_INLINE
#else
#define CGAL_BUBBLE_RELAXATION_2_INLINE inline
#endif

namespace CGAL::Bubble_relaxation_2::internal {

using Kernel = Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Index = std::int32_t;

constexpr Index no_index = -1;

/// a direction, of length 1
struct Direction { double x, y; };

/// A hash of two numbers, whose high and low bits depend on all of theirs.
inline std::uint64_t hash_of_two(std::uint64_t a, std::uint64_t b)
{
  std::uint64_t h = a * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 32) ^ b) * 0xD6E8FEB86659FD93u;
  return h ^ (h >> 32);
}

/// A hash of a place; equal ones have the same.
inline std::uint64_t hash_of_place(double x, double y)
{
  const auto bits = [](double c) {
    c += 0.; // of both zeros the same
    std::uint64_t result;
    std::memcpy(&result, &c, sizeof result);
    return result;
  };
  return hash_of_two(bits(x), bits(y));
}

inline int ccw(int i) { return i == 2 ? 0 : i + 1; }
inline int cw(int i) { return i == 0 ? 2 : i - 1; }

/// reserves room for `n` elements in each of several vectors
template <class... T>
void reserve_each(std::size_t n, std::vector<T>&... arrays)
{
  (arrays.reserve(n), ...);
}

/// Makes room for `n` more elements. A vector of all bubbles that takes in a few more would double its memory
/// otherwise; this adds an eighth, or what is needed.
template <class T>
void make_room_for(std::size_t n, std::vector<T>& array)
{
  if (array.size() + n <= array.capacity())
    return;
  std::vector<T> larger;
  larger.reserve(array.size() + (std::max)(n, array.size() / 8));
  append_in_turn(array, larger);
  array.swap(larger);
}

/// the indices below `n`
inline std::vector<Index> indices_below(std::size_t n)
{
  std::vector<Index> result(n);
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

/// those for which something holds
template <class Holds>
std::vector<Index> indices_where(std::size_t n, const Holds& holds)
{
  std::vector<Index> result;
  for (std::size_t i = 0; i < n; ++i)
    if (holds(static_cast<Index>(i)))
      result.push_back(static_cast<Index>(i));
  return result;
}

/// where flags are set
inline std::vector<Index> marked(const std::vector<char>& flags)
{
  return indices_where(flags.size(), [&flags](Index i) {
    tick(static_cast<std::size_t>(i));
    return flags[i];
  });
}

/// sorts, and keeps one of those that are equal
template <class Vector>
void sort_each_once(Vector& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// where a value is among sorted ones, `no_index` if it is not there
template <class T>
Index index_among(const std::vector<T>& sorted, const T& value)
{
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), value);
  return found != sorted.end() && *found == value ? static_cast<Index>(found - sorted.begin()) : no_index;
}

/// Sorts where it does not matter how long a comparison takes: it is called through a pointer, so that
/// `std::sort()` is compiled once, and not for each comparison.
inline void sort_indices(std::vector<Index>& indices, const std::function<bool(Index, Index)>& less)
{
  std::sort(indices.begin(), indices.end(), [&less](Index i, Index j) { return less(i, j); });
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_VOCABULARY_H
