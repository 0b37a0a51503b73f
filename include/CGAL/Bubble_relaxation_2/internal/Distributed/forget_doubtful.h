// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/triangles_beside_others.h>
#include <CGAL/Bubble_relaxation_2/internal/Editable_triangulation_2.h>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Forgets the triangles at the border of a piece that the whole mesh may not have; returns whether only those between
/// others' bubbles had to be forgotten, so that the piece is still wide enough. `beside_others`: at least all triangles
/// with a bubble of another rank. `certificate`: of the piece
inline bool forget_doubtful(const Bubbles_2& bubbles, const std::vector<Index>& beside_others,
                            Border_certificate_2& certificate, Editable_triangulation_2& piece)
{
  for (Index t : certificate.doubtful(beside_others)) {
    if (!is_between_others(bubbles, piece.triangulation().vertices[t]))
      return false;
    piece.cut_off(t);
  }
  return true;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_FORGET_DOUBTFUL_H
