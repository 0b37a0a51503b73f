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

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/simplify_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/change_or_restore.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Outline_simplification_report_2.h>

#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief replaces the constraints of a constrained Delaunay triangulation by an outline that is fit for meshing with
triangles of a wanted size: near to the old one, but in pieces about as long as the triangles' edges.

`npbs_relax()` and other meshers keep every corner of an outline, so an outline that is known in more detail than the
mesh shall have asks for many small triangles. This function, called before, gives them an outline that they can follow.
- Every point of the old outline is within the tolerance of the new one, and every point of the new one within that of
  the old one. This is checked, exactly for the coordinates in `double`, to which those of an exact kernel are rounded
  first, and the two-sided Hausdorff distance is reported.
- Nothing crosses, and regions stay inside of each other as they are, with as many islands and domains as there were:
  this is decided by exact predicates. Seeds and pinned vertices stay in their regions.
- Vertices stay that are pinned, in which other than two constraints meet, which a constraint outside of the domain has,
  or, in a `Constrained_triangulation_plus_2`, at which other constraints go on than before. Their handles stay valid;
  of the last kind, and of junctions, some go where a rule takes their constraints away.
  So do corners: vertices with two constraints, which are straight, up to half of the tolerance, for a length of d/2,
  and form an angle under `corner_angle`.
- Pieces are between 0.6 and 1.5 d long where the tolerance and the topology allow it. Vertices leave the old outline,
  within the tolerance, where this makes pieces longer or narrow parts of the domain wider: small islands grow, channels
  widen. What is straight over 10 d or more, but for roundings of 0.001 d, stays where it is between its ends: the
  sides of a box, where data of a larger model are given.
- Two rules, off by default, change the domain, and the report tells where: `minimum_island_area` and `minimum_gap`.
  They come first, in this order; the tolerance and the distance refer to what they leave. So afterwards an island, or a
  gap, may be smaller than the rule says by what the tolerance allows.

A constraint of a `Constrained_triangulation_plus_2` keeps its identifier unless a rule took away a part of it, or added
one. For all triangulations `Outline_simplification_report_2::pieces` tells which old segment each piece stands for, and
a piece has its marker, if there is an `edge_marker_map`.

The result is the same to the last bit in every run, in whatever order vertices and constraints were inserted, wherever
closed ones start, and when all lengths are scaled by a power of two.

Vertices without constraints that are not pinned, such as those of a mesh, are removed. The faces of the domain are
marked if the face base has marks, so `npbs_relax()` needs no seeds afterwards; with a rule, seeds of regions that are
gone would mislead it. Without marks, a rule can leave a domain that is not that of the faces in an odd number of
outlines, where other constraints are outside of it: then a face base with marks is needed.

\tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one, with points in the
plane: no terrain. Its face base may be a model of `DelaunayMeshFaceBase_2`. With an exact kernel the new
vertices have coordinates in `double`.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation whose constraints are replaced
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, or a size
alone, a number or a function of points, which is `sizing_function`

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted length d of pieces, in the units of the coordinates; it is asked at vertices and
                          pieces of the outline, and, for the number of wanted vertices in the report, everywhere in
                          the domain, but not on constraints outside of it, which stay}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{ten times `outline_tolerance`; one of both must be given}
  \cgalParamNEnd
  \cgalParamNBegin{outline_tolerance}
    \cgalParamDescription{how far the new outline may be from the old one, and the old one from the new one: a length}
    \cgalParamType{a number, positive}
    \cgalParamDefault{none. If both tolerances are given the smaller one counts in each place}
  \cgalParamNEnd
  \cgalParamNBegin{relative_outline_tolerance}
    \cgalParamDescription{the same as a share of d. Pieces are about as long as d: with more than that what comes out
                          would have little to do with the outline. A length, `outline_tolerance`, has no such bound}
    \cgalParamType{a number, positive and at most 1}
    \cgalParamDefault{0.1 if `outline_tolerance` is not given}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_island_area}
    \cgalParamDescription{islands with a smaller area become a part of the domain. An island is a region with the domain
                          all around it, one ring of constraints, none of whose vertices is pinned, and no other
                          constraint or pinned vertex}
    \cgalParamType{a number, not negative}
    \cgalParamDefault{0: none does}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_gap}
    \cgalParamDescription{where the domain is narrower, in channels and between islands, it is filled; open corners are
                          not filled, but sharp ones are, as far as they are narrower. No vertex has more than two edges
                          of the boundary then, and no part of the domain that is cut off is smaller than a disc with
                          twice this diameter. Triangles are left alone that touch a vertex which is pinned or of a
                          constraint outside of the domain, or a constraint within it: such vertices may have more
                          edges, and so may those at which two parts of the domain meet that hold some, and such
                          parts stay, however small. Pinned vertices and constraints in the midst of the domain make
                          it no narrower. Choose three times the tolerance or more, or ends of what is filled, which
                          are about as wide as this, may become sharp corners}
    \cgalParamType{a number, not negative}
    \cgalParamDefault{0: nothing is filled}
  \cgalParamNEnd
  \cgalParamNBegin{corner_angle}
    \cgalParamDescription{sharper corners stay; in degrees}
    \cgalParamType{a number between 0 and 180}
    \cgalParamDefault{100}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_bubbles}
    \cgalParamDescription{the most vertices that d alone may ask of a mesh, as for `npbs_relax()`: pieces of an outline
                          are found one by one, so a size that is far too small would take long to be refused by that}
    \cgalParamType{an integer, positive, at most 2<sup>31</sup> - 1}
    \cgalParamDefault{no limit}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the pinned vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with `CDT::Vertex_handle` as key and `bool` as value}
    \cgalParamDefault{no vertex is pinned}
  \cgalParamNEnd
  \cgalParamNBegin{edge_marker_map}
    \cgalParamDescription{the markers of constraints. Vertices at which they change stay, unless a rule takes their
                          constraints away. Each piece gets the marker of the segment that it stands for, and what a
                          rule made that of the nearest one along the boundary. The map is asked, and old edges are
                          taken out of it, before `cdt` is changed}
    \cgalParamType{a model of `ReadWritePropertyMap` as for `npbs_relax()`, such as `Constraint_marker_map_2`}
    \cgalParamDefault{constraints have no markers}
  \cgalParamNEnd
  \cgalParamNBegin{seeds}
    \cgalParamDescription{points in the holes of the domain, or in the domain, as for `npbs_relax()`. No piece passes
                          one, so each that is nearer to the outline than the tolerance costs some pieces: put them
                          into the midst of regions}
    \cgalParamType{a range of points}
    \cgalParamDefault{none: the domain are the faces that are marked as such, or else the faces in an odd number of
                      outlines}
  \cgalParamNEnd
  \cgalParamNBegin{seeds_are_in_domain}
    \cgalParamDescription{whether the seeds lie in the domain}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns what was done, and how near the new outline is to the old one

\throws std::invalid_argument if a parameter is out of its range, if a coordinate or a size is not finite, if the
tolerance is no more than roundings of the coordinates, if two vertices are in one place when rounded to `double`, if
there is no domain with constraints all around it (the message names an edge where it is open), or if `minimum_gap`
fills all of it, or is no more than roundings of the coordinates
\throws std::length_error if d asks for some million pieces, or for more vertices than `maximum_number_of_bubbles`, or
if `minimum_gap` is some millions of times smaller than the narrow parts of the domain are long
\throws std::runtime_error if the new outline cannot be written with the numbers of the kernel: its vertices coincide,
its segments cross, or the domain comes to lie on another side of one, when rounded to them

Exceptions of the sizing function pass through. All calls of it, of the property map and of the ranges come before the
first change of `cdt`: after them, and after `std::invalid_argument`, it is untouched. After other exceptions `cdt` has
the content that it had, and the map its markers as far as `put()` takes them, but all handles and identifiers of
constraints are invalid.

\sa `npbs_relax()`
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto simplify_outline_2(CDT& cdt, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, Outline_simplification_report_2>(np, [&cdt](const auto& pack) {
    Outline_simplification_report_2 report;
    if constexpr (check_flat<CDT>()) {
      Phase_timer time(report.seconds);
      Outline_reading_2<CDT> reading(cdt, pack);
      const Outline_markers_2 markers(pack, reading);
      Simplified_outline_2 outline = simplify_outline(reading.problem);
      change_or_restore(
        cdt, pack,
        [&](auto& saved) {
          markers.visit_old(reading, [&saved](const auto& edge, const auto& marker) { saved.save(edge, marker); });
        },
        [&] {
          markers.forget_old(reading);
          Outline_writing_2<CDT> writing(cdt, reading, outline);
          writing();
          markers.write(outline, writing);
        });
      time.stop();
      outline.report.seconds = report.seconds;
      report = std::move(outline.report);
    }
    return report;
  });
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_SIMPLIFY_OUTLINE_2_H
