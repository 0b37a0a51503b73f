// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RELAX_BY_ALL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RELAX_BY_ALL_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/add_up_report.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/check_given_points.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/evaluate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/own_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/read_same_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/read_same_options.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/with_same_sizing_field.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/write_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/Mesh_quality_accumulator_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/Progress.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What a rank has when bubbles have been simulated and treated, before its points are changed.
struct Relaxed_part_2
{
  Distributed_mesh_2& mesh;             ///< with the sizes of its own bubbles, and old ones of others
  const Numbered_bubbles_2& bubbles;    ///< its own, in the order of their numbers
  const Hilbert_partition_2& partition; ///< from which they may have moved a little
  const Relaxation_options& options;
  const Communicator& comm;
  Agreement& agreement;
  Sparse_exchange& exchange;
};

/// Collective. What `Distributed::npbs_relax()` and `Distributed::npbs_mesh()` have in common: all but what they
/// return, which `write(part, sizing, report)` prepares by all ranks. If it throws, it throws on all.
template <class PointSet, class CDT, class NamedParameters, class Write>
auto relax_by_all(PointSet& points, const CDT& domain, MPI_Comm comm, const NamedParameters& np, const Write& write)
{
  const Communicator ranks(comm);
  Agreement agreement(ranks);
  Sparse_exchange exchange(ranks);

  Bubble_relaxation_report_2<typename Quality_number<typename CDT::Geom_traits>::type> report;
  Phase_timer reading_time(report.seconds.reading);
  const Relaxation_options options = read_same_options(np, ranks, agreement);
  check_given_points(ranks, points.size(), Is_given<NamedParameters, internal_np::sizing_function_t>::value, options);
  Progress progress(options.callback, options.number_of_rounds);
  const Same_domain_2<CDT> same = read_same_domain(domain, np, ranks, agreement);
  const Domain_reading_2<CDT>& reading = *same.reading;
  check_same_vertices(ranks, reading);
  with_same_sizing_field(domain, np, same, options, ranks, agreement, [&](const auto& sizing, const auto& wanted) {
    Numbered_bubbles_2 given;
    agreement.reach_after([&] { given = read_bubbles(points, reading.domain, sizing); });
    reading_time.stop();

    const Placed_part_2 part = simulate_distributed(ranks, exchange, agreement, domain, reading, sizing, options,
                                                    progress, report, given);
    agreement.reach(); // the callback may have thrown, or d after the last step
    add_up_report(ranks, report);
    if (report.stop_reason == Bubble_stop_reason::STOPPED_BY_CALLBACK)
      return;
    Distributed_mesh_2 mesh = treat_distributed(reading, sizing, options, given, part, ranks, agreement, exchange,
                                                report);
    evaluate_distributed(mesh, wanted, ranks, agreement, report);

    const Phase_timer writing_time(report.seconds.writing);
    Point_replacement_2<PointSet> replacement(points);
    Numbered_bubbles_2 bubbles;
    agreement.reach_after([&] {
      ask_own_sizes(mesh, ranks.rank(), sizing);
      bubbles = own_bubbles(mesh, ranks.rank());
    });
    write(Relaxed_part_2{mesh, bubbles, part.partition, options, ranks, agreement, exchange}, sizing, report);
    agreement.reach_after([&] {
      replacement.prepare(bubbles);
      progress.report(1);
    });
    replacement.finish(); // nothing can fail on any rank from here on
  });
  find_slowest(ranks, report.seconds);
  return report;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_RELAX_BY_ALL_H
