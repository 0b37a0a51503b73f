// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MESH_SURROUNDINGS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MESH_SURROUNDINGS_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// How an existing mesh looks around a vertex.
struct Mesh_surroundings_2
{
  double spacing;   ///< mean length of the edges
  double direction; ///< angle of the shortest edge

  /// whether a bubble of size `d` may stay there: the mesh is about as fine as d asks
  bool fits(double d) const
  {
    constexpr double largest_misfit = 1.25;
    return !(spacing > largest_misfit * d || d > largest_misfit * spacing);
  }
};

/// `ring`: the neighbours of a vertex at `p`, counterclockwise from the lexicographically smallest one on
inline Mesh_surroundings_2 mesh_surroundings(const Point& p, const std::vector<Point>& ring)
{
  double sum = 0, shortest = 0, direction = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double dx = ring[k].x() - p.x(), dy = ring[k].y() - p.y(), length = std::hypot(dx, dy);
    sum += length;
    if (k == 0 || length < shortest) {
      shortest = length;
      direction = std::atan2(dy, dx);
    }
  }
  return Mesh_surroundings_2{sum / static_cast<double>(ring.size()), direction};
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MESH_SURROUNDINGS_2_H
