// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NPBS_RELAX_H
#define CGAL_NPBS_RELAX_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/change_or_restore.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/write_mesh.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Mesh_quality_2.h>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief meshes the domain of a constrained Delaunay triangulation with almost equilateral triangles, by the
node placement method by bubble simulation (NPBS).

Vertices are seen as bubbles. Bubbles nearer than the wanted distance d repel each other, bubbles a little
farther attract each other, and bubbles are inserted and deleted until they are packed. A domain without
free vertices is filled. If it has free vertices they are the bubbles to start with: that is how an
existing mesh is refined, coarsened, both at once, or just relaxed.

On return `cdt` is a constrained Delaunay triangulation of the bubbles, and the faces of the domain are
marked if the face base has marks.
- Every vertex that is a corner or an end of a constraint, every pinned vertex, and all that lies outside
  of the domain is still there, with its coordinates and what its vertex base carries, and its handle
  stays valid.
- Every constraint of the input is the union of constraints of the output: exactly with exact
  constructions, else up to the rounding of the vertices that split it. A vertex with two constrained
  edges, straight up to rounding, only splits a constraint: it is a bubble of an edge and may slide and go,
  unless it is pinned, or one of these edges is protected. A `Constrained_triangulation_plus_2` knows which
  vertices these are, and its constraints keep their identifiers.
- A vertex inside the domain that is no end of a constraint is a free bubble, which moves and may go.
  CGAL's triangulations know constraints as edges only: an isolated vertex that is to stay, and to carry a
  bubble as the boundary does, is pinned by `vertex_is_constrained_map`.
- All other vertices of the domain are new, and handles to them and to faces are invalid.

The result is the same to the last bit for the same domain: in every run, with any number of threads, and in
whatever order its vertices and constraints were inserted. Only the order of the vertices and faces in
`cdt` may be another then.

A call takes time about proportional to the number of vertices and to how often each bubble moves, and about 200 bytes
of memory a vertex beyond `cdt`: see \ref BR2_cost. Calls for different triangulations may run in several threads at
once, as long as nothing that one of them changes, or that can be used by one thread only, is in the parameters of
another.

\cgalHeading{Requirements on CDT}

| | works | does not work, and what the compiler says in one sentence |
| :-- | :-- | :-- |
| class | `Constrained_Delaunay_triangulation_2`, `Constrained_triangulation_plus_2` of one | `Delaunay_triangulation_2`: it has no constraints; a `const` one |
| traits | any kernel, exact or not, such as `Epick`, `Epeck`, `Cartesian<double>`; and terrains: `Projection_traits_xy_3`, `Projection_traits_yz_3`, `Projection_traits_xz_3` of such a kernel, see \ref BR2_terrain | other points in space, such as those of `Projection_traits_3`: rotate them so that the direction becomes an axis |
| intersection tag | all: whether constraints that cross are cut or refused when the user inserts them | |
| vertex base, face base | any; what they carry stays with vertices that stay | |

With an exact kernel bubbles move in `double`, and those on edges lie exactly on them.

\tparam CDT a triangulation as above, whose face base may be a model of `DelaunayMeshFaceBase_2`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation that bounds the domain and takes the mesh. Constraints cross, or are refused by
`CDT::Intersection_of_constraints_exception`, when they are inserted, as its intersection tag says
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, or the
`sizing_function` alone: a number or a function of points

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted distance d of neighbouring vertices, in the units of the coordinates}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{If the domain has free vertices: the mean length of the edges around each vertex of
                      `cdt`, linear between vertices, and less, down to half of it, where that grows by
                      more than 0.5 per unit of length. If there is no mesh yet: at each vertex of a
                      constraint the length of the shorter constraint beside it, growing from there by
                      `size_growth`; where the domain is narrower, `limit_by_outline` makes it smaller}
  \cgalParamNEnd
  \cgalParamNBegin{seeds}
    \cgalParamDescription{points in the holes of the domain, or in the domain; those outside of all outlines mark
                          no hole}
    \cgalParamType{a range of points}
    \cgalParamDefault{none: the domain are the faces that are marked as such, or else the faces in an odd
                      number of outlines, that is behind an odd number of constraints; what an open outline was meant
                      to enclose counts as outside of it, and cells behind other cells of a network are holes: for
                      materials, give seeds in holes, or one outside, or mark the faces}
  \cgalParamNEnd
  \cgalParamNBegin{seeds_are_in_domain}
    \cgalParamDescription{whether the seeds lie in the domain}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{the pinned vertices: they stay where they are, isolated ones inside the domain and
                          those that only split a constraint as well}
    \cgalParamType{a model of `ReadablePropertyMap` with `CDT::Vertex_handle` as key and `bool` as value}
    \cgalParamDefault{no vertex is pinned}
  \cgalParamNEnd
  \cgalParamNBegin{protect_constraints}
    \cgalParamDescription{which constraints stay as they are: no vertex comes on them, and both their ends stay. Beside
                          those that are longer than d sizes are larger, and shrink from there by 0.5, or by
                          `size_growth` if that is more, per unit of length: d holds from about twice their length
                          on; see \ref BR2_protect}
    \cgalParamType{`bool`, for all; or a model of `ReadablePropertyMap` with
                   `std::pair<CDT::Vertex_handle, CDT::Vertex_handle>` as key, the ends of an edge as
                   `make_sorted_pair()` sorts them, and `bool` as value}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_marker_map}
    \cgalParamDescription{markers of constraints, see \ref BR2_tags. `get()` is called for edges on constraints that
                          bound the domain or lie in it; those that are straight are one line only as far as the markers
                          are equal by `==`. When the mesh is there `put()` is called for its edges on constraints, with
                          the marker of what they are a part of}
    \cgalParamType{a model of `ReadWritePropertyMap` with `std::pair<CDT::Vertex_handle, CDT::Vertex_handle>` as key,
                   the ends of an edge as `make_sorted_pair()` sorts them, such as `Constraint_marker_map_2`}
    \cgalParamDefault{no constraint has a marker}
  \cgalParamNEnd
  \cgalParamNBegin{face_region_map}
    \cgalParamDescription{regions of the faces of the domain, which constraints part. When the mesh is there `put()` is
                          called for its faces in the domain, with the value of their region}
    \cgalParamType{a model of `ReadWritePropertyMap` with `CDT::Face_handle` as key, such as `Face_region_map_2`}
    \cgalParamDefault{faces have no regions}
  \cgalParamNEnd
  \cgalParamNBegin{initial_placement}
    \cgalParamDescription{where the bubbles of the faces start. Vertices of an existing mesh inside of the circles
                          around sharp corners, see `limit_by_outline`, are not kept, not even by `KEEP`: the
                          radius of a circle is at most 0.36 of the size at its corner}
    \cgalParamType{`Bubble_placement`}
    \cgalParamDefault{`FRONTAL`; the paper: `RHOMBIC`. If the domain has free vertices: `KEEP` where the
                      mesh is as fine as d asks up to a factor of 1.1, `FRONTAL` in the rest}
  \cgalParamNEnd
  \cgalParamNBegin{population_control}
    \cgalParamDescription{how the number of bubbles is adjusted between two rounds}
    \cgalParamType{`Bubble_population`}
    \cgalParamDefault{`DELAUNAY`; the paper: `OVERLAP_RATIO`}
  \cgalParamNEnd
  \cgalParamNBegin{elevation_function}
    \cgalParamDescription{the third coordinate of new vertices, where `CDT` is a terrain}
    \cgalParamType{a function object, called as a constant with a `Point_2` of the kernel, the place in the plane of the
                   projection, that returns a number which converts to the kernel's `FT`}
    \cgalParamDefault{that of the surface that was there: linear along constraints, and in the faces, as
                      `Interpolated_elevation_2` is}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rounds}
    \cgalParamDescription{rounds of simulation at most; between two the population is adjusted}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{10; the paper: 1 to 10}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{time steps in one round at most}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{30; the paper: 250}
  \cgalParamNEnd
  \cgalParamNBegin{displacement_tolerance}
    \cgalParamDescription{a round ends when no bubble moves more than this times d in a step. With the default
                          integrator a bubble sleeps while it and its neighbours move no more, and 3.3 times as much is
                          rest enough while bubbles are still inserted; twice as much in the end, if the outline asks
                          for a quarter more bubbles than `sizing_function` and there is a `defect_treatment`}
    \cgalParamType{`double`, not negative}
    \cgalParamDefault{0.0085; 0.001 with `RUNGE_KUTTA_4`, where no bubble sleeps}
  \cgalParamNEnd
  \cgalParamNBegin{integrator}
    \cgalParamDescription{how the equation of motion (eq. 3 of the paper) is integrated}
    \cgalParamType{`Bubble_integrator`}
    \cgalParamDefault{`SEMI_IMPLICIT_EULER`; the paper: `RUNGE_KUTTA_4`}
  \cgalParamNEnd
  \cgalParamNBegin{force_coefficient}
    \cgalParamDescription{k<sub>0</sub> of the force (eq. 2)}
    \cgalParamType{`double`, positive, 10<sup>-12</sup> to 10<sup>12</sup> for the default integrator}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{mass}
    \cgalParamDescription{m of eq. 3}
    \cgalParamType{`double`, positive, 10<sup>-12</sup> to 10<sup>12</sup> for the default integrator}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{damping}
    \cgalParamDescription{c of eq. 3}
    \cgalParamType{`double`, 0, or as `mass`}
    \cgalParamDefault{0.6, with lengths in units of d; 3.8429 with `RUNGE_KUTTA_4`, in units of length}
  \cgalParamNEnd
  \cgalParamNBegin{time_step}
    \cgalParamDescription{the length of a step in time. With `Bubble_population::DELAUNAY` it is halved before each
                          round in the second half of `number_of_rounds`, and with any, but not with `RUNGE_KUTTA_4`,
                          after the 10th, 15th, ... step of a round if a third of the bubbles move by more than d/10:
                          then all go on from standstill; 20 times at most}
    \cgalParamType{`double`, positive, 10<sup>-12</sup> to 10<sup>12</sup> for the default integrator}
    \cgalParamDefault{0.6; 0.02 with `RUNGE_KUTTA_4`}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{the radius of the neighbour sets in units of the mean of both sizes}
    \cgalParamType{`double`, greater than 1.5, at most 100}
    \cgalParamDefault{1.7}
  \cgalParamNEnd
  \cgalParamNBegin{renewal_interval}
    \cgalParamDescription{steps between two renewals of the neighbour sets, k of the paper; sets that are larger
                          than within a `neighbor_radius` of about 3, or of a crowd, are made anew then, not from
                          neighbours of neighbours}
    \cgalParamType{an integer, not negative}
    \cgalParamDefault{0: they are renewed before a bubble has moved so far that a pair could be missed}
  \cgalParamNEnd
  \cgalParamNBegin{defect_treatment}
    \cgalParamDescription{whether vertices of triangles with q < 0.95, with q < 0.98 if the outline asks for a
                          quarter more bubbles than `sizing_function`, are moved after the simulation for the
                          quality of the triangles around them, and single vertices inserted or deleted where
                          a triangle with q < 0.9 stays; the smallest q does not get smaller by it. Refinement for
                          `minimum_angle`, which comes after it, does not look at q}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`; the paper: `false`}
  \cgalParamNEnd
  \cgalParamNBegin{limit_by_outline}
    \cgalParamDescription{whether bubbles are smaller than `sizing_function` asks where an edge of the domain is
                          shorter, the domain narrower, or a pinned vertex nearer to others, than 0.9/1.1 = 0.82
                          times that, and beside very sharp corners; and corners in which two edges meet in less than
                          45 degrees are surrounded by a circle of nodes, so that only the triangles in the circle have
                          the angles of the corner: see \ref BR2_outlines. Neither is done where a mesh is relaxed
                          without a `sizing_function`. If not, what time and memory that takes grows with the square of
                          the number of corners and pinned vertices that are nearer to each other than d}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`; the paper: `false`}
  \cgalParamNEnd
  \cgalParamNBegin{size_growth}
    \cgalParamDescription{by how much sizes grow per unit of length away from where the outline asks for smaller ones,
                          and by default away from short edges. Steeper growth makes fewer vertices and worse
                          triangles: see \ref BR2_outlines}
    \cgalParamType{a number, positive and at most 1}
    \cgalParamDefault{0.2}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_angle}
    \cgalParamDescription{where `defect_treatment` leaves a triangle with a smaller angle, in degrees, which is not
                          that between two edges of the domain, vertices are inserted as by Ruppert's refinement,
                          as also where two angles of hardly more make q less than 0.55.
                          That ends by proof up to 20.7 degrees if edges meet in 60 degrees or more; if
                          triangles ask for more than n/50 + 100 vertices, for the n that there are, nothing is
                          inserted. Where smaller angles stay is told in \ref BR2_outlines}
    \cgalParamType{a number, 0 to 33; 0: none are inserted}
    \cgalParamDefault{30}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_number_of_bubbles}
    \cgalParamDescription{the most bubbles that `sizing_function` may ask for}
    \cgalParamType{an integer, positive, at most 2<sup>31</sup> - 1}
    \cgalParamDefault{100 000 000}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is called by this thread with the progress, between 0 and 1 and about proportional to time,
                          ten times a second or more often, and at each step. When it returns `false` all stops:
                          before there are bubbles `cdt` stays as it is, later it becomes the mesh of the bubbles as
                          they are, without what is left of simulation and treatment; while `cdt` is written it is not
                          called again, and the writing goes on. The last call, with 1, comes when all is done; after a stop
                          there is none}
    \cgalParamType{an object that converts to `std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{restore_when_stopped}
    \cgalParamDescription{whether `cdt` stays as it is whenever the callback returns `false`. Then that takes effect at
                          once, else the bubbles are still triangulated and the mesh is written. In the phase `WRITING`,
                          of which a `visitor` is told, `cdt` gets the content back that it had, with its tags in
                          `edge_marker_map` and `face_region_map`, as after an exception of `put()`: handles and
                          identifiers of constraints are invalid}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{sees phases and rounds begin and end, and the bubbles after each step}
    \cgalParamType{a model of `BubbleRelaxationVisitor_2`, of which a copy is called, or a `std::reference_wrapper` of
                   one}
    \cgalParamDefault{`Default_relaxation_visitor_2`}
  \cgalParamNEnd
  \cgalParamNBegin{concurrency_tag}
    \cgalParamDescription{whether threads are used; the sizing function is then called by several at once}
    \cgalParamType{`Sequential_tag` or `Parallel_tag` (which needs TBB)}
    \cgalParamDefault{`Sequential_tag`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns what was done, and the statistics of the mesh

\throws std::invalid_argument if a parameter is out of its range, if a coordinate, a size or the length of an edge
is not finite or beyond its bounds (see \ref BR2_magnitudes), if an elevation is not finite, if a size is not
positive, if a seed lies on a constraint between two regions, if two values of `face_region_map` meet where no
constraint is, if there is no domain with constraints all around it, or if constraints of an exact kernel cross, or
its vertices coincide, when they are rounded to `double`
\throws std::length_error if more bubbles are expected than `maximum_number_of_bubbles`
\throws std::runtime_error if edges of the domain lie nearer to each other than the rounding of the bubbles
on them, or if a constraint cannot be split while the mesh is written, because the triangulation beside it is
too flat for the numbers of the kernel

Exceptions of the sizing function, of the elevation function, of the callback and of property maps pass through. All
calls of them and of the ranges, but for `put()` and the callback in the phase `WRITING`, come before the first change of
`cdt`: after their exceptions, and after those listed above but for errors while the mesh is written, `cdt` is untouched,
with all its handles and the identifiers of its constraints. After `std::bad_alloc`, an exception of CGAL, of `put()` or
of the callback, or a `std::runtime_error`, while the mesh is written, `cdt` has the content that it had, and the maps
have its tags as far as `put()` takes them, but all handles and identifiers of constraints are invalid.

\sa `npbs_place_nodes()`
\sa `refine_Delaunay_mesh_2()`
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto npbs_relax(CDT& cdt, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, Bubble_relaxation_report_2<double>>(np, [&cdt](const auto& pack) {
    using FT = typename Quality_number<typename CDT::Geom_traits>::type;
    Report report;
    Phase_timer reading_time(report.seconds.reading);
    const auto progress = read_progress(pack);
    const Progress_scope scope(*progress);
    do_unless_stopped(report, [&] {
      const Input_2<CDT> input(cdt, pack, progress);
      const Tags_2 tags(pack, cdt, input.reading);
      const Problem_2 problem = input.problem();
      reading_time.stop();
      const Bubble_mesh_2 mesh = make_mesh(problem, report);
      const Elevations<CDT> elevations = find_elevations(cdt, input.reading, mesh.bubbles, input.elevation);
      progress->start_phase(Bubble_phase::WRITING);
      // of the user's only put() and the callback are called from here on
      change_or_restore(
        cdt, pack,
        [&](auto& saved) {
          const auto save = [&saved](const auto& key, const auto& tag) { saved.save(key, tag); };
          tags.visit_old(cdt, input.reading, save, save);
        },
        [&] {
          write_mesh(cdt, input.reading, mesh, elevations, tags, report);
          progress->finish();
        });
    });
    return Bubble_relaxation_report_2<FT>(report);
  });
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_NPBS_RELAX_H
