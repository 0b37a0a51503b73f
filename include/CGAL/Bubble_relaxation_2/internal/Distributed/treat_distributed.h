// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_treatment_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/treat_defects.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. The triangulation of the simulated bubbles of all ranks, as `make_mesh()` makes it on one. What it
/// adds to the report are counts of all ranks.
template <class Cdt, class Report>
Distributed_mesh_2 treat_distributed(const Domain_reading_2<Cdt>& reading, const Relaxation_options& options,
                                     const Placed_part_2& part, const Communicator& comm, Agreement& agreement,
                                     Sparse_exchange& exchange, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  const Distributed_treatment_2 treat(reading.domain, part.partition, comm, agreement, exchange);
  Distributed_mesh_2 mesh = treat.triangulate(part.bubbles);
  if (!is_treatment_due(options, report))
    return mesh;
  const Treatment_counts counts = treat(mesh, options.population != Bubble_population::NONE);
  report.number_of_treated_vertices = counts.treated;
  report.number_of_insertions += counts.inserted;
  report.number_of_deletions += counts.deleted;
  return mesh;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H
