// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Source_search_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What a triangle of the target has in common with one of the source.
struct Face_overlap_2
{
  Index source;
  double area;
  Offset_2 moment; ///< the integrals of the barycentric coordinates 1 and 2 of the source's triangle
};

/// the integrals of the barycentric coordinates over what two triangles have in common
inline Offset_2 moment_of(const Overlap_polygon_2& polygon, double target_area)
{
  std::array<Weights_3, Overlap_polygon_2::most> w;
  for (int k = 0; k < polygon.size(); ++k)
    w[k] = polygon.source_weights(k);
  Offset_2 sum{0, 0};
  polygon.for_each_triangle([&](int i, int j, int k, double share) {
    sum.x += share * target_area * (w[i][1] + w[j][1] + w[k][1]) / 3;
    sum.y += share * target_area * (w[i][2] + w[j][2] + w[k][2]) / 3;
  });
  return sum;
}

/// All pairs of triangles that overlap, by the triangles of the target, and by those of the source for each.
using Face_overlaps_2 = std::vector<std::vector<Face_overlap_2>>;

inline Face_overlaps_2 face_overlaps(const Source_search_2& search, const Face_set_2& target, const Threads& threads)
{
  Face_overlaps_2 overlaps(target.number_of_triangles());
  parallel_for(
    threads, overlaps.size(),
    [&](std::size_t k) {
      const Index t = static_cast<Index>(k);
      search.for_each_overlap(target, t, [&](Index s, const Overlap_polygon_2& polygon) {
        overlaps[k].push_back(Face_overlap_2{s, polygon.area(), moment_of(polygon, target.area(t))});
      });
      overlaps[k].shrink_to_fit();
    },
    256);
  return overlaps;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_OVERLAPS_2_H
