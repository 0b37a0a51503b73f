// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ORDER_INDEPENDENT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ORDER_INDEPENDENT_H

#include <algorithm>
#include <cstddef>
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

/// the values that sorting would bring to some positions, which do not decrease
inline std::vector<double> sorted_at(std::vector<double>& values, const std::vector<std::size_t>& positions)
{
  std::vector<std::size_t> distinct = positions;
  sort_positions(values, 0, values.size(), distinct.begin(), std::unique(distinct.begin(), distinct.end()));
  std::vector<double> result;
  for (std::size_t position : positions)
    result.push_back(values[position]);
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_ORDER_INDEPENDENT_H
