// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_EDGE_LABEL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_EDGE_LABEL_H

#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What `Marked_triangulation_2::edges` says of sides on edges of the domain while defects are treated: unlike an index,
/// it stays what it is when vertices on edges come and go, and all ranks understand it.
enum Edge_label : Index { OUTLINE = 0, INNER = 1 };

/// whether the domain ends or goes on beyond a side on an edge of the domain
inline Edge_label edge_label(const Marked_triangulation_2& m, Index t, int i)
{
  const Index n = m.tr.neighbors[t][i];
  return n != no_index && m.inside[n] ? INNER : OUTLINE;
}

/// makes indices of edges labels
inline void label_edges(Marked_triangulation_2& m)
{
  for (std::size_t t = 0; t < m.edges.size(); ++t)
    for (int i = 0; i < 3; ++i)
      if (m.edges[t][i] != no_index)
        m.edges[t][i] = edge_label(m, static_cast<Index>(t), i);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_EDGE_LABEL_H
