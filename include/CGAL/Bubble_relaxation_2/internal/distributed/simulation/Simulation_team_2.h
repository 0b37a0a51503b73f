// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATION_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATION_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Team_of_ranks.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Ghost_updates_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Migration_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Population_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The ranks that simulate bubbles together: each moves its own, and is told of others' before the next step.
class Simulation_team_2 : public Team_of_ranks
{
public:
  Simulation_team_2(Communicator& comm, const Relaxation_options& options)
    : Team_of_ranks(comm), m_interval(options.exchange_interval), m_migration(comm, m_traffic),
      m_halo(comm, m_traffic, options.neighbor_radius), m_moves(comm, m_traffic), m_stages(comm),
      m_population(comm, m_halo),
      m_may_be_stopped(comm.any(options.progress->is_heard())),
      m_has_population(options.population != Bubble_population::NONE)
  {}

  /// Begins with bubbles each of which is on the rank that owns its place, sorted. `number`: of all that ever were
  void start(const Hilbert_partition_2& partition, std::int64_t number)
  {
    m_migration.start(partition);
    m_number_of_all = number;
    m_population.start(m_migration.partition(), number);
  }

  /// Gives the bubbles of each rank their surroundings before the first step.
  void look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    look_for_ghosts(simulation, bubbles, m_interval.is_used() ? Bubble_force_2::cut_off * largest_size(bubbles) : 0);
    m_interval.start_stage();
  }

  /// Looks after the bubbles that have gone far or grown. If one has gone too far, all are brought to the ranks
  /// that own their places now; and so they are in each exchange of the paper's protocol.
  void look_for_ghosts_anew(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    if (m_interval.is_used()) {
      release_marked(simulation, bubbles);
      migrate_and_look_for_ghosts(simulation, bubbles);
      wake_around_others(simulation, bubbles);
    } else if (m_is_far_from_home)
      migrate_and_look_for_ghosts(simulation, bubbles);
    else
      look_after(simulation, bubbles, m_halo.almost_outgrown(bubbles, m_outgrown));
    m_outgrown.clear();
    m_is_outgrown = m_is_far_from_home = false;
  }

  /// After the steps of a round the paper's protocol ends, and the population is controlled as it always is.
  void end_steps(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    if (!m_interval.is_used())
      return;
    release_marked(simulation, bubbles);
    m_interval.make_due();
    if (!m_has_population)
      return;
    migrate(simulation, bubbles);
    look_for_ghosts(simulation, bubbles, 0);
  }

  /// Gets the bubbles that those of ours beside wide holes look at, which are farther away than others ever look.
  void look_across_holes(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    const Neighbor_sets_2& neighbors = simulation.neighbors();
    const Messages<Wide_hole_side_2> asked =
      wide_hole_sides(bubbles, neighbors, simulation.touched(), m_halo, partition(), m_comm.rank());
    if (!m_comm.any(!asked.empty()))
      return;
    m_halo.fetch(
      asked,
      [&](const Wide_hole_side_2& side, const auto& visit) { neighbors.find_around(side.x, side.y, side.d, visit); },
      [&](Index i) { return state(simulation, bubbles, i); },
      [&](const Bubble_state_2& s, int owner) { add_of_other(simulation, bubbles, s, owner); });
    m_moves.connect(m_halo, bubbles.size());
  }

  /// Tells other ranks of the bubbles from `first` on, which are new here, and adds those that are new there.
  void share_new(Simulation_2& simulation, Bubbles_2& bubbles, Index first) override
  {
    const std::int64_t first_new = m_number_of_all;
    m_number_of_all = m_population.next_number();
    if (m_number_of_all == first_new)
      return;
    std::vector<Index> those;
    for (Index i = first, last = static_cast<Index>(bubbles.size()); i < last; ++i) {
      m_halo.add(bubbles, i);
      those.push_back(i);
    }
    look_after(simulation, bubbles, those);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.id[i] >= first_new && !bubbles.is_ours(i))
        simulation.wake_around(static_cast<Index>(i));
  }

  std::size_t number_of_all(const Bubbles_2&) const override { return static_cast<std::size_t>(m_number_of_all); }

  Population_team_2& population() override { return m_population; }

  bool is_at_border(Index i) const override { return m_halo.is_at_border(i); }

  void send_positions(const std::vector<double>& x, const std::vector<double>& y) override
  {
    if (!m_interval.is_used())
      m_stages.send(m_halo, x, y);
  }

  void receive_positions(std::vector<double>& x, std::vector<double>& y) override
  {
    if (!m_interval.is_used())
      m_stages.receive(m_halo, x, y);
  }

  void share_sets(const Bubbles_2& b, Neighbor_sets_2& sets) override
  {
    internal::share_sets(m_comm, m_halo, b, sets);
  }

  void send_moves(const Bubbles_2& b, const std::vector<Index>& active, const std::vector<char>& is_moving) override
  {
    count_step();
    m_awake = static_cast<std::int64_t>(active.size());
    if (!m_interval.is_used())
      m_moves.send(m_halo, b, active, is_moving);
  }

  const std::vector<Index>& receive_moves(Bubbles_2& b, const std::vector<Index>& active,
                                          std::vector<char>& is_moving) override
  {
    m_others.clear();
    if (m_interval.is_used()) {
      mark_those_that_left(b, active);
      return m_others;
    }
    m_moves.receive(m_halo, b, m_others, is_moving);
    note_outgrown(b, active);
    note_outgrown(b, m_others);
    return m_others;
  }

  Step_sums sum(const Step_sums& sums) override
  {
    const bool is_stale = m_interval.is_stale() && (m_interval.has_marked() || !m_halo.received().empty());
    const bool is_far_here =
      m_is_far_here ||
      (!m_interval.is_used() && (m_halo.has_gone_far() || m_migration.is_waited_for(m_number_of_all)));
    std::array<std::int64_t, 7> values{static_cast<std::int64_t>(sums.restless),
                                       static_cast<std::int64_t>(sums.outrun), m_comm.has_failed(),
                                       !m_outgrown.empty() || is_far_here, is_far_here, is_stale, m_awake};
    m_comm.reduce_each(values, MPI_SUM);
    if (values[2] != 0)
      m_comm.agree();
    m_is_outgrown = m_is_outgrown || values[3] != 0; // until the next step
    m_is_far_from_home = m_is_far_from_home || values[4] != 0;
    m_is_far_here = false;
    m_migration.note_step(m_awake, values[6]);
    m_awake = 0;
    if (values[0] == 0 && values[5] != 0) { // they rest among others that may have moved
      m_interval.make_due();
      values[0] = 1;
    }
    return Step_sums{static_cast<std::size_t>(values[0]), static_cast<std::size_t>(values[1])};
  }

  bool goes_on(bool here) const override { return m_may_be_stopped ? !m_comm.any(!here) : here; }

  /// whether a bubble of any rank has gone so far that the halo is to be made anew, or it is time for that
  bool is_outgrown() const override { return m_interval.is_used() ? m_interval.is_due() : m_is_outgrown; }

  const Hilbert_partition_2& partition() const { return m_migration.partition(); }

  /// Collective. Parts with as many bubbles each, for what comes after the simulation.
  const Hilbert_partition_2& even_partition(const Bubbles_2& bubbles)
  {
    m_migration.balance(bubbles);
    return partition();
  }

  const Traffic_2& traffic() const { return m_traffic; }

private:
  /// makes the halo, of one width or by the bubbles' sizes
  void look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles, double width)
  {
    m_halo.start(bubbles, partition(), width, bubbles.size() + bubbles.size() / 8); // with others' bubbles
    std::vector<Index> near_others;
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
      const Index i = static_cast<Index>(k);
      m_halo.add(bubbles, i);
      if (!m_halo.is_far_from_others(i))
        near_others.push_back(i);
    }
    look_after(simulation, bubbles, near_others);
  }

  double largest_size(const Bubbles_2& bubbles) const
  {
    return m_comm.largest(bubbles.size() == 0 ? 0. : *std::max_element(bubbles.d.begin(), bubbles.d.end()));
  }

  void mark_those_that_left(Bubbles_2& b, const std::vector<Index>& active)
  {
    for (Index i : active)
      if (!m_halo.is_surely_home(b, i) && partition().owner(b.x[i], b.y[i]) != m_comm.rank()) {
        m_interval.mark(b, i);
        ++m_traffic.waits;
      }
  }

  void release_marked(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    m_interval.release(bubbles, [&simulation](Index i) { simulation.wake_around(i); });
  }

  /// others may have moved since their neighbours here fell asleep
  static void wake_around_others(Simulation_2& simulation, const Bubbles_2& bubbles)
  {
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (!bubbles.is_ours(i))
        simulation.wake_around(static_cast<Index>(i));
  }

  void count_step()
  {
    m_interval.count_step();
    ++m_traffic.steps;
    m_traffic.neighbors += static_cast<std::int64_t>(m_halo.received().size());
    for (const auto& list : m_halo.received())
      m_traffic.ghosts += static_cast<std::int64_t>(list.second.size());
  }

  void note_outgrown(const Bubbles_2& b, const std::vector<Index>& moved)
  {
    for (Index i : moved)
      if (m_halo.is_outgrown_by(b, i)) {
        m_outgrown.push_back(i);
        m_is_far_here = m_is_far_here || m_halo.is_far_from_home(b, i);
      }
  }

  static Bubble_state_2 state(const Simulation_2& simulation, const Bubbles_2& bubbles, Index i)
  {
    return bubble_state(bubbles, static_cast<std::size_t>(i), simulation.memory(i));
  }

  Index add_of_other(Simulation_2& simulation, Bubbles_2& bubbles, const Bubble_state_2& s, int owner)
  {
    const Index i = static_cast<Index>(bubbles.size());
    add(bubbles, s.bubble(), owner);
    simulation.add_known(s.memory());
    m_halo.add(bubbles, i);
    return i;
  }

  void look_after(Simulation_2& simulation, Bubbles_2& bubbles, const std::vector<Index>& those)
  {
    std::unique_ptr<Position_index_2> here;
    if (!simulation.keeps_references())
      here = std::make_unique<Position_index_2>(bubbles);
    const auto look_after_with = [&](const auto& finder) {
      m_halo.look_after(
        bubbles, those, finder,
        [&](Index i) { return state(simulation, bubbles, i); },
        [&](const Bubble_state_2& s, int owner) {
          const Index i = add_of_other(simulation, bubbles, s, owner);
          if (here)
            here->add(bubbles, i);
        });
    };
    if (here)
      look_after_with(*here);
    else
      look_after_with(simulation.neighbors());
    m_moves.connect(m_halo, bubbles.size());
  }

  void migrate_and_look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    if (!simulation.keeps_references()) {
      migrate_with_sets(simulation, bubbles);
      return;
    }
    migrate(simulation, bubbles);
    look_for_ghosts(simulation, bubbles);
  }

  /// the same; neighbour sets that are not what references tell go with their bubbles
  void migrate_with_sets(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    balance(simulation, bubbles);
    Numbered_sets messages;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.is_ours(i) && !bubbles.is_gone(i))
        messages.add(partition().owner(bubbles.x[i], bubbles.y[i]), bubbles, simulation.neighbors(),
                     static_cast<Index>(i), [](Index) { return true; });
    messages.send(m_comm);
    m_migration.send_home(simulation, bubbles);
    look_for_ghosts(simulation, bubbles);
    std::vector<std::vector<Index>> sets(bubbles.size());
    std::unordered_map<std::int64_t, Index> indices;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      indices[bubbles.id[i]] = static_cast<Index>(i);
    messages.for_each(bubbles, indices, [&sets](Index i, const std::vector<Index>& set) { sets[i] = set; });
    simulation.neighbors().assign_all(bubbles, [&sets](Index i) { return sets[i]; });
  }

  /// with the paper's protocol bubbles migrate often, and so less often to other parts
  void balance(const Simulation_2& simulation, const Bubbles_2& bubbles)
  {
    if (m_interval.is_used())
      m_migration.balance(bubbles, 1.1);
    else
      m_migration.balance(simulation, bubbles);
  }

  void migrate(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    balance(simulation, bubbles);
    m_migration.send_home(simulation, bubbles);
  }

  Exchange_interval_2 m_interval;
  Traffic_2 m_traffic;
  Migration_2 m_migration;
  Halo_2 m_halo;
  Move_messages_2 m_moves;
  Stage_messages_2 m_stages;
  Population_team_2 m_population;
  std::int64_t m_number_of_all = 0; // that ever were
  std::int64_t m_awake = 0;         // in this step, here
  bool m_may_be_stopped, m_has_population, m_is_outgrown = false, m_is_far_here = false,
       m_is_far_from_home = false;
  std::vector<Index> m_others;
  std::vector<Index> m_outgrown; // of those that moved since the halo was looked after
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATION_TEAM_2_H
