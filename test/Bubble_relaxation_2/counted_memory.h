// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_COUNTED_MEMORY_H
#define BUBBLE_RELAXATION_2_TEST_COUNTED_MEMORY_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

// Replaces `new` and `delete` of the whole program, so that memory is counted and can be let end. One translation unit
// of a program can include this, whose threads, if it has any, take turns.

namespace counted_memory {

/// after so many allocations there is no memory; negative: there always is
inline long allocations_left = -1;
inline std::size_t memory = 0, most_memory = 0; // in bytes

constexpr std::size_t head = alignof(std::max_align_t); // before each allocation, for its size

} // namespace counted_memory

// not inlined, or compilers take them apart and miss the partner of each
[[gnu::noinline]] void* operator new(std::size_t size)
{
  using namespace counted_memory;
  const bool is_possible = allocations_left != 0 && size + head > size;
  char* p = is_possible ? static_cast<char*>(std::malloc(size + head)) : nullptr;
  if (p == nullptr)
    throw std::bad_alloc();
  if (allocations_left > 0)
    --allocations_left;
  *reinterpret_cast<std::size_t*>(p) = size;
  memory += size;
  most_memory = (std::max)(most_memory, memory);
  return p + head;
}

[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept // that of a sanitizer is another
{
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

[[gnu::noinline]] void operator delete(void* p) noexcept
{
  if (p == nullptr)
    return;
  char* start = static_cast<char*>(p) - counted_memory::head;
  counted_memory::memory -= *reinterpret_cast<std::size_t*>(start);
  std::free(start);
}

[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }

#endif // BUBBLE_RELAXATION_2_TEST_COUNTED_MEMORY_H
