// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Known_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Editable_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the triangles of a piece with a bubble of another rank: among them all at its border
inline std::vector<Index> triangles_beside_others(const Bubbles_2& bubbles, const Marked_triangulation_2& piece)
{
  std::vector<Index> result;
  for (std::size_t t = 0; t < piece.inside.size(); ++t) {
    const std::array<Index, 3>& v = piece.tr.vertices[t];
    if (piece.inside[t] && (bubbles.is_foreign[v[0]] || bubbles.is_foreign[v[1]] || bubbles.is_foreign[v[2]]))
      result.push_back(static_cast<Index>(t));
  }
  return result;
}

/// Forgets the triangles at the border of a piece that the whole mesh may not have; returns whether only those between
/// others' bubbles had to be forgotten, so that the piece is still wide enough. `beside_others`: at least all triangles
/// with a bubble of another rank. `certificate`: of the piece
inline bool forget_doubtful(const Bubbles_2& bubbles, const std::vector<Index>& beside_others,
                            Border_certificate_2& certificate, Editable_triangulation_2& piece)
{
  for (Index t : certificate.doubtful(beside_others)) {
    const std::array<Index, 3>& vertices = piece.triangulation().vertices[t];
    if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return !bubbles.is_foreign[v]; }))
      return false;
    piece.cut_off(t);
  }
  return true;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H
