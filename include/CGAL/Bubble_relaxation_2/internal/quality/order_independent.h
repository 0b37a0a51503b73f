// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_ORDER_INDEPENDENT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_ORDER_INDEPENDENT_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Brings the values from `begin` to `end` into an order in which those at some positions are where sorting
/// would bring them. `first`, `last`: the positions, each greater than the last
template <class Iterator>
void sort_positions(std::vector<double>& values, std::size_t begin, std::size_t end, Iterator first,
                    Iterator last)
{
  if (first == last)
    return;
  const Iterator middle = first + (last - first) / 2;
  const auto at = [&values](std::size_t i) { return values.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(*middle), at(end));
  sort_positions(values, begin, *middle, first, middle);
  sort_positions(values, *middle + 1, end, middle + 1, last);
}

/// What all values are like, where all are here. Another class with these members may know of values elsewhere.
struct All_values_here
{
  double smallest(double value) const { return value; } ///< of this value and others'
  double largest(double value) const { return value; }

  /// the sums of these and others' counts
  template <std::size_t n>
  std::array<std::size_t, n> sums(const std::array<std::size_t, n>& counts) const
  {
    return counts;
  }

  /// the values that sorting would bring to some positions, which do not decrease; \pre none is negative
  template <std::size_t n>
  std::array<double, n> sorted_at(std::vector<double>& values, const std::array<std::size_t, n>& positions) const
  {
    auto distinct = positions;
    sort_positions(values, 0, values.size(), distinct.begin(), std::unique(distinct.begin(), distinct.end()));
    std::array<double, n> result;
    std::transform(positions.begin(), positions.end(), result.begin(),
                   [&values](std::size_t position) { return values[position]; });
    return result;
  }
};

/// The sum of `term(v)` over values, the same to the last bit in whatever order they come: of terms as
/// multiples of a unit, summed as integers. The unit is so small that the mean is off by less than
/// n / 2^60 times the largest term. `all` tells what others have of the values, see `All_values_here`.
/// \pre no term is negative or not a number
template <class Term, class All = All_values_here>
double sum_in_any_order(const std::vector<double>& values, const Term& term, const All& all = All())
{
  double largest = 0;
  for (double v : values)
    largest = (std::max)(largest, term(v));
  largest = all.largest(largest);
  if (largest == 0 || !std::isfinite(largest))
    return largest;
  const double n = static_cast<double>(all.sums(std::array<std::size_t, 1>{values.size()})[0]);
  const int digits = 60 - std::ilogb(n) - std::ilogb(largest);
  // in two parts, since the largest terms may be the smallest numbers
  const double scale = std::ldexp(1., digits / 2), rest = std::ldexp(1., digits - digits / 2);
  std::size_t sum = 0; // stays below 2^62
  for (double v : values)
    sum += static_cast<std::size_t>(static_cast<std::int64_t>(term(v) * scale * rest));
  return std::ldexp(static_cast<double>(all.sums(std::array<std::size_t, 1>{sum})[0]), -digits);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_QUALITY_ORDER_INDEPENDENT_H
