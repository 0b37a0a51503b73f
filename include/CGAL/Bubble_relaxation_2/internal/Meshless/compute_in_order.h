// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_COMPUTE_IN_ORDER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_COMPUTE_IN_ORDER_H

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// calls `f(i)` for all i in [0, n), perhaps by several threads
using Parallel_loop = std::function<void(std::size_t n, const std::function<void(std::size_t)>& f)>;

/// Computes `n` parts, many at once, and hands them on in their order, so that sums do not depend on the number
/// of threads: calls `compute(i, part)`, then `take(parts, number)` for so many consecutive parts. Of several
/// exceptions that of the first part is the one that is thrown. Stops when `go_on(number of parts that are done)`
/// returns false, and returns that.
template <class Part, class Compute, class Take, class Go_on>
bool compute_in_order(const Parallel_loop& parallel, std::size_t n, const Compute& compute, const Take& take,
                      const Go_on& go_on)
{
  constexpr std::size_t at_once = 512;
  std::vector<Part> parts((std::min)(n, at_once));
  std::vector<std::exception_ptr> errors(parts.size());
  for (std::size_t first = 0; first < n; first += at_once) {
    const std::size_t number = (std::min)(at_once, n - first);
    parallel(number, [&](std::size_t k) {
      try {
        compute(first + k, parts[k]);
      } catch (...) {
        errors[k] = std::current_exception();
      }
    });
    for (const std::exception_ptr& error : errors)
      if (error)
        std::rethrow_exception(error);
    take(parts, number);
    if (!go_on(first + number))
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_COMPUTE_IN_ORDER_H
