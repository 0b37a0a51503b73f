// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PATCH_CHANGE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PATCH_CHANGE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a bubble of a patch after an operation, `GONE` if it was deleted
struct Changed_bubble_2
{
  std::int32_t operation; ///< the place of the operation among all, the worst triangle's first
  std::int32_t owner;
  Bubble_record_2 bubble;
};

/// a triangle that an operation takes away or makes
struct Changed_triangle_2
{
  std::int32_t operation;
  std::int32_t is_new;
  std::array<std::int64_t, 3> vertices; ///< their numbers
  std::array<Index, 3> edges;           ///< labels
};

/// What an operation makes of a patch, in the words of all ranks.
struct Patch_change_2
{
  std::vector<Changed_bubble_2> bubbles; ///< all of the patch; what is inserted comes in the order of its numbers
  std::vector<Changed_triangle_2> triangles;
};

/// changes by the places of their operations
using Patch_changes_2 = std::map<std::int32_t, Patch_change_2>;

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PATCH_CHANGE_2_H
