// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_EVALUATE_DUAL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_EVALUATE_DUAL_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/dual/dual_faces.h>

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Voronoi_quality_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

inline void add_obtuse_triangles(const Marked_copy_2& domain, Voronoi_quality_2& quality)
{
  for (std::size_t k = 0; k < domain.tr.number_of_triangles(); ++k)
    for (int i = 0; i < 3 && domain.tr.inside[k]; ++i) {
      const Index t = static_cast<Index>(k);
      const Point tip = domain.tr.point(t, i);
      const Kernel::Vector_2 u = domain.tr.point(t, ccw(i)) - tip, v = domain.tr.point(t, cw(i)) - tip;
      if (!is_obtuse(u * v, u.x() * v.y() - u.y() * v.x()))
        continue;
      ++quality.number_of_obtuse_triangles;
      quality.number_of_centers_beyond_constraints += domain.is_constrained(t, i) ? 1 : 0;
    }
}

inline void add_face(const Flat_triangulation_2& tr, const Dual_face_2& f, Voronoi_quality_2& quality)
{
  const double ratio = f.length / f.distance;
  if (quality.number_of_faces++ == 0 || ratio < quality.smallest_face_ratio) {
    quality.smallest_face_ratio = ratio;
    quality.smallest_face_x = f.middle.x();
    quality.smallest_face_y = f.middle.y();
  }
  quality.number_of_negative_faces += f.sign == NEGATIVE ? 1 : 0;
  quality.number_of_zero_faces += f.sign == ZERO ? 1 : 0;
  if (!f.has_right) // the rest is of faces between two circumcentres
    return;
  const Point p = circumcenter_of(tr, tr.neighbors[f.triangle][f.side]), q = circumcenter_of(tr, f.triangle);
  const double slant = (q.x() - p.x()) * f.along.x + (q.y() - p.y()) * f.along.y;
  quality.largest_orthogonality_error =
    (std::max)(quality.largest_orthogonality_error, std::abs(slant) / f.distance);
  quality.largest_midpoint_offset =
    (std::max)(quality.largest_midpoint_offset, std::abs(f.left - f.right) / 2 / f.distance);
}

/// \param areas of the cells
inline Voronoi_quality_2 evaluate_dual(const Marked_copy_2& domain, const std::vector<Dual_face_2>& faces,
                                       const std::vector<double>& areas)
{
  Voronoi_quality_2 quality;
  quality.number_of_cells = areas.size();
  quality.smallest_area = *std::min_element(areas.begin(), areas.end());
  for (const Dual_face_2& f : faces)
    add_face(domain.tr, f, quality);
  add_obtuse_triangles(domain, quality);
  return quality;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_EVALUATE_DUAL_H
