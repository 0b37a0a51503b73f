// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_SIMPLIFY_OUTLINE_2_H
#define CGAL_SIMPLIFY_OUTLINE_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/simplify_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/write_mesh.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Outline_simplification_report_2.h>

namespace CGAL {

template <class CDT, class NamedParameters = parameters::Default_named_parameters>
Outline_simplification_report_2<double> simplify_outline_2(CDT& cdt,
                                                           const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;

  const Outline_reading_2<CDT> reading(cdt, np);
  const Simplified_outline_2 outline = simplify_outline(reading.problem);
  Restore_on_throw<CDT> guard(cdt);
  Outline_writing_2<CDT>(cdt, reading, outline)();
  guard.all_went_well();
  return outline.report;
}

} // namespace CGAL

#endif // CGAL_SIMPLIFY_OUTLINE_2_H
