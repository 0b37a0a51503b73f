// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>

#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Mesh_quality_2.h>

// This needs MPI, so it is not in the core that is installed: the project's own programs have it compiled once.
#ifdef CGAL_BUBBLE_RELAXATION_2_COMPILED_DISTRIBUTED
#define CGAL_BUBBLE_RELAXATION_2_DISTRIBUTED_INLINE
#else
#define CGAL_BUBBLE_RELAXATION_2_DISTRIBUTED_INLINE inline
#endif

namespace CGAL::Bubble_relaxation_2::internal {

// What lies between reading and writing on several ranks, without the user's types.

/// a rank's part of a mesh, and who owned what when it was made
struct Meshed_part_2
{
  Distributed_mesh_2 mesh;
  Hilbert_partition_2 partition; ///< its bubbles need not be at home in it any more
};

/// Collective. What `make_mesh()` makes on one rank, without a mesh if the callback has stopped all. `given`: bubbles of
/// this rank to start from
CGAL_BUBBLE_RELAXATION_2_DISTRIBUTED_INLINE
Meshed_part_2 make_distributed_mesh(Communicator& comm, const Problem_2& problem, const Bubbles_2& given,
                                    Report& report);

/// Collective. The triangulation of points, which come in any way spread over the ranks, and its statistics.
/// `have_numbers`: whether points of this rank have some; `sizes`: null if lengths are not compared with any
/// \throws std::invalid_argument on all ranks, see `Point_distribution_2`
CGAL_BUBBLE_RELAXATION_2_DISTRIBUTED_INLINE
Distributed_mesh_2 triangulate_points(Communicator& comm, const Domain_2& domain, Bubbles_2 points,
                                      bool have_numbers, const Sizes_2* sizes, Mesh_quality_2<double>& quality);

/// Collective. The bubbles of this rank, and after them those of others that are neighbours of one of them, and perhaps
/// some more: nearer than `radius` times the mean of both sizes, so nearer than that times the larger one.
/// \pre the numbers of `own` ascend
CGAL_BUBBLE_RELAXATION_2_DISTRIBUTED_INLINE
Bubbles_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius, Communicator& comm);

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED_DISTRIBUTED
#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_H
