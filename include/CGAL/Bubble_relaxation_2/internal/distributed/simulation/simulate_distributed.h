// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Simulation_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/integrators.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The protocol of section 2.2.1 of the paper: ranks tell each other of their bubbles every so many steps only.
/// In between each takes those of others to be where they were; and a bubble that moves into another's part is
/// marked, and stays where it is until it goes there. The population is controlled as it always is.
class Interval_team_2 : public Simulation_team_2
{
public:
  Interval_team_2(Communicator& comm, const Relaxation_options& options)
    : Simulation_team_2(comm, options), m_interval(options.exchange_interval),
      m_has_population(options.population != Bubble_population::NONE)
  {}

  void look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    double width = 0;
    if (bubbles.size() > 0)
      width = Bubble_force_2::cut_off * *std::max_element(bubbles.d.begin(), bubbles.d.end());
    Simulation_team_2::look_for_ghosts(simulation, bubbles, m_comm.largest(width));
    m_is_due = false;
    m_steps_since = 0;
  }

  /// an exchange
  void look_for_ghosts_anew(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    release_marked(simulation, bubbles);
    migrate_and_look_for_ghosts(simulation, bubbles);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (!bubbles.is_ours(i)) // they may have moved since their neighbours here fell asleep
        simulation.wake_around(static_cast<Index>(i));
  }

  void end_steps(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    release_marked(simulation, bubbles);
    m_is_due = true;
    if (!m_has_population)
      return;
    migrate(simulation, bubbles);
    Simulation_team_2::look_for_ghosts(simulation, bubbles, 0);
  }

  void send_positions(const std::vector<double>&, const std::vector<double>&) override {}
  void receive_positions(std::vector<double>&, std::vector<double>&) override {}

  void send_moves(const Bubbles_2&, const std::vector<Index>& active, const std::vector<char>&) override
  {
    ++m_steps_since;
    count_step(active.size());
  }

  const std::vector<Index>& receive_moves(Bubbles_2& b, const std::vector<Index>& active, std::vector<char>&) override
  {
    for (Index i : active)
      if (!m_halo.is_surely_home(b, i) && partition().owner(b.x[i], b.y[i]) != m_comm.rank())
        mark(b, i);
    return m_others;
  }

  Step_sums sum(const Step_sums& sums) override
  {
    const bool is_stale = m_steps_since > 1 && (!m_marked.empty() || !m_halo.received().empty());
    std::array<std::int64_t, 2> numbers{is_stale, 0};
    Step_sums result = Simulation_team_2::sum(sums, numbers);
    if (result.restless == 0 && numbers[0] != 0) { // they rest among others that may have moved
      m_is_due = true;
      result.restless = 1;
    }
    return result;
  }

  /// whether it is time for an exchange
  bool is_outgrown() const override { return m_is_due || m_steps_since >= m_interval; }

protected:
  /// bubbles migrate often, and so less often to other parts
  void balance(const Simulation_2&, const Bubbles_2& bubbles) override { m_migration.balance(bubbles, 1.1); }

private:
  static constexpr std::int32_t nobody = -1;

  struct Marked
  {
    Index bubble;
    double vx, vy;
  };

  /// A bubble of ours that has left our part rests, as one of others would, but keeps its velocity.
  void mark(Bubbles_2& b, Index i)
  {
    b.owner[i] = nobody;
    m_marked.push_back(Marked{i, b.vx[i], b.vy[i]});
    ++m_traffic.waits;
  }

  void release_marked(Simulation_2& simulation, Bubbles_2& b)
  {
    for (const Marked& m : m_marked) {
      b.owner[m.bubble] = b.rank;
      b.vx[m.bubble] = m.vx;
      b.vy[m.bubble] = m.vy;
      simulation.wake_around(m.bubble);
    }
    m_marked.clear();
  }

  const std::size_t m_interval; // steps
  const bool m_has_population;
  std::size_t m_steps_since = 0;
  bool m_is_due = false; // before the next step
  std::vector<Marked> m_marked;
};

/// Places bubbles and simulates them, all ranks together: those that `relax_bubbles()` makes on one. Their numbers are
/// their indices there. `points`: see `place_by_all()`; `traffic`: what this rank sent and held, if it is asked for.
/// \pre sizes of `problem` keep what they throw until ranks agree on it
inline Placed_part_2 simulate_distributed(Communicator& comm, const Problem_2& problem, Report& report,
                                          const Bubbles_2& points = {}, Traffic_2* traffic = nullptr)
{
  const std::unique_ptr<Simulation_team_2> team = problem.options.exchange_interval == 0
                                                    ? std::make_unique<Simulation_team_2>(comm, problem.options)
                                                    : std::make_unique<Interval_team_2>(comm, problem.options);
  Phase_timer placement_time(report.seconds.placement);
  problem.options.progress->start_phase(Bubble_phase::PLACEMENT);
  Placed_part_2 part = place_by_all(comm, problem, points, place_bubbles);
  Bubbles_2& bubbles = part.bubbles;
  bubbles.rank = comm.rank();
  bubbles.owner.assign(bubbles.size(), comm.rank());
  const std::int64_t number = comm.sum(static_cast<std::int64_t>(bubbles.size()));
  report.number_of_initial_bubbles = static_cast<std::size_t>(number);
  team->start(part.partition, number);
  placement_time.stop();
  relax(problem, bubbles, *team, report);
  if (traffic)
    *traffic = team->traffic();
  remove_confusing_of_ours(comm, problem.domain, bubbles);
  const Hilbert_partition_2& partition = team->even_partition(bubbles);
  return Placed_part_2{bring_home_and_number(comm, partition, team->next_number(), std::move(bubbles)), partition};
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
