// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_MESH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_MESH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Bubbles and the triangles between them, whose vertices are indices of bubbles.
struct Bubble_mesh_2
{
  Bubbles_2 bubbles;
  Marked_triangles_2 triangles;

  Point point(Index t, int i) const { return bubbles.point(static_cast<std::size_t>(triangles.vertices[t][i])); }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_BUBBLE_MESH_2_H
