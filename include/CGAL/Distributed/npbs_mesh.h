// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DISTRIBUTED_NPBS_MESH_H
#define CGAL_DISTRIBUTED_NPBS_MESH_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/writing/relax_by_all.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/Mesh_quality_accumulator_2.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Distributed/Mesh_2.h>

#include <mpi.h>

#include <type_traits>

namespace CGAL::Distributed {

/*!
\ingroup PkgBubbleRelaxation2Ref

What `CGAL::Distributed::npbs_mesh()` gives to a rank, beside its points.

\tparam Kernel_ the kernel of the points
\tparam Marker, Region as in `Mesh_2`
*/
template <class Kernel_, class Marker = int, class Region = int>
struct Relaxed_mesh_2
{
  using Kernel = Kernel_;

  /// What all ranks together did, and the mesh of all points, as in `Relaxation_2`.
  Bubble_relaxation_report_2<typename Bubble_relaxation_2::internal::Quality_number<Kernel>::type> report;

  /// This rank's part of the mesh. It owns the points that the rank got, in the same order, and knows the triangles
  /// around them.
  Mesh_2<Kernel, Marker, Region> mesh;
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief makes a mesh of a domain by the node placement method by bubble simulation (NPBS), on all ranks of an MPI
communicator together, each of which gets its part: what `CGAL::npbs_relax()` does on one. All ranks must call it.

The points, their properties and the report are those of `CGAL::Distributed::npbs_relax()`. The triangles of all ranks
together are those of the triangulation that `CGAL::npbs_relax()` makes, and that `triangulate()` would make of the
points; but the ranks have them already, since their qualities decide about the last moves, and nothing has to be
triangulated again.
There are no neighbour sets, and the time for these is saved.

\tparam PointSet a `CGAL::Point_set_3<K::Point_2, K::Vector_2>`
\tparam CDT as in `CGAL::npbs_relax()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points as in `CGAL::Distributed::npbs_relax()`
\param domain as in `CGAL::Distributed::npbs_relax()`
\param comm the communicator, which must exist as long as the mesh is to be written with `Mesh_2::write_pvtu()`. For all
else a duplicate of it is used, so no message of others is in the way
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of
`CGAL::Distributed::npbs_relax()`. `neighbor_radius` decides about the simulation only

\returns a `Relaxed_mesh_2`. After a callback has returned `false` the mesh has no points and no triangles

\throws what `CGAL::Distributed::npbs_relax()` throws. After any exception the points of all ranks are as they were.

\sa `CGAL::Distributed::npbs_relax()`
\sa `CGAL::Distributed::triangulate()`
*/
template <class PointSet, class CDT, class NamedParameters = parameters::Default_named_parameters>
auto npbs_mesh(PointSet& points, const CDT& domain, MPI_Comm comm,
               const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using Kernel = typename CDT::Geom_traits;
  return call_checked<CDT, Relaxed_mesh_2<Kernel>>(np, [&](const auto& pack) {
    using Tags = Tags_2<CDT, std::decay_t<decltype(pack)>>;
    using Mesh = Mesh_2<Kernel, typename Tags::Marker, typename Tags::Region>;
    Relaxed_mesh_2<Kernel, typename Tags::Marker, typename Tags::Region> result{{}, Mesh(comm)};
    const auto write = [&](const Relaxed_part_2& part, const auto& input, Communicator& ranks, const Report& report) {
      ranks.agree_after([&] {
        result.mesh = Mesh(part.mesh, input.reading.domain, Tags(pack, domain, input.reading),
                           Mesh_quality_2<double>(report.quality), comm);
      });
    };
    if constexpr (check_flat<CDT>())
      result.report = relax_by_all(points, domain, comm, pack, write);
    return result;
  });
}

} // namespace CGAL::Distributed

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DISTRIBUTED_NPBS_MESH_H
