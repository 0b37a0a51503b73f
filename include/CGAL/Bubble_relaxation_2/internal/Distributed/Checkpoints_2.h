// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/check_same_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/read_checkpoint.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/write_checkpoint.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The checkpoints of a simulation by several ranks: when they are written, and the one that it started with.
class Checkpoints_2
{
public:
  /// Collective. \throws std::invalid_argument on all ranks if no checkpoint can be written where it is to be
  Checkpoints_2(const Communicator& comm, Sparse_exchange& exchange, Agreement& agreement,
                std::uint64_t hash_of_domain, const Relaxation_options& options)
    : m_comm(comm), m_exchange(exchange), m_agreement(agreement), m_hash_of_domain(hash_of_domain),
      m_options(options)
  {
    check_same(comm, hash_of(options), "the parameter checkpoint or restart_from");
    if (options.rounds_per_checkpoint != 0)
      check_checkpoint_path(comm, agreement, options.checkpoint_path);
  }

  bool is_restart() const { return !m_options.restart_path.empty(); }

  /// Reads the bubbles of this rank. What the simulation remembers of them is kept for `resume()`.
  template <class Sizing>
  const Restart_2& read(const Hilbert_curve_2& curve, const Sizing& sizing)
  {
    Checkpoint_reader_2<Sizing> reader(m_comm, m_agreement, m_options, m_hash_of_domain, sizing);
    m_restart = std::make_unique<Restart_2>(reader(m_exchange, curve));
    return *m_restart;
  }

  /// brings a simulation of these bubbles, and its report, to where they were; returns the rounds until then
  template <class Simulation, class Report>
  std::size_t resume(Simulation& simulation, Report& report)
  {
    const Checkpoint_header_2& h = m_restart->header;
    if (!h.is_coarse)
      simulation.rest_finely();
    std::vector<Bubble_memory_2> memories;
    for (const Bubble_state_2& s : m_restart->states)
      memories.push_back(s.memory);
    simulation.restart(memories, h.is_roused != 0);
    report.number_of_rounds = static_cast<std::size_t>(h.rounds);
    report.number_of_steps = static_cast<std::size_t>(h.steps);
    report.number_of_force_evaluations = static_cast<std::size_t>(h.force_evaluations);
    report.number_of_renewals = static_cast<std::size_t>(h.renewals);
    if (m_comm.rank() == 0) // each rank counts its own, and these are nobody's
      for (std::size_t k = 0; k < 4; ++k)
        *counts_of_rank(report)[k] = static_cast<std::size_t>(h.moves_returns_insertions_deletions[k]);
    const std::size_t rounds = report.number_of_rounds;
    m_restart.reset();
    return rounds;
  }

  /// Collective. Writes a checkpoint if it is time, after a round and what it did to the population.
  template <class Simulation, class Report>
  void end_round(const Simulation& simulation, const Bubbles_2& bubbles, const Hilbert_partition_2& partition,
                 std::int64_t number_of_all, Report& report)
  {
    if (m_options.rounds_per_checkpoint == 0 || report.number_of_rounds % m_options.rounds_per_checkpoint != 0)
      return;
    std::vector<Keyed_checkpoint_record_2> keyed;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.is_ours(i) && !bubbles.is_gone(i))
        keyed.push_back(Keyed_checkpoint_record_2{
          partition.curve().key(bubbles.x[i], bubbles.y[i]),
          checkpoint_record(Bubble_state_2{record(bubbles, i, bubbles.number[i]),
                                           simulation.memory(static_cast<Index>(i))})});
    std::vector<Checkpoint_record_2> records;
    const auto home = bring_home(partition, m_exchange, m_comm.rank(), places_on_curve(keyed));
    for (const auto& place : home.places)
      records.push_back(place.record->record);
    write_checkpoint(m_comm, m_agreement, m_options.checkpoint_path, header(simulation, number_of_all, report),
                     records);
  }

private:
  static std::uint64_t hash_of(const Relaxation_options& options)
  {
    Hash_of_numbers hash;
    hash.add(options.rounds_per_checkpoint);
    for (const std::string* path : {&options.checkpoint_path, &options.restart_path}) {
      hash.add(path->size());
      for (char c : *path)
        hash.add(c);
    }
    return hash.value();
  }

  template <class Report>
  static std::array<std::size_t*, 4> counts_of_rank(Report& report)
  {
    return {{&report.number_of_moves, &report.number_of_returns, &report.number_of_insertions,
             &report.number_of_deletions}};
  }

  template <class Simulation, class Report>
  Checkpoint_header_2 header(const Simulation& simulation, std::int64_t number_of_all, Report& report) const
  {
    Checkpoint_header_2 h{};
    h.hash_of_domain = m_hash_of_domain;
    const auto parameters = steering_parameters(m_options);
    for (std::size_t k = 0; k < parameters.size(); ++k)
      h.parameters[k] = parameters[k].value;
    h.number_of_all = number_of_all;
    h.is_coarse = simulation.rests_coarsely();
    h.is_roused = simulation.is_roused();
    h.initial_bubbles = static_cast<std::int64_t>(report.number_of_initial_bubbles);
    h.rounds = static_cast<std::int64_t>(report.number_of_rounds);
    h.steps = static_cast<std::int64_t>(report.number_of_steps);
    h.force_evaluations = static_cast<std::int64_t>(report.number_of_force_evaluations);
    h.renewals = static_cast<std::int64_t>(report.number_of_renewals);
    for (std::size_t k = 0; k < 4; ++k)
      h.moves_returns_insertions_deletions[k] = m_comm.sum(static_cast<std::int64_t>(*counts_of_rank(report)[k]));
    return h;
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  Agreement& m_agreement;
  std::uint64_t m_hash_of_domain;
  const Relaxation_options& m_options;
  std::unique_ptr<Restart_2> m_restart;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINTS_2_H
