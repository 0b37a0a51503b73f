// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

/*!
\ingroup PkgBubbleRelaxation2Concepts
\cgalConcept

The concept `BubbleSizingField_2` describes the wanted distance d of neighbouring bubbles as a function of
the place.

It is called many times, at points of the domain, its boundary included, where it must return a positive
and finite number; everything else makes `npbs_relax()` throw. Points on slanted edges are rounded: they may
lie outside of the domain by a rounding of their coordinates, and a field that is defined in the domain only
has to answer there as well. Its value must depend on the point only. It
need not be continuous, but a mesh cannot follow a size that changes faster than about 0.3 times the
distance; `CGAL::Gradation_limited_sizing_field_2` makes one of it that does not. With `Parallel_tag` it is called by several threads at once.

\cgalHasModelsBegin
\cgalHasModels{any function object or lambda with this signature}
\cgalHasModels{CGAL::Gradation_limited_sizing_field_2<CDT>}
\cgalHasModels{CGAL::Interpolated_sizing_field_2<Triangulation>}
\cgalHasModels{CGAL::Outline_limited_sizing_field_2<CDT>}
\cgalHasModels{CGAL::Region_sizing_field_2<CDT>}
\cgalHasModels{CGAL::Minimum_sizing_field_2<Fields>}
\cgalHasModels{CGAL::Constant_sizing_field_2}
\cgalHasModelsEnd

\sa `CGAL::npbs_relax()`
\sa `CGAL::Bubble_mesh_criteria_2`
*/
class BubbleSizingField_2
{
public:
  /// the number type of the kernel, or another that converts to `double`
  typedef unspecified_type FT;

  /// the point type of the triangulation's traits; for a terrain the kernel's `Point_2`
  typedef unspecified_type Point_2;

  /// returns the wanted distance at `p`, in the units of the coordinates.
  FT operator()(const Point_2& p) const;
};
