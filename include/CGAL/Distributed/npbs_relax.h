// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_DISTRIBUTED_NPBS_RELAX_H
#define CGAL_DISTRIBUTED_NPBS_RELAX_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/writing/relax_by_all.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Distributed {

/*!
\ingroup PkgBubbleRelaxation2Ref

What `CGAL::Distributed::npbs_relax()` tells a rank, beside its points: what was done, and which points are
neighbours, as meshless methods want to know. Points of other ranks that are neighbours of points of this one are
its ghosts.

\tparam Kernel_ the kernel of the points
*/
template <class Kernel_>
struct Relaxation_2
{
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;
  using FT = typename Bubble_relaxation_2::internal::Quality_number<Kernel>::type;
  /// what names a point on all ranks
  using Global_id = std::int64_t;

  /// What all ranks together did, and the mesh of all points: the same on all ranks, and that of
  /// `CGAL::npbs_relax()`. Phases took so many seconds on the slowest rank.
  Bubble_relaxation_report_2<FT> report;

  /// \name Neighbour Sets
  /// of the points of this rank, in their order: by their ids
  /// @{
  double neighbor_radius = 0; ///< the radius of the sets in units of the mean of both sizes

  /// the neighbours of the i-th point are `neighbors[neighbor_offsets[i]]` up to, without,
  /// `neighbors[neighbor_offsets[i + 1]]`
  std::vector<std::size_t> neighbor_offsets;
  /// ids of the points nearer than `neighbor_radius` times the mean of both sizes, in increasing order
  std::vector<Global_id> neighbors;
  /// @}

  /// \name Ghosts
  /// @{
  std::vector<Global_id> ghost_ids;  ///< in increasing order
  std::vector<Point_2> ghost_points; ///< positions
  std::vector<double> ghost_sizes;   ///< the wanted distance d at each ghost
  std::vector<int> ghost_owners;     ///< the ranks that have them among their points
  /// @}
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief places nodes in a domain by the node placement method by bubble simulation (NPBS), on all ranks of an MPI
communicator together: what `CGAL::npbs_place_nodes()` does on one. All ranks must call it.

Each rank places and simulates the bubbles of its piece of the domain and gets the points there, with their
neighbours, and no rank ever has all of them. `npbs_mesh()` does the same and gives each rank its part of their mesh
instead of the neighbours.

The points, their ids, their neighbours and the report do not depend on the number of ranks, to the last bit. They
are those of one rank: the vertices of the mesh that `CGAL::npbs_relax()` makes, and the nodes and neighbour sets of
`CGAL::npbs_place_nodes()`, whose indices are the global ids. The kernel is one with `double` as its number type; with
another points on edges may differ by a rounding.

\tparam PointSet a `CGAL::Point_set_3<K::Point_2, K::Vector_2>`
\tparam CDT as in `CGAL::npbs_relax()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points to start from, any part of all on any rank, or none. They take the place of the vertices of
`domain` that are inside of it: what `CGAL::npbs_relax()` makes of a triangulation with these points is made here. The
properties `dimension`, `edge` and `position` are used if they are there; a point in a face with dimension 0 is pinned
(but makes no bubbles around it smaller, as pinned vertices of `domain` do with `limit_by_outline`), and one on an edge
must be a vertex of `domain` for that, see `insert_on_constraint_2()`. On return it has the points of this rank, in the
order of their ids, with these properties, which are added if they are not there:
- `global_id` (`std::int64_t`): 0, 1, 2, … over all ranks; near ids are near to each other.
- `size` (`double`): the wanted distance d at the point.
- `dimension` (`int`): 0 for vertices of the domain and pinned ones, 1 for points on an edge, 2 for points in a face.
- `edge` (`int`) and `position` (`double`): of a point on an edge of the domain, which edge, and where on it
  from 0 to 1, as `triangulate()` wants to know it. The edge is -1 for others.
- the normals: the velocities of the bubbles when the simulation ended.

Other properties have their default values.
\param domain the triangulation that bounds the domain, as in `CGAL::npbs_relax()`. Its vertices and its constraints
must be the same on all ranks, in any order. It is not changed.
\param comm the communicator. A duplicate of it is used, so no message of others is in the way
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `CGAL::npbs_relax()`, with the
same values on all ranks. `visitor`, `restore_when_stopped` and `elevation_function` are ignored. Those listed below
differ from there.

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted distance d of neighbouring vertices, in the units of the coordinates: the same
                          function on all ranks. A rank calls it where it has bubbles, and to find out how many
                          bubbles it asks for in the whole domain}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{as in `CGAL::npbs_relax()`}
  \cgalParamNEnd
  \cgalParamNBegin{exchange_interval}
    \cgalParamDescription{`0`: ranks tell each other after each step where their bubbles are, and the result does not
                          depend on the number of ranks. `s` > 0: the protocol of the paper, for comparison. Ranks
                          tell each other every `s` steps, or when all bubbles rest; in between the bubbles of others
                          stay where they were, and one that moves into another rank's part waits there for the next
                          exchange. Each rank knows the bubbles within 1.5 max d of its part. Between rounds the
                          population is controlled as always. Then the result depends on the number of ranks; on one
                          rank it is the same as with `0`. The more ranks and the larger `s`, the more steps it takes
                          until all bubbles rest, if they do before the limit}
    \cgalParamType{a number}
    \cgalParamDefault{`0`}
    \cgalParamExtra{Ranks still add up after each step how many bubbles move, so that they stop together.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is called with the progress, between 0 and 1, in all phases after the reading. It may be
                          another one on each rank, or none. When it returns `false` on one rank it is not called there
                          again, and all ranks stop together at the next step of the simulation or part of the
                          treatment; `points` stays as it is on all. What it returns after the treatment does not
                          matter. The last call, with 1, comes just before `points` is changed}
    \cgalParamType{an object that converts to `std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{concurrency_tag}
    \cgalParamDescription{has no effect: each rank has one thread}
    \cgalParamType{`Sequential_tag` or `Parallel_tag`}
    \cgalParamDefault{`Sequential_tag`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns a `Relaxation_2`: what was done, the statistics of the mesh of all points, and the neighbour sets of those of
this rank. After a callback has returned `false` it tells only what was done until then.

\throws std::invalid_argument if `comm` is `MPI_COMM_NULL`; on all ranks if on one a parameter is out of its range,
or not the same as on others, if there is no domain on one, if the domain is not the same on all, if a point is not
finite, not in the domain, in one place with another, or has dimension 0 on an edge, or if a property of these names
has another type; or if points are given but no `sizing_function`
\throws std::length_error on all ranks if more bubbles are expected than `maximum_number_of_bubbles`
\throws std::runtime_error on all ranks if edges of the domain lie nearer to each other than the rounding of the
bubbles on them

What the sizing function or the callback throws on one rank is thrown on all, as `std::invalid_argument`,
`std::length_error`, `std::domain_error`, `std::bad_alloc` or `std::runtime_error`. After any exception the points of
all ranks are as they were.

\sa `CGAL::npbs_relax()`
\sa `CGAL::Distributed::npbs_mesh()`
\sa `CGAL::Distributed::triangulate()`
*/
template <class PointSet, class CDT, class NamedParameters = parameters::Default_named_parameters>
auto npbs_relax(PointSet& points, const CDT& domain, MPI_Comm comm,
                const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using Result = Relaxation_2<typename CDT::Geom_traits>;
  return call_checked<CDT, Result>(np, [&](const auto& pack) {
    Result result;
    const auto write = [&result](const Relaxed_part_2& part, const auto& input, Communicator& ranks, const Report&) {
      const double radius = input.options.neighbor_radius;
      const Bubbles_2 known = with_neighbors(part.bubbles, part.partition, radius, ranks);
      ranks.agree_after([&] { write_neighbors(known, radius, result); });
    };
    if constexpr (check_flat<CDT>())
      result.report = relax_by_all(points, domain, comm, pack, write);
    return result;
  });
}

} // namespace CGAL::Distributed

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_DISTRIBUTED_NPBS_RELAX_H
