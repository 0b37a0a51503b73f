// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MERGE_TAIL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MERGE_TAIL_H

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Sorts a sequence whose first elements are sorted, so many of them: mostly few came after these.
template <class T, class Is_before = std::less<T>>
void merge_tail(std::vector<T>& sequence, std::size_t sorted, const Is_before& is_before = Is_before())
{
  const auto middle = sequence.begin() + static_cast<std::ptrdiff_t>(sorted);
  std::sort(middle, sequence.end(), is_before);
  std::inplace_merge(sequence.begin(), middle, sequence.end(), is_before);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MERGE_TAIL_H
