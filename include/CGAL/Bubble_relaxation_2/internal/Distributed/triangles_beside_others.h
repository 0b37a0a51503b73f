// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLES_BESIDE_OTHERS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLES_BESIDE_OTHERS_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// whether a triangle has a bubble of another rank
inline bool is_beside_others(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return bubbles.is_foreign[vertices[0]] || bubbles.is_foreign[vertices[1]] || bubbles.is_foreign[vertices[2]];
}

/// whether all three bubbles of a triangle are others'
inline bool is_between_others(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return bubbles.is_foreign[vertices[0]] && bubbles.is_foreign[vertices[1]] && bubbles.is_foreign[vertices[2]];
}

/// the triangles of a piece with a bubble of another rank: among them all at its border
inline std::vector<Index> triangles_beside_others(const Bubbles_2& bubbles, const Marked_triangulation_2& piece)
{
  std::vector<Index> result;
  for (std::size_t t = 0; t < piece.inside.size(); ++t)
    if (piece.inside[t] && is_beside_others(bubbles, piece.tr.vertices[t]))
      result.push_back(static_cast<Index>(t));
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TRIANGLES_BESIDE_OTHERS_H
