// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_VORONOI_QUALITY_2_H
#define CGAL_VORONOI_QUALITY_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

What finite-volume codes ask of a mesh: the statistics of a `Voronoi_dual_2`. Signs and angles are counted by exact
predicates.
*/
struct Voronoi_quality_2
{
  std::size_t number_of_cells = 0; ///< one for each vertex of the domain
  std::size_t number_of_faces = 0; ///< one for each edge of the domain
  double smallest_area = 0;        ///< of a cell; negative only beside a negative face

  /// \name Faces
  /// @{
  /// the least length of a face over the distance of its two centres. In a lattice of equilateral triangles it is
  /// 0.577, and 0.289 for an edge of the boundary, which has a triangle on one side only.
  double smallest_face_ratio = 0;
  double smallest_face_x = 0;               ///< where that is: the midpoint of the edge
  double smallest_face_y = 0;               ///< the same
  std::size_t number_of_zero_faces = 0;     ///< where four vertices lie on a circle, or a right angle at the boundary
  std::size_t number_of_negative_faces = 0; ///< those of edges that are not Delaunay, or obtuse at the boundary
  /// @}

  /// \name Triangles
  /// @{
  std::size_t number_of_obtuse_triangles = 0; ///< as `Mesh_quality_2` counts them
  /// of these, those that have it opposite to a constraint. If there are none, the cells are the Voronoi cells of the
  /// vertices, clipped at the constraints.
  std::size_t number_of_centers_beyond_constraints = 0;
  /// @}

  /// \name Two-Point Fluxes
  /// of faces between two circumcentres
  /// @{
  /// the largest component of a face along the line of its two centres, over their distance: the roundings of
  /// circumcentres
  double largest_orthogonality_error = 0;
  /// the largest distance of a face's midpoint from that of its edge, over the distance of the centres
  double largest_midpoint_offset = 0;
  /// @}
};

/*!
\ingroup PkgBubbleRelaxation2FiniteVolumes

\brief prints the statistics as a table.
*/
inline std::ostream& operator<<(std::ostream& out, const Voronoi_quality_2& q)
{
  const auto row = [](const std::string& name) { return "  " + name + std::string(36 - name.size(), ' '); };
  std::ostringstream text; // the user's stream keeps its format
  text.imbue(out.getloc());
  text << row("cells, faces") << q.number_of_cells << ", " << q.number_of_faces << '\n'
       << row("smallest area") << q.smallest_area << '\n'
       << row("smallest face over distance") << q.smallest_face_ratio << " at "
       << Bubble_relaxation_2::internal::about_in_words(q.smallest_face_x, q.smallest_face_y) << '\n'
       << row("faces of length 0, negative") << q.number_of_zero_faces << ", " << q.number_of_negative_faces << '\n'
       << row("obtuse triangles, at constraints") << q.number_of_obtuse_triangles << ", "
       << q.number_of_centers_beyond_constraints << '\n'
       << row("largest error of orthogonality") << q.largest_orthogonality_error << '\n'
       << row("largest offset of midpoints") << q.largest_midpoint_offset << '\n';
  return out << text.str();
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_VORONOI_QUALITY_2_H
