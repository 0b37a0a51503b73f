// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MAKE_ROOM_FOR_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MAKE_ROOM_FOR_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Makes room for `n` more elements. A vector of all bubbles that takes in a few more would double its memory
/// otherwise; this adds an eighth, or what is needed.
template <class T>
void make_room_for(std::size_t n, std::vector<T>& array)
{
  if (array.size() + n > array.capacity())
    array.reserve(array.size() + (std::max)(n, array.size() / 8));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MAKE_ROOM_FOR_H
