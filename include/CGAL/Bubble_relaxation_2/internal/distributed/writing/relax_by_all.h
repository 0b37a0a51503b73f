// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/point_set_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/read_same_input.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/exchange_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/quality/evaluate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/simulate_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/treat_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/writing/Point_replacement_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/Mesh_quality_accumulator_2.h>

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Collective. Makes of what each rank did in the simulation what all did together.
inline void add_up_report(const Communicator& comm, Report& report)
{
  const std::array<std::size_t*, 4> counts{&report.number_of_moves, &report.number_of_insertions,
                                           &report.number_of_deletions, &report.number_of_returns};
  std::array<std::uint64_t, 4> sums;
  for (std::size_t k = 0; k < counts.size(); ++k)
    sums[k] = *counts[k];
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_UINT64_T, MPI_SUM,
                          comm.handle()));
  for (std::size_t k = 0; k < counts.size(); ++k)
    *counts[k] = static_cast<std::size_t>(sums[k]);
}

/// Collective. Each phase takes as long as on the slowest rank.
inline void find_slowest(const Communicator& comm, Bubble_relaxation_seconds& s)
{
  const std::array<double*, 8> phases{&s.reading,    &s.placement, &s.renewal, &s.motion,
                                      &s.population, &s.treatment, &s.writing, &s.evaluation};
  std::array<double, 8> seconds;
  for (std::size_t k = 0; k < phases.size(); ++k)
    seconds[k] = *phases[k];
  check_mpi(MPI_Allreduce(MPI_IN_PLACE, seconds.data(), static_cast<int>(seconds.size()), MPI_DOUBLE, MPI_MAX,
                          comm.handle()));
  for (std::size_t k = 0; k < phases.size(); ++k)
    *phases[k] = seconds[k];
}

/// What a rank has when bubbles have been simulated and treated, before its points are changed.
struct Relaxed_part_2
{
  Distributed_mesh_2& mesh;             ///< with the sizes of its own bubbles, and old ones of others
  const Bubbles_2& bubbles;    ///< its own, in the order of their numbers
  const Hilbert_partition_2& partition; ///< from which they may have moved a little
  const Relaxation_options& options;
  const Communicator& comm;
  Agreement& agreement;
  Sparse_exchange& exchange;
};

/// Collective. What `Distributed::npbs_relax()` and `Distributed::npbs_mesh()` have in common: all but what they
/// return, which `write(part, sizes, report)` prepares by all ranks. If it throws, it throws on all.
template <class PointSet, class CDT, class NamedParameters, class Write>
auto relax_by_all(PointSet& points, const CDT& domain, MPI_Comm comm, const NamedParameters& np, const Write& write)
{
  const Communicator ranks(comm);
  Agreement agreement(ranks);
  Sparse_exchange exchange(ranks);

  Report report;
  Phase_timer reading_time(report.seconds.reading);
  const auto input = read_same_input(domain, np, ranks, agreement);
  const Domain_2& read_domain = input->reading.domain;
  check_given_points(ranks, points.size(), Is_given<NamedParameters, internal_np::sizing_function_t>::value,
                     input->options);
  Bubbles_2 given;
  agreement.reach_after([&] { given = read_bubbles(points, read_domain, input->sizes); });
  Problem_2 problem = input->problem();
  problem.sizes = agreed_sizes(input->sizes, agreement, Hilbert_curve_2(read_domain.bbox()).side());
  reading_time.stop();
  Progress progress(input->options.callback, input->options.number_of_rounds);
  const Placed_part_2 part = simulate_distributed(ranks, exchange, agreement, problem, progress, report, given);
  agreement.reach(); // the callback may have thrown, or d after the last step
  add_up_report(ranks, report);
  if (report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK) {
    Distributed_mesh_2 mesh = treat_distributed(problem, given, part, ranks, agreement, exchange, report);
    evaluate_distributed(mesh, input->wanted, ranks, agreement, report);
    const Phase_timer writing_time(report.seconds.writing);
    Point_replacement_2<PointSet> replacement(points);
    Bubbles_2 bubbles;
    agreement.reach_after([&] {
      ask_own_sizes(mesh, ranks.rank(), input->sizes);
      bubbles = own_bubbles(mesh, ranks.rank());
    });
    write(Relaxed_part_2{mesh, bubbles, part.partition, input->options, ranks, agreement, exchange}, input->sizes,
          report);
    agreement.reach_after([&] {
      replacement.prepare(bubbles);
      progress.report(1);
    });
    replacement.finish(); // nothing can fail on any rank from here on
  }
  find_slowest(ranks, report.seconds);
  return Bubble_relaxation_report_2<typename Quality_number<typename CDT::Geom_traits>::type>(report);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WRITING_RELAX_BY_ALL_H
