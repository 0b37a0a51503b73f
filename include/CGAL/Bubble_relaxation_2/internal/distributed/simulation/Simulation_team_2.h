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
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Halo_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Migration_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The ranks that simulate bubbles together: each moves its own, and is told of others' before the next step. Of the
/// population each deletes its own bubbles, and inserts in its own part.
class Simulation_team_2 : public Part_team_2
{
public:
  using Triangle = std::array<Index, 3>;

  Simulation_team_2(Communicator& comm, const Relaxation_options& options)
    : Part_team_2(comm), m_migration(comm, m_traffic), m_halo(comm, m_traffic, options.neighbor_radius),
      m_moves(comm), m_stages(comm), m_may_be_stopped(comm.any(options.progress->is_heard()))
  {}

  /// Begins with bubbles each of which is on the rank that owns its place, sorted. `number`: of all that ever were
  void start(const Hilbert_partition_2& partition, std::int64_t number)
  {
    m_migration.start(partition);
    m_partition = &m_migration.partition();
    m_number_of_all = m_next_number = number;
  }

  /// Gives the bubbles of each rank their surroundings before the first step.
  void look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    look_for_ghosts(simulation, bubbles, 0);
  }

  /// Looks after the bubbles that have gone far or grown. If one has gone too far, all are brought to the ranks
  /// that own their places now.
  void look_for_ghosts_anew(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    if (m_is_far_from_home)
      migrate_and_look_for_ghosts(simulation, bubbles);
    else
      look_after(simulation, bubbles, m_halo.almost_outgrown(bubbles, m_outgrown));
    m_outgrown.clear();
    m_is_outgrown = m_is_far_from_home = false;
  }

  /// Gets the bubbles that those of ours beside wide holes look at, which are farther away than others ever look.
  void look_across_holes(Simulation_2& simulation, Bubbles_2& bubbles) override
  {
    const Neighbor_sets_2& neighbors = simulation.neighbors();
    const Messages<Wide_hole_side_2> asked =
      wide_hole_sides(bubbles, neighbors, simulation.touched(), m_halo, partition(), m_comm.rank());
    if (!m_comm.any(!asked.empty()))
      return;
    const auto state_of = [&](Index i) { return state(simulation, bubbles, i); };
    Messages<Bubble_state_2> out;
    deliver(m_comm, asked, [&](int rank, const Wide_hole_side_2& side) {
      neighbors.find_around(side.x, side.y, side.d, [&](Index j) {
        if (bubbles.is_ours(j))
          m_halo.give(j, rank, state_of, out);
      });
    });
    deliver(m_comm, out, [&](int owner, const Bubble_state_2& s) { add_of_other(simulation, bubbles, s, owner); });
  }

  /// Tells other ranks of the bubbles from `first` on, which are new here, and adds those that are new there.
  void share_new(Simulation_2& simulation, Bubbles_2& bubbles, Index first) override
  {
    const std::int64_t first_new = m_number_of_all;
    m_number_of_all = m_next_number;
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

  /// `touched`, as far as it is known of others' bubbles as well
  std::vector<Index> share_touched(const Bubbles_2& b, std::vector<Index> touched) override
  {
    std::vector<char> is_touched(b.size(), 0);
    for (Index i : touched)
      is_touched[i] = b.is_ours(i);
    share(is_touched);
    return marked(is_touched);
  }

  void share_triangles(const Bubbles_2& b, std::vector<Triangle>& triangles) override
  {
    using Numbers = std::array<std::int64_t, 3>;
    Messages<Numbers> out;
    for (const Triangle& t : triangles) {
      const Numbers numbers{b.id[t[0]], b.id[t[1]], b.id[t[2]]};
      const std::array<int, 3> owners{m_halo.owner(t[0]), m_halo.owner(t[1]), m_halo.owner(t[2])};
      for (int k = 0; k < 3; ++k) // each once
        if (owners[k] != m_comm.rank() && std::count(owners.begin(), owners.begin() + k, owners[k]) == 0)
          out[owners[k]].push_back(numbers);
    }
    const std::unordered_map<std::int64_t, Index> indices = m_halo.indices_at_border(b);
    const auto index = [&indices](std::int64_t number) {
      const auto found = indices.find(number);
      return found == indices.end() ? no_index : found->second;
    };
    deliver(m_comm, out, [&](int, const Numbers& n) {
      triangles.push_back(Triangle{index(n[0]), index(n[1]), index(n[2])});
    });
  }

  void share(std::vector<char>& values) override { share_values(m_comm, m_halo.lists(), values); }
  void share(std::vector<double>& values) override { share_values(m_comm, m_halo.lists(), values); }

  /// \pre they are sorted along the curve
  void number(Bubbles_2& inserted) override
  {
    const std::int64_t n = static_cast<std::int64_t>(inserted.size());
    std::int64_t number = m_next_number + m_comm.sum_before(n);
    m_next_number += m_comm.sum(n);
    for (std::size_t k = 0; k < inserted.size(); ++k)
      inserted.id.push_back(number++);
  }

  /// all bubbles have smaller ones
  std::int64_t next_number() const { return m_next_number; }

  bool is_at_border(Index i) const override { return m_halo.is_at_border(i); }

  void send_positions(const std::vector<double>& x, const std::vector<double>& y) override
  {
    m_stages.start(m_halo.lists(), [&](Index i, std::size_t, std::vector<Place>& message) {
      message.push_back(Place{x[i], y[i]});
    });
  }

  void receive_positions(std::vector<double>& x, std::vector<double>& y) override
  {
    m_stages.finish(m_halo.lists(), [&](const std::vector<Index>& list, const std::vector<Place>& message) {
      for (std::size_t n = 0; n < list.size(); ++n) {
        x[list[n]] = message[n].x;
        y[list[n]] = message[n].y;
      }
    });
  }

  void share_sets(const Bubbles_2& b, Neighbor_sets_2& sets) override { internal::share_sets(m_comm, m_halo, b, sets); }

  void send_moves(const Bubbles_2& b, const std::vector<Index>& active, const std::vector<char>& is_moving) override
  {
    count_step(active.size());
    m_place.resize(b.size());
    for (std::size_t k = 0; k < active.size(); ++k)
      m_place[active[k]] = k;
    m_moves.start(m_halo.lists(), [&](Index i, std::size_t position, std::vector<Move>& message) {
      const std::size_t k = m_place[i]; // of old if it is not active
      if (k < active.size() && active[k] == i)
        message.push_back(Move{b.x[i], b.y[i], b.d[i], static_cast<std::int32_t>(position), is_moving[k]});
    });
    m_traffic.add(m_moves.out());
  }

  const std::vector<Index>& receive_moves(Bubbles_2& b, const std::vector<Index>& active,
                                          std::vector<char>& is_moving) override
  {
    m_others.clear();
    m_moves.finish(m_halo.lists(), [&](const std::vector<Index>& list, const std::vector<Move>& message) {
      for (const Move& m : message) {
        const Index i = list[m.position];
        b.x[i] = m.x;
        b.y[i] = m.y;
        b.d[i] = m.d;
        m_others.push_back(i);
        is_moving.push_back(static_cast<char>(m.is_moving));
      }
    });
    note_outgrown(b, active);
    note_outgrown(b, m_others);
    return m_others;
  }

  Step_sums sum(const Step_sums& sums) override
  {
    m_is_far_here = m_is_far_here || m_halo.has_gone_far() || m_migration.is_waited_for(m_number_of_all);
    std::array<std::int64_t, 2> numbers{!m_outgrown.empty() || m_is_far_here, m_is_far_here};
    const Step_sums result = sum(sums, numbers);
    m_is_outgrown = m_is_outgrown || numbers[0] != 0; // until the next step
    m_is_far_from_home = m_is_far_from_home || numbers[1] != 0;
    m_is_far_here = false;
    return result;
  }

  bool goes_on(bool here) const override { return m_may_be_stopped ? !m_comm.any(!here) : here; }

  /// whether a bubble of any rank has gone so far that the halo is to be made anew
  bool is_outgrown() const override { return m_is_outgrown; }

  const Hilbert_partition_2& partition() const { return m_migration.partition(); }

  /// Collective. Parts with as many bubbles each, for what comes after the simulation.
  const Hilbert_partition_2& even_partition(const Bubbles_2& bubbles)
  {
    m_migration.balance(bubbles);
    return partition();
  }

  const Traffic_2& traffic() const { return m_traffic; }

protected:
  /// Adds up what the ranks say of a step, and two more `numbers`.
  Step_sums sum(const Step_sums& sums, std::array<std::int64_t, 2>& numbers)
  {
    std::array<std::int64_t, 7> values{m_comm.has_failed(), m_awake, numbers[0], numbers[1],
                                       std::int64_t(sums.restless), std::int64_t(sums.far), std::int64_t(sums.outrun)};
    m_comm.reduce_each(values, MPI_SUM);
    if (values[0] != 0)
      m_comm.agree();
    m_migration.note_step(m_awake, values[1]);
    m_awake = 0;
    numbers = {values[2], values[3]};
    return Step_sums{std::size_t(values[4]), std::size_t(values[5]), std::size_t(values[6])};
  }

  void count_step(std::size_t awake)
  {
    m_awake = static_cast<std::int64_t>(awake);
    ++m_traffic.steps;
    m_traffic.neighbors += static_cast<std::int64_t>(m_halo.received().size());
    for (const auto& list : m_halo.received())
      m_traffic.ghosts += static_cast<std::int64_t>(list.second.size());
  }

  /// makes the halo, of one width or by the bubbles' sizes
  void look_for_ghosts(Simulation_2& simulation, Bubbles_2& bubbles, double width)
  {
    m_halo.start(bubbles, partition(), width, bubbles.size() + bubbles.size() / 8); // with others' bubbles
    std::vector<Index> near_others;
    for (std::size_t k = 0; k < bubbles.size(); ++k) {
      tick(k);
      const Index i = static_cast<Index>(k);
      m_halo.add(bubbles, i);
      if (!m_halo.is_far_from_others(i))
        near_others.push_back(i);
    }
    look_after(simulation, bubbles, near_others);
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

  void migrate(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    balance(simulation, bubbles);
    m_migration.send_home(simulation, bubbles);
  }

  virtual void balance(const Simulation_2& simulation, const Bubbles_2& bubbles)
  {
    m_migration.balance(simulation, bubbles);
  }

  Traffic_2 m_traffic;
  Migration_2 m_migration;
  Halo_2 m_halo;
  std::vector<Index> m_others; ///< that moved in this step

private:
  struct Place { double x, y; };

  struct Move
  {
    double x, y, d;
    std::int32_t position, is_moving; // position: in the lists of the halo
  };

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
    return Bubble_state_2{record(bubbles, static_cast<std::size_t>(i)), simulation.memory(i)};
  }

  Index add_of_other(Simulation_2& simulation, Bubbles_2& bubbles, const Bubble_state_2& s, int owner)
  {
    const Index i = static_cast<Index>(bubbles.size());
    add(bubbles, s.bubble, owner);
    simulation.add_known(s.memory);
    m_halo.add(bubbles, i);
    return i;
  }

  void look_after(Simulation_2& simulation, Bubbles_2& bubbles, const std::vector<Index>& those)
  {
    const bool by_references = simulation.keeps_references();
    Neighbor_sets_2 now(Neighbor_sets_2::without_skin);
    if (!by_references)
      now.build(bubbles);
    m_halo.look_after(
      bubbles, those, by_references ? simulation.neighbors() : now,
      [&](Index i) { return state(simulation, bubbles, i); },
      [&](const Bubble_state_2& s, int owner) {
        const Index i = add_of_other(simulation, bubbles, s, owner);
        if (!by_references)
          now.add(bubbles, i);
      });
  }

  /// the same; neighbour sets that are not what references tell go with their bubbles
  void migrate_with_sets(Simulation_2& simulation, Bubbles_2& bubbles)
  {
    balance(simulation, bubbles);
    Numbered_sets messages;
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.is_ours(i) && !bubbles.is_gone(i))
        messages.add(partition().owner(bubbles.x[i], bubbles.y[i]), bubbles, simulation.neighbors(),
                     static_cast<Index>(i));
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

  Shared_delivery<Move> m_moves;
  Shared_delivery<Place> m_stages;
  std::vector<std::size_t> m_place; // of each bubble among the active ones, when it last was one
  std::int64_t m_number_of_all = 0, m_next_number = 0; // that ever were, known here; and with those to be told of
  std::int64_t m_awake = 0;         // in this step, here
  bool m_may_be_stopped, m_is_outgrown = false, m_is_far_here = false, m_is_far_from_home = false;
  std::vector<Index> m_outgrown; // of those that moved since the halo was looked after
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATION_TEAM_2_H
