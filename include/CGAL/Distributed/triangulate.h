// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DISTRIBUTED_TRIANGULATE_H
#define CGAL_DISTRIBUTED_TRIANGULATE_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Distributed/Mesh_2.h>

#include <mpi.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. What `Distributed::triangulate()` does with parameters that can be meant.
template <class PointSet, class Cdt, class NamedParameters>
auto triangulate_by_all(const PointSet& points, const Cdt& domain, MPI_Comm comm, const NamedParameters& np)
{
  Communicator ranks(comm);

  std::unique_ptr<Domain_reading_2<Cdt>> reading;
  ranks.agree_after([&] {
    const Domain_marks_2<Cdt> is_inside(domain, np);
    reading = std::make_unique<Domain_reading_2<Cdt>>(domain, is_inside, is_pinned<Cdt>(np),
                                                      Said_of_constraints<NamedParameters>{np});
    check_regions<Cdt>(np, is_inside);
  });
  check_same_domain(ranks, reading->domain);

  constexpr bool has_sizes = Is_given<NamedParameters, internal_np::sizing_function_t>::value;
  Sizes_2 sizes([](double, double) { return std::numeric_limits<double>::quiet_NaN(); });
  if constexpr (has_sizes)
    sizes = *given_sizes<typename Cdt::Geom_traits::Point_2>(np);
  Bubbles_2 given;
  ranks.agree_after([&] { given = read_bubbles(points, reading->domain, sizes); });
  const bool have_numbers = points.template has_property_map<std::int64_t>("global_id");
  Mesh_quality_2<double> quality;
  const Distributed_mesh_2 mesh =
    triangulate_part(reading->domain, std::move(given), have_numbers, has_sizes ? &sizes : nullptr, ranks, quality);
  using Tags = Tags_2<Cdt, NamedParameters>;
  Distributed::Mesh_2<typename Cdt::Geom_traits, typename Tags::Marker, typename Tags::Region> result(comm);
  ranks.agree_after([&] {
    result = decltype(result)(mesh, reading->domain, Tags(np, domain, *reading), quality, comm);
  });
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

namespace CGAL::Distributed {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief makes the constrained Delaunay triangulation of points that are spread over the ranks of an MPI
communicator, and gives each rank its part of it. All ranks must call it.

The constraints are those of the domain, which all ranks have, cut where points lie on them. Together the ranks
have the one triangulation that a single rank would make of all points: the same triangles for any number of
ranks, in whatever way the points come spread over them. A rank gets its own points and those that its triangles need.

Each rank owns as many points as any other, from a piece of a Hilbert curve through the domain. A triangle is
known to be one of the whole when its circumscribed circle lies in what the rank has seen; until then the rank
asks others for points.

\tparam PointSet a `CGAL::Point_set_3<K::Point_2, K::Vector_2>`. A point lies on a constraint if it is there up
to the rounding of its coordinates. Properties of the points that are used if they are there:
- `global_id` (`std::int64_t`): different for all points of all ranks, and not negative. Without it points are
  numbered along the curve, from 0.
- `size` (`double`): the wanted distance to neighbours. Without it that of `sizing_function`, or else a guess
  from points nearby. It decides how many points are exchanged at first, and no triangle.
- `dimension` (`int`), `edge` (`int`) and `position` (`double`), as the bubbles of a relaxation have them:
  where on the outline a point lies.
\tparam CDT a `Constrained_Delaunay_triangulation_2`, or a `Constrained_triangulation_plus_2` of one
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points of this rank, any part of all
\param domain the triangulation that bounds the domain. Its constraints must be the same on all ranks. The ends
of constraints belong to the mesh, whether they are among the points or not; those that are not get the ids after
the largest, or are numbered with the others. Its other vertices do not matter.
\param comm the communicator. A duplicate of it is used, so no message of others is in the way
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below, or the
`sizing_function` alone: a number or a function of points

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted distance d of neighbouring vertices, for points without the property `size`
                          and for the statistics of the lengths of edges}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_marker_map}
    \cgalParamDescription{markers of constraints, as for `CGAL::npbs_relax()`, which the mesh has, see `Mesh_2::marker()`;
                          those of the domain are the same on all ranks}
    \cgalParamType{a model of `ReadablePropertyMap` with `std::pair<CDT::Vertex_handle, CDT::Vertex_handle>` as key}
    \cgalParamDefault{no constraint has a marker}
  \cgalParamNEnd
  \cgalParamNBegin{face_region_map}
    \cgalParamDescription{regions of the faces of the domain, which the mesh has, see `Mesh_2::region()`; the same on all
                          ranks}
    \cgalParamType{a model of `ReadablePropertyMap` with `CDT::Face_handle` as key}
    \cgalParamDefault{faces have no regions}
  \cgalParamNEnd
  \cgalParamNBegin{seeds}
    \cgalParamDescription{points in the holes of the domain, or in the domain, as for `CGAL::npbs_relax()`}
    \cgalParamType{a range of points}
    \cgalParamDefault{none: the domain are the faces that are marked as such, or else the faces in an odd
                      number of outlines}
  \cgalParamNEnd
  \cgalParamNBegin{seeds_are_in_domain}
    \cgalParamDescription{whether the seeds lie in the domain}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{pinned vertices of `domain`, which do not count as splitting a straight constraint only}
    \cgalParamType{a model of `ReadablePropertyMap` with `CDT::Vertex_handle` as key and `bool` as value}
    \cgalParamDefault{no vertex is pinned}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns this rank's part of the mesh

\throws std::invalid_argument if `comm` is `MPI_COMM_NULL`; on all ranks if on one a point is not finite, not in the
domain or has a property out of range or of another type, if two points have the same coordinates or the same id, if
points of some ranks have ids and points of others have none, if there is no domain, or if the domain is not the same
on all ranks
\throws std::runtime_error on all ranks if edges of the domain lie nearer to each other than the rounding of the
points on them

What the sizing function throws on one rank is thrown on all, as `std::invalid_argument`, `std::length_error`,
`std::domain_error`, `std::bad_alloc` or `std::runtime_error`.

\sa `CGAL::Distributed::npbs_relax()`
\sa `CGAL::npbs_relax()`
*/
template <class PointSet, class CDT, class NamedParameters = parameters::Default_named_parameters>
auto triangulate(const PointSet& points, const CDT& domain, MPI_Comm comm,
                 const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  return call_checked<CDT, Mesh_2<typename CDT::Geom_traits>>(np, [&](const auto& pack) {
    if constexpr (check_flat<CDT>())
      return triangulate_by_all(points, domain, comm, pack);
    else
      return Mesh_2<typename CDT::Geom_traits>();
  });
}

} // namespace CGAL::Distributed

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DISTRIBUTED_TRIANGULATE_H
