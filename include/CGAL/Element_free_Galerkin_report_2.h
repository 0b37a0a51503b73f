// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_ELEMENT_FREE_GALERKIN_REPORT_2_H
#define CGAL_ELEMENT_FREE_GALERKIN_REPORT_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <cstddef>
#include <ostream>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

What `Element_free_Galerkin_2::solve()` did.
*/
struct Element_free_Galerkin_report_2
{
  std::size_t number_of_nodes = 0;           ///< each has one unknown
  std::size_t number_of_multipliers = 0;     ///< unknowns on the boundary with `LAGRANGE_MULTIPLIERS`
  std::size_t number_of_cells = 0;           ///< cells of integration
  std::size_t number_of_gauss_points = 0;    ///< points of integration in all cells
  std::size_t number_of_boundary_points = 0; ///< points of integration on the boundary
  /// points of both kinds where supports were enlarged, as `Deficient_support::ENLARGE` says
  std::size_t number_of_enlarged_points = 0;
  double largest_enlargement = 1;      ///< the largest factor of all these
  std::size_t number_of_non_zeros = 0; ///< entries of the matrix
  double residual = 0;                 ///< |b - A x| / (|A| |x| + |b|) in the maximum norm
  double condition_number = 0;         ///< of the matrix, an estimate from below; 0 above 5000 equations
  bool is_stopped_by_callback = false; ///< whether the callback returned `false`: then there is no solution
  double integration_seconds = 0;      ///< wall-clock time of the integrals
  double solution_seconds = 0;         ///< wall-clock time of the solution of the equations
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief prints what was done.
*/
inline std::ostream& operator<<(std::ostream& out, const Element_free_Galerkin_report_2& report)
{
  out << "  " << report.number_of_nodes << " nodes, " << report.number_of_multipliers << " multipliers, "
      << report.number_of_cells << " cells, " << report.number_of_gauss_points << " Gauss points, "
      << report.number_of_boundary_points << " on the boundary\n  supports enlarged at "
      << report.number_of_enlarged_points << " points, by " << report.largest_enlargement << " at most\n  "
      << report.number_of_non_zeros << " non-zeros, condition number " << report.condition_number << ", residual "
      << report.residual << "\n  seconds: integration " << report.integration_seconds << ", solution "
      << report.solution_seconds << '\n';
  if (report.is_stopped_by_callback)
    out << "  stopped by the callback\n";
  return out;
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_ELEMENT_FREE_GALERKIN_REPORT_2_H
