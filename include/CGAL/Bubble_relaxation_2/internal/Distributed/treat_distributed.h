// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. The triangulation of the simulated bubbles of all ranks, as `make_mesh()` makes it on one. What it
/// adds to the report are counts of all ranks.
template <class Cdt, class Sizing, class Report>
Distributed_mesh_2 treat_distributed(const Domain_reading_2<Cdt>& reading, const Sizing& /* sizing */,
                                     const Relaxation_options& /* options */, const Placed_part_2& part,
                                     const Communicator& comm, Agreement& agreement, Sparse_exchange& exchange,
                                     Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  return distributed_triangulate(reading.domain, part.bubbles, part.partition, comm, agreement, exchange);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H
