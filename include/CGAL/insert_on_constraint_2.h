// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_INSERT_ON_CONSTRAINT_2_H
#define CGAL_INSERT_ON_CONSTRAINT_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/insert_on_constraint.h>
#include <CGAL/Bubble_relaxation_parameters.h>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief inserts a point that is meant to lie on a constraint into that constraint.

A point of a slanted constraint that was computed, or read from a file, lies beside it by a rounding, and so does the
end of a constraint that is to meet another one there. Inserted by `CDT::insert()` it leaves a triangle without area
between itself and the constraint, which every mesh then has, or it lies outside of the domain. Here the constraint is
split, so that it passes the point, which keeps its coordinates.
- If a vertex is no farther from `p` than the tolerance, the nearest is taken in the place of `p`, else `p` becomes one.
- If that is no vertex of a constraint yet, the nearest of the constraints that are no farther from it, and beside which
  it lies between their ends, is split and passes it. A vertex without constraints between both comes to lie on its
  other side.

As after `CDT::insert()`, faces that are new are not marked as in the domain and have no region: insert all points
before those.

\tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one, also of a terrain,
whose points are near to each other where their places in the plane are
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation
\param p the point
\param tolerance how far a vertex or a constraint may be, in the units of the coordinates. It is at least 16 roundings
of the largest coordinate near by, also by default
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_marker_map}
    \cgalParamDescription{the markers of constraints; both parts of one that is split get its marker}
    \cgalParamType{a model of `ReadWritePropertyMap` as for `npbs_relax()`, such as `Constraint_marker_map_2`}
    \cgalParamDefault{constraints have no markers}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the vertex of `p`, or the one near to it

\throws std::invalid_argument if the tolerance is negative or not finite, if a coordinate is not finite or beyond the
bounds of `npbs_relax()`, if `cdt` has no faces yet, as with a single constraint in it, or if a constraint, or a vertex,
is in the way of the one that is to pass `p`. Then `cdt` has the vertices and constraints that it had.

\sa `npbs_relax()`
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
typename CDT::Vertex_handle insert_on_constraint_2(CDT& cdt, const typename CDT::Point& p, double tolerance = 0,
                                                   const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, typename CDT::Vertex_handle>(np, [&](const auto& pack) {
    return insert_on_constraint(cdt, p, tolerance, pack);
  });
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_INSERT_ON_CONSTRAINT_2_H
