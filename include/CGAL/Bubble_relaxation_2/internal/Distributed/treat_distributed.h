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

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// `keep_the_better()` by ranks: given bubbles whose mesh is better than what was made of them are treated instead.
template <class Cdt, class Sizing>
void keep_the_better_of_all(const Domain_reading_2<Cdt>& reading, const Sizing& sizing, const Numbered_bubbles_2& points,
                            bool may_operate, const Communicator& comm, Agreement& agreement,
                            Sparse_exchange& exchange, Distributed_mesh_2& mesh, Treatment_counts& counts)
{
  const Placed_part_2 given = given_bubbles_distributed(comm, exchange, agreement, reading, sizing, points);
  const Distributed_treatment_2 treat(reading.domain, given.partition, comm, agreement, exchange);
  const std::int64_t before = comm.sum(static_cast<std::int64_t>(given.bubbles.size()));
  if (!is_about_as_many(static_cast<std::size_t>(before), static_cast<std::size_t>(treat.number_of_bubbles(mesh))))
    return;
  Distributed_mesh_2 given_mesh = treat.triangulate(given.bubbles);
  if (treat.smallest_quality(given_mesh) <= treat.smallest_quality(mesh))
    return;
  counts = treat(given_mesh, may_operate);
  mesh = std::move(given_mesh);
}

/// Collective. The triangulation of the simulated bubbles of all ranks, as `make_mesh()` makes it on one. What it
/// adds to the report are counts of all ranks. `points`: those that were given on this rank.
template <class Cdt, class Sizing, class Report>
Distributed_mesh_2 treat_distributed(const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                                     const Relaxation_options& options, const Numbered_bubbles_2& points,
                                     const Placed_part_2& part, const Communicator& comm, Agreement& agreement,
                                     Sparse_exchange& exchange, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  const Distributed_treatment_2 treat(reading.domain, part.partition, comm, agreement, exchange);
  Distributed_mesh_2 mesh = treat.triangulate(part.bubbles);
  if (!is_treatment_due(options, report))
    return mesh;
  const bool may_operate = options.population != Bubble_population::NONE;
  Treatment_counts counts = treat(mesh, may_operate);
  if (keeps_given_bubbles(options))
    keep_the_better_of_all(reading, sizing, points, may_operate, comm, agreement, exchange, mesh, counts);
  counts.add_to(report);
  return mesh;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREAT_DISTRIBUTED_H
