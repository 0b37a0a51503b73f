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

#include <algorithm>
#include <array>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Forgets the triangles at the border of a piece that the whole mesh may not have; returns whether only those between
/// others' bubbles had to be forgotten, so that the piece is still wide enough.
inline bool forget_doubtful(const Bubbles_2& bubbles, Marked_triangulation_2& piece)
{
  const Border_certificate_2 certificate(piece);
  for (Index t : certificate.doubtful()) {
    const std::array<Index, 3>& vertices = piece.tr.vertices[t];
    if (std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return !bubbles.is_foreign[v]; }))
      return false;
    piece.inside[t] = 0;
    for (Index& n : piece.tr.neighbors[t])
      if (n != no_index) {
        piece.tr.neighbors[n][piece.tr.index_of_neighbor(n, t)] = no_index;
        n = no_index;
      }
  }
  return true;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H
