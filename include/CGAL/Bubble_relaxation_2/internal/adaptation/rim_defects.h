// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_DEFECTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_DEFECTS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/radius_ratio_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The corners of a part on its rim that have a bad triangle: the treatment could not make it better, since they stay.
inline std::vector<Index> rim_defects(const Domain_2& part, const Bubble_mesh_2& mesh)
{
  constexpr double bad = 0.92; // few are worse in a mesh that is made at once
  std::vector<char> is_on_rim(part.corners().size(), 0), is_defect(is_on_rim);
  for (const Domain_edge_2& e : part.edges())
    if (!e.takes_bubbles)
      is_on_rim[e.source] = is_on_rim[e.target] = 1;
  const Bubbles_2& b = mesh.bubbles;
  for (std::size_t t = 0; t < mesh.triangles.number_of_triangles(); ++t) {
    tick(t);
    const Index f = static_cast<Index>(t);
    if (!mesh.triangles.inside[t] ||
        !(CGAL::radius_ratio_2(mesh.point(f, 0), mesh.point(f, 1), mesh.point(f, 2)) < bad))
      continue;
    for (Index v : mesh.triangles.vertices[t])
      if (b.is_corner(v) && b.host[v] != no_index && is_on_rim[b.host[v]])
        is_defect[b.host[v]] = 1;
  }
  return marked(is_defect);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_RIM_DEFECTS_H
