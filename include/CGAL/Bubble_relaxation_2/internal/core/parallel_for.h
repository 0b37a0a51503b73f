// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL::Bubble_relaxation_2::internal {

/// Who runs the loops of the stages: one thread, or several. A value that the entry points make of the user's
/// `concurrency_tag`, so that the stages are compiled once, whether or not a program is linked with TBB.
class Threads
{
public:
  /// refers to what is to be done with the numbers from `first` to `last`, without. It owns nothing: unlike a
  /// `std::function` it costs the compiler no classes, and there is one for each loop.
  struct Part
  {
    const void* function;
    void (*call)(const void* function, std::size_t first, std::size_t last);

    void operator()(std::size_t first, std::size_t last) const { call(function, first, last); }
  };

  /// calls `part(first, last)` for parts of [0, n), of about `grain` each
  using Run = void (*)(std::size_t n, std::size_t grain, const Part& part);

  Threads() : m_run(&run_in_turn) {}
  explicit Threads(Run runs) : m_run(runs) {}

  void run(std::size_t n, std::size_t grain, const Part& part) const { m_run(n, grain, part); }

private:
  static void run_in_turn(std::size_t n, std::size_t grain, const Part& part)
  {
    for (std::size_t first = 0; first < n; first += grain)
      part(first, (std::min)(first + grain, n));
  }

  Run m_run;
};

#ifdef CGAL_LINKED_WITH_TBB
inline void run_with_tbb(std::size_t n, std::size_t grain, const Threads::Part& part)
{
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [&part](const tbb::blocked_range<std::size_t>& r) { part(r.begin(), r.end()); });
}
#endif

/// the threads that a tag of CGAL asks for
template <class Concurrency_tag>
Threads threads_of()
{
  if constexpr (std::is_convertible<Concurrency_tag, Parallel_tag>::value) {
#ifdef CGAL_LINKED_WITH_TBB
    return Threads(&run_with_tbb);
#else
    static_assert(!std::is_convertible<Concurrency_tag, Parallel_tag>::value,
                  "Parallel_tag needs a program linked with TBB (CGAL::TBB_support)");
#endif
  }
  return Threads();
}

/// Calls `f(i)` for all i in [0, n). `f` may write only what belongs to `i`, so that the result does
/// not depend on the number of threads. `grain`: how many calls are worth a task.
template <class Function>
void parallel_for(const Threads& threads, std::size_t n, const Function& f, std::size_t grain = 1024)
{
  const auto part = [&f](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i != last; ++i) {
      f(i);
      if (i % 64 == 0 || i + 1 == last)
        tick();
    }
  };
  using Part = decltype(part);
  const auto call = [](const void* function, std::size_t first, std::size_t last) {
    (*static_cast<Part*>(function))(first, last);
  };
  threads.run(n, grain, Threads::Part{&part, call});
}

/// Sorts values of which none are equal, or else cannot be told apart: so the result does not depend on the
/// number of threads. Blocks are sorted, then merged two by two.
template <class T, class Less>
void parallel_sort(const Threads& threads, std::vector<T>& values, const Less& less)
{
  std::size_t block = (std::max)(values.size() / 16, std::size_t(4096)); // in one thread, too, which ticks between them
  const auto at = [&values](std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>((std::min)(i, values.size()));
  };
  const auto number_of = [&values](std::size_t size) { return size == 0 ? 0 : (values.size() + size - 1) / size; };
  parallel_for(
    threads, number_of(block), [&](std::size_t k) { std::sort(at(k * block), at((k + 1) * block), less); }, 1);
  for (; block < values.size(); block *= 2)
    parallel_for(
      threads, number_of(2 * block),
      [&](std::size_t k) {
        std::inplace_merge(at(2 * k * block), at((2 * k + 1) * block), at((2 * k + 2) * block), less);
      },
      1);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PARALLEL_FOR_H
