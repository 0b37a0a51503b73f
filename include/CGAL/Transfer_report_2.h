// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_TRANSFER_REPORT_2_H
#define CGAL_TRANSFER_REPORT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

What a call of `transfer_vertex_values_2()` or `transfer_face_values_2()` did. All areas and integrals are those of the
faces that took part. `Vertex_transfer::INTERPOLATION` intersects no triangles: `overlap_area`, `uncovered_area` and
`overlap_integral` are not a number then, and `number_of_pairs` is 0.
*/
struct Transfer_report_2
{
  double source_area = 0;    ///< the area of the source's faces
  double target_area = 0;    ///< the area of the target's faces
  double overlap_area = 0;   ///< what both have in common
  double uncovered_area = 0; ///< what the source does not cover of the target; if it covers all, up to roundings

  double source_integral = 0;  ///< the integral of the source's values over the source
  double overlap_integral = 0; ///< the integral of the source's values over what both have in common
  double target_integral = 0;  ///< the integral of the new values over the target

  std::size_t number_of_pairs = 0; ///< pairs of triangles that overlap
  double seconds = 0;              ///< of wall-clock time
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief prints what was done.
*/
inline std::ostream& operator<<(std::ostream& out, const Transfer_report_2& report)
{
  const auto row = [](const std::string& name) { return "  " + name + std::string(36 - name.size(), ' '); };
  std::ostringstream text; // whatever the format of the user's stream
  text.imbue(out.getloc());
  text << row("area of source, of target") << report.source_area << ", " << report.target_area << '\n';
  if (std::isnan(report.overlap_area))
    text << row("integral before, after") << report.source_integral << ", " << report.target_integral << '\n';
  else
    text << row("overlap, uncovered") << report.overlap_area << ", " << report.uncovered_area << '\n'
         << row("integral before, of overlap, after") << report.source_integral << ", " << report.overlap_integral
         << ", " << report.target_integral << '\n'
         << row("pairs of triangles") << report.number_of_pairs << '\n';
  text << row("seconds") << report.seconds << '\n';
  return out << text.str();
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_TRANSFER_REPORT_2_H
