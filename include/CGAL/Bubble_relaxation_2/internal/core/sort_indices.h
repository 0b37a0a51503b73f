// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SORT_INDICES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SORT_INDICES_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A reference to a comparison of numbers.
struct Index_order
{
  const void* less;
  bool (*call)(const void* less, Index, Index);

  bool operator()(Index i, Index j) const { return call(less, i, j); }
};

inline void sort_by(std::vector<Index>& indices, Index_order order) { std::sort(indices.begin(), indices.end(), order); }

/// Sorts where it does not matter how long a comparison takes: it is called through a pointer, so that
/// `std::sort()` is compiled once, and not for each comparison.
template <class Less>
void sort_indices(std::vector<Index>& indices, const Less& less)
{
  sort_by(indices, Index_order{&less, [](const void* l, Index i, Index j) -> bool {
                                 return (*static_cast<const Less*>(l))(i, j);
                               }});
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_SORT_INDICES_H
