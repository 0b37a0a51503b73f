// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NPBS_ADAPT_H
#define CGAL_NPBS_ADAPT_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_check_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/find_misfits.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/read_adaptation.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/remesh_part.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Default_adaptation_visitor_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief meshes some faces of a mesh anew, and does not touch the others.

The part is meshed as `npbs_relax()` does the whole: vertices inside of it are the bubbles to start with. What it
costs depends on the part alone, in time and in memory, however large the rest is; only whether the faces belong to the
triangulation is asked once for each connected piece of the part, in a time like the square root of all faces.

\cgalHeading{What Stays}

- All faces of the domain that do not belong to the part, and all vertices of theirs, keep their handles, coordinates,
  marks, and what their bases carry. So do vertices outside of the domain.
- The <em>rim</em> of the part, the edges that have a face of the part on one side and another face of the domain on
the other one, stays as it is: its vertices are not moved, its edges are not split, constrained ones included. Other
constraints of the part, and those at the border of the domain, are treated as by `npbs_relax()`: vertices that only
split them may go, and others may come. A constraint that the rim cuts has a vertex there, which stays: in the part it
is a constraint that ends there, and beyond the rim nothing of it changes.
- A vertex is never moved: it stays, or it is removed and others are new. One that comes out at its old coordinates
stays, with its handle and what it carries.
- Out of the domain, faces are replaced where vertices of a constraint beside them change; what their base carries may
go to other faces there. Where they are too flat for that, up to roundings, the constraint stays as it is, like the rim.
- `cdt` stays a constrained Delaunay triangulation. Where a node would come into the circle of the face beyond an edge
of the rim, it is left out. With triangles as good as usual that does not happen.

Where edges of the rim are longer or shorter than d asks by more than a quarter, sizes in the part begin with theirs
and change by no more than `size_growth` per unit of length from there: a part that is too small for that does not get
to d. `npbs_misfit_faces()` finds parts with rims that fit.

The result is the same to the last bit for the same triangulation and the same part: in every run, with any number of
threads, and in whatever order the faces are given.

\tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one, of a
`Triangulation_hierarchy_2`, too, whose upper levels get no new vertices here. Its face base
should be a model of `DelaunayMeshFaceBase_2`: without marks all finite faces count as the domain, and so constraints
between the part and others stay as they are
\tparam FaceRange a range of `CDT::Face_handle`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation
\param faces the part: faces of the domain. They need not hang together, and may surround others, and their rim may cut
constraints. One that comes twice counts once
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": all of `npbs_relax()` but `seeds` and
`seeds_are_in_domain`, and

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted distance d of neighbouring vertices, in the units of the coordinates}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{the mean length of the part's edges around each vertex, linear between vertices, and
                      less, down to half of it, where that grows by more than 0.5 per unit of length}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told which faces and vertices go and come}
    \cgalParamType{a model of `BubbleAdaptationVisitor_2`, of which a copy is called, or a `std::reference_wrapper` of
    one}
    \cgalParamDefault{`Default_adaptation_visitor_2<CDT>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns what was done, and the statistics of the part's mesh

\throws std::invalid_argument as `npbs_relax()` does, and if `faces` is empty, if one of them is infinite, an empty
handle, not marked as one of the domain, or of another triangulation, or if a face of the domain beside the part has
no constraint where the domain ends
\throws std::length_error if more bubbles are expected in the part than `maximum_number_of_bubbles`
\throws std::runtime_error if edges lie nearer to each other than the rounding of the bubbles on them, or if the
part beside a constraint is too flat to change it there

The callback is called while the part is written, too, until the new faces are ready; the last call, with 1, comes just
before they take the place of the old ones. Where it returns `false` with `restore_when_stopped`, `cdt` is as it was
and all handles are valid; without, while the part is written, that changes nothing, since the mesh is complete; but
where a constraint turns out to have to stay, bubbles are left then as they are placed for that.

Exceptions of the sizing function, of the elevation function, of the callback and of the visitor pass through. After
any exception, `std::bad_alloc` included, `cdt` is as it was, and all handles are valid. There are two exceptions
from that: `after_change()` of the visitor is called when all is done, as is `put()` of the maps of tags before it;
and where memory ends while a `Constrained_triangulation_plus_2` enters new vertices into its constraints, or a
`Triangulation_hierarchy_2` takes old ones out of its levels, these are not restored.

\sa `npbs_adapt()`
\sa `npbs_relax()`
*/
template <class CDT, class FaceRange, class NamedParameters = parameters::Default_named_parameters>
auto npbs_remesh_faces(CDT& cdt, const FaceRange& faces, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, Bubble_relaxation_report_2<double>>(np, [&cdt, &faces](const auto& pack) {
    using FT = typename Quality_number<typename CDT::Geom_traits>::type;

    const Relaxation_options options = read_local_options(pack);
    const Progress_scope scope(*options.progress);
    const Is_in_domain<CDT> is_in_domain{cdt};
    const std::optional<Sizes_2> sizes = given_sizes<Place_2<CDT>>(pack);
    const Elevation_function<CDT> elevation = given_elevation<CDT>(pack);
    auto visitor = visitor_of<CDT>(pack);
    Report report;
    do_unless_stopped(report, [&] {
      options.progress->start_phase(Bubble_phase::READING);
      const std::vector<typename CDT::Face_handle> part =
        Part_check_2<CDT>(cdt, "faces")(faces, is_in_domain, /* may_be_none = */ false);
      using Task = Part_task_2<CDT, Is_in_domain<CDT>, std::decay_t<decltype(pack)>>;
      Task{cdt, is_in_domain, pack, options, sizes, elevation}.remesh(part, unwrapped(visitor), report);
    });
    return Bubble_relaxation_report_2<FT>(report);
  });
}

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief finds the faces of a mesh that do not fit sizes, and enough around them to mesh them anew without a seam.

The size at a face is `sizing_function`, made smaller where the outline asks for it as by `npbs_relax()`: a fine
outline is no misfit. A face does not fit if the mean length of its edges is more than `longest_edge` times the size,
or less than `shortest_edge` times, or if it has an angle of less than `misfit_angle` that no two constraints enclose,
or if q is less than `misfit_quality` and no two constraints enclose an angle.
Triangles around sharp corners are what the corner makes of them, and fit.

Where sizes jump, or change by more than half of the distance, no mesh follows them. There a face fits if it does so for
one of the sizes that are wanted at its corners and at the neighbours of these.

In a mesh that was made by `npbs_relax()` or `npbs_adapt()` with the same sizes nothing is a misfit, unless they jump
by more than a factor of 2.5; now and then a defect is found, or a narrow between constraints whose rows of triangles
do not come out well. From misfits the part grows over all faces that hang together with them and are off by the cube
root of these factors, so that nothing is left where a change fades out, and then by `number_of_rings`.

It takes a sweep over the faces, with a call of the sizing function for each, and memory for the outline and for what is
found. A caller who knows where sizes have changed gives the faces there, `faces_to_check`. Then the sizing function is
called near these and near misfits only, the outline is read there only, and neither time nor memory grow with the mesh,
or with its outline. If faces have no marks, all of them are copied to find the domain as
`npbs_relax()` does.

\tparam CDT as in `npbs_remesh_faces()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation
\param np a sequence of \ref bgl_namedparameters "Named Parameters": `sizing_function`, which must be given;
`vertex_is_constrained_map`, `protect_constraints`, `limit_by_outline` and `size_growth` of `npbs_relax()`, and its
`maximum_number_of_bubbles`, which counts only what the outline asks for: how many a part needs `npbs_adapt()` counts;
`seeds` and `seeds_are_in_domain` if faces have no marks; `callback`, which is told the progress of `npbs_adapt()`, of
which this is the beginning; and

\cgalNamedParamsBegin
  \cgalParamNBegin{longest_edge}
    \cgalParamDescription{the longest mean edge of a face that fits, in units of the size}
    \cgalParamType{a number, greater than 1}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{shortest_edge}
    \cgalParamDescription{the shortest mean edge of a face that fits, in units of the size; 0.84 times that if the face
    has a vertex of a constraint: where the domain is narrow one row of triangles may be too coarse, and two too fine;
    and where the outline asks for smaller triangles than `sizing_function`: rows end where they grow}
    \cgalParamType{a number, not negative and less than 1}
    \cgalParamDefault{0.6}
  \cgalParamNEnd
  \cgalParamNBegin{misfit_angle}
    \cgalParamDescription{the smallest angle of a face that fits, in degrees}
    \cgalParamType{a number, 0 to 33}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{misfit_quality}
    \cgalParamDescription{the smallest radius ratio q of a face that fits. It finds what is not good enough where the
    caller has inserted and removed vertices and constraints, and does not promise it of what comes of that}
    \cgalParamType{a number, 0 to 0.9}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{faces_to_check}
    \cgalParamDescription{where misfits are looked for: faces of the domain, at best all in which the size is, or was,
    another one. The part grows from those that are found, to others too. If there are none, all fits. The outline is
    read where it counts: near these, as far as sizes grow to d, but at least 5 d. Where the part grows beyond that, it
    is read once more, near all that was found, and at last as a whole}
    \cgalParamType{a range of `CDT::Face_handle`, which is copied, or a `std::reference_wrapper` of one; a face that
    comes twice counts once}
    \cgalParamDefault{all faces of the domain}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rings}
    \cgalParamDescription{how many times all faces around the vertices that are reached are added. With fewer rings
    meshes get worse by many changes, since too little around each can move}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{4}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the faces, each once, in no particular order; none if all fit, or if the callback has returned `false`

\throws std::invalid_argument if a parameter is out of its range, if `faces_to_check` has a face that is not in the
domain, an infinite one, an empty handle, or a face of another triangulation, if faces have marks and none is marked as
one of the domain, or as `npbs_relax()` does for sizes and outlines

\sa `npbs_adapt()`
*/
template <class CDT, class NamedParameters>
std::vector<typename CDT::Face_handle> npbs_misfit_faces(const CDT& cdt, const NamedParameters& np)
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, std::vector<typename CDT::Face_handle>>(np, [&cdt](const auto& pack) {
    const Relaxation_options options = read_local_options(pack);
    const Progress_scope scope(*options.progress);
    std::vector<typename CDT::Face_handle> result;
    try {
      options.progress->start_phase(Bubble_phase::READING);
      result = find_misfits(cdt, domain_of(cdt, pack), options, pack).first;
    } catch (const Stopped_by_callback&) {
    }
    return result;
  });
}

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief meshes the part of a mesh anew that does not fit sizes, and leaves the rest as it is: `npbs_misfit_faces()` and
`npbs_remesh_faces()` in one go.

If all fits nothing changes, and the report tells of no vertices and triangles. Where a bad triangle (q < 0.92) at the
rim of the part is left, which could not be treated since the rim stays, more faces around it are added to the part,
and it is meshed once more, up to three times. So meshes do not get worse by many changes: see \ref BR2_local.

\tparam CDT as in `npbs_remesh_faces()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation
\param np a sequence of \ref bgl_namedparameters "Named Parameters": those of `npbs_misfit_faces()`, `sizing_function`
among them, and of `npbs_remesh_faces()`

\returns what was done, and the statistics of the part's mesh

\throws std::invalid_argument, std::length_error, std::runtime_error as `npbs_misfit_faces()` and
`npbs_remesh_faces()` do; what is promised there of `cdt` after exceptions holds here as well

\sa `npbs_relax()`
*/
template <class CDT, class NamedParameters>
auto npbs_adapt(CDT& cdt, const NamedParameters& np)
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, Bubble_relaxation_report_2<double>>(np, [&cdt](const auto& pack) {
    using FT = typename Quality_number<typename CDT::Geom_traits>::type;

    const Relaxation_options options = read_local_options(pack);
    const Progress_scope scope(*options.progress);
    const Elevation_function<CDT> elevation = given_elevation<CDT>(pack);
    auto visitor = visitor_of<CDT>(pack);
    Report report;
    do_unless_stopped(report, [&] {
      options.progress->start_phase(Bubble_phase::READING);
      Phase_timer reading_time(report.seconds.reading);
      const auto is_in_domain = domain_of(cdt, pack);
      auto [misfits, sizes] = find_misfits(cdt, is_in_domain, options, pack);
      reading_time.stop();
      using Task = Part_task_2<CDT, std::decay_t<decltype(is_in_domain)>, std::decay_t<decltype(pack)>>;
      if (misfits.empty()) {
        report.converged = true;
        report.stop_reason = Bubble_stop_reason::CONVERGED;
        options.progress->finish();
      } else
        Task{cdt, is_in_domain, pack, options, sizes, elevation}.adapt(std::move(misfits), unwrapped(visitor), report);
    });
    return Bubble_relaxation_report_2<FT>(report);
  });
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_NPBS_ADAPT_H
