// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_TRANSFER_2_H
#define CGAL_TRANSFER_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/read_faces.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/transfer_face_values.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/transfer_vertex_values.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Transfer_report_2.h>

#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief carries values at the vertices of a triangulation, linear in its triangles, over to the vertices of another
triangulation of the same domain.

For the projections both triangulations are intersected, triangle by triangle, and integrals over the parts are
computed with the values of both sides, as Farrell and Maddison do (<em>Conservative interpolation between volume
meshes by local Galerkin projection</em>, Computer Methods in Applied Mechanics and Engineering 200 (2011)). The
projection is the linear function on the target whose difference from the source's is the smallest in the mean square.
Its integral is that of the source, to 13 digits, where both cover the same domain, be it up to roundings such as
those of nodes on slanted edges. A function that is linear in the whole domain comes out as it was.

\cgalHeading{Domains That Differ}

Where the source does not reach, such as behind an outline that has been moved or was made finer, the field goes on
with its value in the nearest point of the source, and what the target does not cover is left out. So constants stay
constant and no value is invented, and the integral over the target is that of the source over what both have in
common, and of the continued values over the rest: `Transfer_report_2` tells the areas and all integrals. With
`keep_integral` the integral over the target becomes that over the whole source.

\cgalHeading{Parts}

With `source_faces` and `target_faces` values are transferred between the old and the new faces of a part that has been
meshed anew, and nothing depends on the size of the rest. Vertices on the rim of the part belong to the rest too, so
they should keep their values: they are named by `vertex_is_constrained_map`. The others then make up the integral. To a
visitor of `npbs_adapt()` they are the vertices of new faces that are none of the new vertices.

The result is determined by the points, triangles and values: it has the same bits for any order in which triangulations
store them and for any number of threads, and the same up to the scale for points or values in other units, by powers of
two. It is computed in `double`, whatever the kernel.

\tparam SourceTriangulation a 2D triangulation of \cgal, such as `Constrained_Delaunay_triangulation_2`
\tparam SourceValueMap a model of `ReadablePropertyMap` with `SourceTriangulation::Vertex_handle` as key and a number as
value
\tparam TargetTriangulation as `SourceTriangulation`; both may be of different types
\tparam TargetValueMap a model of `WritablePropertyMap` with `TargetTriangulation::Vertex_handle` as key and a
value that `double` converts to
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the triangulation that has values. It must still exist: a copy that was made before `npbs_relax()`, or the
faces that were taken out of it
\param source_values the values; they are read at the vertices of the faces that take part
\param target the triangulation that gets values; it may be the same one
\param target_values takes the new values; they are written to the vertices of the faces that take part, after all has
been computed
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{transfer_method}
    \cgalParamDescription{how the values are transferred}
    \cgalParamType{`Vertex_transfer`}
    \cgalParamDefault{`PROJECTION`}
  \cgalParamNEnd
  \cgalParamNBegin{source_faces}
    \cgalParamDescription{the faces of the source that take part; one that comes twice counts once}
    \cgalParamType{a range of `SourceTriangulation::Face_handle`}
    \cgalParamDefault{those that `source_in_domain_map` tells}
  \cgalParamNEnd
  \cgalParamNBegin{target_faces}
    \cgalParamDescription{the faces of the target that take part; one that comes twice counts once}
    \cgalParamType{a range of `TargetTriangulation::Face_handle`}
    \cgalParamDefault{those that `target_in_domain_map` tells}
  \cgalParamNEnd
  \cgalParamNBegin{source_in_domain_map}
    \cgalParamDescription{whether a face of the source takes part; asked for all finite ones}
    \cgalParamType{a model of `ReadablePropertyMap` with `SourceTriangulation::Face_handle` as key and `bool` as value}
    \cgalParamDefault{the faces that are marked by the face base, a model of `DelaunayMeshFaceBase_2`; if none is, or if
                      there are no marks, all finite faces}
  \cgalParamNEnd
  \cgalParamNBegin{target_in_domain_map}
    \cgalParamDescription{whether a face of the target takes part; asked for all finite ones}
    \cgalParamType{a model of `ReadablePropertyMap` with `TargetTriangulation::Face_handle` as key and `bool` as value}
    \cgalParamDefault{as for the source}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the vertices of the target that get the value of the source in their place, whatever the
                          method}
    \cgalParamType{a model of `ReadablePropertyMap` with `TargetTriangulation::Vertex_handle` as key and `bool` as
                   value}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{keep_integral}
    \cgalParamDescription{whether the integral over the target is made that over the source also where the domains
                          differ: by a constant with `PROJECTION`, and with `MONOTONE_PROJECTION` by the same share, at
                          each vertex, of the way to its bound, as far as these ways suffice}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{`INTERPOLATION` does not know integrals and takes no notice of it}
  \cgalParamNEnd
  \cgalParamNBegin{concurrency_tag}
    \cgalParamDescription{whether pairs of triangles are intersected by several threads; the result is the same}
    \cgalParamType{`Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`}
    \cgalParamDefault{`Sequential_tag`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns areas and integrals; with `INTERPOLATION`, which intersects no triangles, not those of what both have in common

\throws std::invalid_argument if no face takes part, if one of the faces given is infinite, if a coordinate or value is
not finite, if a coordinate is beyond the magnitudes that the manual states, or if a triangle is turned over when its
corners are rounded to `double`. No value has been written then.

\sa `transfer_face_values_2()`
\sa `Interpolated_sizing_field_2`
*/
template <class SourceTriangulation, class SourceValueMap, class TargetTriangulation, class TargetValueMap,
          class NamedParameters = parameters::Default_named_parameters>
Transfer_report_2 transfer_vertex_values_2(const SourceTriangulation& source, const SourceValueMap& source_values,
                                           const TargetTriangulation& target, TargetValueMap target_values,
                                           const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  double seconds = 0;
  Phase_timer time(seconds);
  Transfer_reading_2<SourceTriangulation, TargetTriangulation> read(source, target, np);
  read.problem.values = read_values(read.source.vertices(), source_values,
                                    [&](std::size_t k) { return read.source.faces().points[k]; });
  if constexpr (Is_given<NamedParameters, internal_np::vertex_is_constrained_t>::value) {
    const auto is_fixed = parameters::get_parameter(np, internal_np::vertex_is_constrained);
    for (auto v : read.target.vertices())
      read.problem.is_fixed.push_back(get(is_fixed, v) ? 1 : 0);
  }
  const Vertex_transfer method = read_transfer_method(np, Vertex_transfer::PROJECTION);
  Transferred_values_2 result =
    transfer_vertex_values(std::move(read.problem), method, threads_of<Concurrency<NamedParameters>>());
  write_values(result.values, read.target.vertices(), target_values);
  time.stop();
  result.report.seconds = seconds;
  return result.report;
}

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief carries values of the faces of a triangulation, constant in each, over to the faces of another triangulation of
the same domain.

Both triangulations are intersected, triangle by triangle. A face of the target gets the mean over what the source's
faces cover of it, of their constants, or of functions that are linear in each of them. The integral is kept, to 13
digits, where both cover the same domain up to roundings. By default no value is beyond those that the source has near
by, and constants come out to the last bit.

Where domains differ a face that is covered in part has the mean over this part, one that is not covered at all the
value of the nearest face, and what the target does not cover is left out. So constants stay constants and bounds are
kept, rather than the integral; `Transfer_report_2` tells the areas and all integrals, and `keep_integral` changes
that.

Parts, and what determines the result, are as in `transfer_vertex_values_2()`.

\tparam SourceTriangulation a 2D triangulation of \cgal, such as `Constrained_Delaunay_triangulation_2`
\tparam SourceValueMap a model of `ReadablePropertyMap` with `SourceTriangulation::Face_handle` as key and a number as
value
\tparam TargetTriangulation as `SourceTriangulation`; both may be of different types
\tparam TargetValueMap a model of `WritablePropertyMap` with `TargetTriangulation::Face_handle` as key and a
value that `double` converts to
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the triangulation that has values
\param source_values the values; they are read in the faces that take part
\param target the triangulation that gets values; it may be the same one
\param target_values takes the new values; they are written to the faces that take part, after all has been computed
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, and
`source_faces`, `target_faces`, `source_in_domain_map`, `target_in_domain_map` and `concurrency_tag`, all as in
`transfer_vertex_values_2()`

\cgalNamedParamsBegin
  \cgalParamNBegin{transfer_method}
    \cgalParamDescription{how the values are transferred}
    \cgalParamType{`Face_transfer`}
    \cgalParamDefault{`MONOTONE_RECONSTRUCTION`}
  \cgalParamNEnd
  \cgalParamNBegin{keep_integral}
    \cgalParamDescription{whether the integral over the target is made that over the source also where the domains
                          differ: by a constant with `RECONSTRUCTION`, and else by the same share, in each face, of the
                          way to its bound, as far as these ways suffice}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns areas and integrals

\throws std::invalid_argument as `transfer_vertex_values_2()` does

\sa `transfer_vertex_values_2()`
*/
template <class SourceTriangulation, class SourceValueMap, class TargetTriangulation, class TargetValueMap,
          class NamedParameters = parameters::Default_named_parameters>
Transfer_report_2 transfer_face_values_2(const SourceTriangulation& source, const SourceValueMap& source_values,
                                         const TargetTriangulation& target, TargetValueMap target_values,
                                         const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  double seconds = 0;
  Phase_timer time(seconds);
  Transfer_reading_2<SourceTriangulation, TargetTriangulation> read(source, target, np);
  read.problem.values = read_values(read.source.handles(), source_values, [&](std::size_t k) {
    return read.source.faces().point(static_cast<Index>(k), 0);
  });
  const Face_transfer method = read_transfer_method(np, Face_transfer::MONOTONE_RECONSTRUCTION);
  Transferred_values_2 result =
    transfer_face_values(std::move(read.problem), method, threads_of<Concurrency<NamedParameters>>());
  write_values(result.values, read.target.handles(), target_values);
  time.stop();
  result.report.seconds = seconds;
  return result.report;
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_TRANSFER_2_H
