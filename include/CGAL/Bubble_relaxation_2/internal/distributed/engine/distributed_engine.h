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

#include <optional>

#ifdef CGAL_BUBBLE_RELAXATION_2_COMPILED_RANKS // by this project, for its own programs
#define CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
#else
#define CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE inline
#endif

namespace CGAL::Bubble_relaxation_2::internal {

// What lies between reading and writing on ranks, without the user's types. All is collective.

/// what a rank has when bubbles have been simulated and treated
struct Relaxed_part_2
{
  Distributed_mesh_2 mesh;
  Bubbles_2 bubbles;             ///< its own, in the order of their numbers
  Hilbert_partition_2 partition; ///< that they need not be at home in any more
};

/// The bubbles of all ranks after placement, simulation and treatment, and their mesh, whose statistics are in the
/// report; nothing if a callback stops it. What sizes of `problem` throw on a rank is thrown on all. `given`: this
/// rank's bubbles to start from \pre the progress of `problem` remembers stops, and `comm` keeps what callbacks throw
CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
std::optional<Relaxed_part_2> relax_part(Problem_2 problem, const Bubbles_2& given, Communicator& comm,
                                         Report& report);

/// The bubbles of this rank, and after them those of others that are neighbours of one of them, and perhaps some more:
/// nearer than `radius` times the mean of both sizes, so nearer than that times the larger one.
/// \pre the numbers of `own` ascend
CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
Bubbles_2 with_neighbors(const Bubbles_2& own, const Hilbert_partition_2& partition, double radius,
                         Communicator& comm);

/// This rank's part of the mesh of points on any rank, which have numbers or not, and the statistics of all of it.
/// `sizes`: those of edges, if they are known
CGAL_BUBBLE_RELAXATION_2_RANKS_INLINE
Distributed_mesh_2 triangulate_part(const Domain_2& domain, Bubbles_2 points, bool have_numbers, const Sizes_2* sizes,
                                    Communicator& comm, Mesh_quality_2<double>& quality);

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED_RANKS
#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_ENGINE_DISTRIBUTED_ENGINE_H
