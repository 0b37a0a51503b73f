// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_OUTLINE_SIMPLIFICATION_REPORT_2_H
#define CGAL_OUTLINE_SIMPLIFICATION_REPORT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

What a call of `simplify_outline_2()` did. Coordinates and lengths are those of the new outline, in `double` whatever
the kernel.
*/
struct Outline_simplification_report_2
{
  using Place = std::array<double, 2>; ///< coordinates

  /// An island that was dropped.
  struct Island
  {
    Place place; ///< a vertex of it
    double area;
  };

  /// A part of the domain that was filled.
  struct Gap
  {
    Place place; ///< the middle of its longest side
    double area;
  };

  /// A segment of the new outline, and one of those of the old outline that it stands for: what is known of that one,
  /// such as a marker, holds for the piece. Where a rule made a piece that stands for none, both old ends are the
  /// piece's own.
  struct Piece
  {
    Place source, target, old_source, old_target;
    bool is_new; ///< made by a rule
  };

  std::size_t number_of_old_segments = 0; ///< of the outline as it was, without constraints outside of the domain
  std::size_t number_of_segments = 0;     ///< of the new outline, without these
  std::size_t number_of_corners = 0;      ///< vertices with two segments that were kept because they are sharp

  /// \name Fidelity
  /// @{
  /// The two-sided Hausdorff distance between the old outline, as the rules left it, and the new one, up to a relative
  /// error of 1e-6, not less than it is.
  double hausdorff_distance = 0;
  /// the largest distance of a piece from its part of the old outline over its tolerance
  double largest_share_of_tolerance = 0;
  double old_area = 0; ///< of the domain in the outline as it was
  double area = 0;     ///< of the domain in the new one
  /// @}

  double share_of_fitting_pieces = 0; ///< the share of the pieces with lengths between 0.6 d and 1.5 d
  /// \name Vertices of a Mesh
  /// What the domain asks of a mesher, without half of the vertices on the outline, which come on top. Each is 0 if d
  /// would have to be asked more than 20 million times for it.
  /// @{
  /// about as many as d alone asks for: the integral of 2 / (sqrt(3) d^2) over the domain
  double wanted_vertices = 0;
  /// At least as many more because of islands that are smaller than d, and near to each other or to the rest of the
  /// outline, whatever outline within the tolerance is taken, with sizes that grow by 0.2, the default `size_growth` of
  /// `npbs_relax()`. A mesher whose sizes grow faster needs fewer. It is a bound that may be far from what a mesh has:
  /// \ref BR2_outline tells what does not count.
  double forced_vertices = 0;
  /// @}

  double shortest_piece = 0;      ///< the least length of a piece in units of d
  Place shortest_place = Place(); ///< where that is

  std::vector<Island> dropped_islands; ///< by `minimum_island_area`
  std::vector<Gap> filled_gaps;        ///< by `minimum_gap`
  std::vector<Piece> pieces;           ///< the new outline
  std::vector<Place> seeds;            ///< those of the given seeds that are still in regions of their kind
  double seconds = 0;                  ///< of wall-clock time
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief prints what was done.
*/
inline std::ostream& operator<<(std::ostream& out, const Outline_simplification_report_2& report)
{
  return out << "  segments" << std::string(28, ' ') << report.number_of_segments << " instead of "
             << report.number_of_old_segments << "\n  of these .6 to 1.5 d long" << std::string(11, ' ')
             << 100 * report.share_of_fitting_pieces << " %\n  Hausdorff distance" << std::string(18, ' ')
             << report.hausdorff_distance << "\n  area of the domain" << std::string(18, ' ') << report.area
             << " instead of " << report.old_area << "\n  vertices that d alone asks for" << std::string(6, ' ')
             << std::llround(report.wanted_vertices) << "\n  islands, narrows force at least" << std::string(5, ' ')
             << std::llround(report.forced_vertices) << "\n  dropped islands, filled gaps" << std::string(8, ' ')
             << report.dropped_islands.size() << ", " << report.filled_gaps.size() << "\n  seconds"
             << std::string(29, ' ') << report.seconds << '\n';
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_OUTLINE_SIMPLIFICATION_REPORT_2_H
