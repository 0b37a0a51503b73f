// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_NODES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_NODES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>

#include <cstddef>

namespace CGAL::Bubble_relaxation_2::internal {

/// Fills a set of nodes with bubbles and their neighbour sets.
template <class Cdt, class Node_set>
void write_nodes(const Bubbles_2& bubbles, const Elevations<Cdt>& elevations, double neighbor_radius,
                 const Threads& threads, Node_set& nodes)
{
  nodes.neighbor_radius = neighbor_radius;
  find_neighbors(bubbles, neighbor_radius, threads, nodes.neighbor_offsets, nodes.neighbors);
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    if constexpr (Plane_2<Cdt>::has_elevation)
      nodes.points.push_back(Plane_2<Cdt>::point(bubbles.x[i], bubbles.y[i], elevations[i]));
    else
      nodes.points.push_back(typename Node_set::Point_2(bubbles.x[i], bubbles.y[i]));
    nodes.sizes.push_back(bubbles.d[i]);
    nodes.dimensions.push_back(bubbles.dimension[i]);
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_WRITE_NODES_H
