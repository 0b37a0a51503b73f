// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_PIECE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_PIECE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A rank's triangles of the domain and others' triangles around them: only such as the mesh of all ranks has, so
/// that they stay a part of it while all ranks tell each other how they move the vertices. Where the domain goes
/// on and the piece ends, a triangle has no neighbour, and its side is no edge or labelled as an inner one.
struct Mesh_piece_2
{
  Distributed_mesh_2 mesh;
  Messages<Index> sent;     ///< own bubbles that other ranks have, in the order of their numbers
  Messages<Index> received; ///< others' bubbles that this rank has, in the same order as there
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_PIECE_2_H
