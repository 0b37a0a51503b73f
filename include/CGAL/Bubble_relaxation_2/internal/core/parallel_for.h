// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#endif

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Calls `f(i)` for all i in [0, n). `f` may write only what belongs to `i`, so that the result does
/// not depend on the number of threads. `grain`: how many calls are worth a task.
template <class Concurrency_tag, class Function>
void parallel_for(std::size_t n, const Function& f, [[maybe_unused]] std::size_t grain = 1024)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<Concurrency_tag, Parallel_tag>::value) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&](const tbb::blocked_range<std::size_t>& r) {
                        for (std::size_t i = r.begin(); i != r.end(); ++i)
                          f(i);
                      });
    return;
  }
#else
  static_assert(!std::is_convertible<Concurrency_tag, Parallel_tag>::value,
                "Parallel_tag needs a program linked with TBB (CGAL::TBB_support)");
#endif
  for (std::size_t i = 0; i < n; ++i)
    f(i);
}

/// Sorts values of which none are equal, or else cannot be told apart: so the result does not depend on the
/// number of threads.
template <class Concurrency_tag, class T, class Less = std::less<T>>
void parallel_sort(std::vector<T>& values, const Less& less = Less())
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<Concurrency_tag, Parallel_tag>::value) {
    tbb::parallel_sort(values.begin(), values.end(), less);
    return;
  }
#endif
  std::sort(values.begin(), values.end(), less);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H
