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
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/simulation/Simulation_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Replaces distinct numbers below `end`, of which each rank has some, by 0, 1, … in their order. Each rank counts
/// those of an interval of numbers, which are mostly its own. \pre they ascend
class Number_compaction
{
public:
  Number_compaction(Communicator& comm, std::int64_t end)
    : m_comm(comm), m_end(end)
  {}

  /// Collective. To be called once.
  void operator()(std::vector<std::int64_t>& numbers)
  {
    find_own(numbers);
    const Messages<std::int64_t> in = deliver(m_comm, those_of_others(numbers));
    for (const auto& message : in)
      m_received.insert(m_received.end(), message.second.begin(), message.second.end());
    std::sort(m_received.begin(), m_received.end());
    m_before = m_comm.sum_before((m_last - m_first) + static_cast<std::int64_t>(m_received.size()));
    Messages<std::int64_t> replies, answers;
    for (const auto& message : in)
      for (std::int64_t number : message.second)
        replies[message.first].push_back(m_before + count_below(numbers, number));
    for (const auto& interval : m_intervals)
      answers[interval.first].resize(static_cast<std::size_t>(interval.second.second - interval.second.first));
    deliver_expected(m_comm, replies, answers);
    compact_own(numbers);
    for (const auto& answer : answers)
      std::copy(answer.second.begin(), answer.second.end(), numbers.begin() + m_intervals[answer.first].first);
  }

private:
  using Position = std::ptrdiff_t; ///< among the numbers of this rank

  /// the first number that a rank counts
  std::int64_t first_of(int rank) const { return (rank * m_end + m_comm.size() - 1) / m_comm.size(); }

  static Position position(const std::vector<std::int64_t>& numbers, std::int64_t number)
  {
    return std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin();
  }

  void find_own(const std::vector<std::int64_t>& numbers)
  {
    m_first = position(numbers, first_of(m_comm.rank()));
    m_last = position(numbers, first_of(m_comm.rank() + 1));
  }

  Messages<std::int64_t> those_of_others(const std::vector<std::int64_t>& numbers)
  {
    Messages<std::int64_t> out;
    const Position end = static_cast<Position>(numbers.size());
    for (Position first = 0; first < end;) {
      const int rank = static_cast<int>(numbers[first] * m_comm.size() / m_end);
      const Position last = position(numbers, first_of(rank + 1));
      if (rank != m_comm.rank()) {
        out[rank].assign(numbers.begin() + first, numbers.begin() + last);
        m_intervals[rank] = {first, last};
      }
      first = last;
    }
    return out;
  }

  /// of the numbers that this rank counts
  std::int64_t count_below(const std::vector<std::int64_t>& numbers, std::int64_t number) const
  {
    return (position(numbers, number) - m_first) + position(m_received, number);
  }

  void compact_own(std::vector<std::int64_t>& numbers) const
  {
    auto received = m_received.begin();
    for (Position k = m_first; k < m_last; ++k) {
      while (received != m_received.end() && *received < numbers[k])
        ++received;
      numbers[k] = m_before + (k - m_first) + (received - m_received.begin());
    }
  }

  Communicator& m_comm;
  const std::int64_t m_end;
  Position m_first = 0, m_last = 0; // between these are the numbers that this rank has and counts
  std::map<int, std::pair<Position, Position>> m_intervals; // of those that others count
  std::vector<std::int64_t> m_received;                     // others', which this rank counts
  std::int64_t m_before = 0;                                // which lower ranks count
};

/// Removes bubbles of ours that cannot be told apart on edges, as `remove_crowded_on_edges()` does of all.
inline void remove_crowded_of_ours(const Domain_2& domain, const Population_team_2& team, Bubbles_2& b)
{
  Outline_bubbles_2 outline;
  outline.on_corner.resize(domain.corners().size());
  team.share_outline(domain, b, outline);
  for (std::size_t e = 0; e < outline.on_edge.size(); ++e) {
    Crowd_on_edge crowd(domain.length(static_cast<Index>(e)));
    for (const Outline_bubble_2& bubble : outline.on_edge[e])
      if (crowd.has(bubble.s, bubble.d) && bubble.index != no_index)
        b.remove(bubble.index);
  }
}

/// The bubbles that are left, each on the rank that owns its place and numbered from 0 on.
inline Placed_part_2 bring_home_and_number(Communicator& comm,
                                           const Hilbert_partition_2& partition, std::int64_t end, Bubbles_2 bubbles)
{
  std::vector<Index> left;
  left.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (bubbles.is_ours(i) && !bubbles.is_gone(i))
      left.push_back(static_cast<Index>(i));
  bubbles.select(left);
  bubbles.owner.clear(); // all are ours
  Bubbles_2 home = send_home(comm, partition, std::move(bubbles));
  remove_those_in_one_place(home);
  home.forget_gone();
  Number_compaction(comm, end)(home.id);
  return Placed_part_2{std::move(home), partition};
}

/// Gives each rank its first bubbles, new ones or those of a checkpoint; returns how many were new.
inline std::size_t find_first_bubbles(Communicator& comm,
                                      const Problem_2& problem, const Bubbles_2& points,
                                      Checkpoints_2& checkpoints, Simulation_team_2& team, Bubbles_2& bubbles)
{
  bubbles.rank = comm.rank();
  if (checkpoints.is_restart()) {
    const Restart_2& restart = checkpoints.read(hilbert_curve(problem.domain), problem.sizes);
    for (const Bubble_state_2& s : restart.states)
      add(bubbles, s.bubble, comm.rank());
    team.start(restart);
    return static_cast<std::size_t>(restart.header.initial_bubbles);
  }
  Placed_part_2 part = place_distributed(comm, problem, points);
  team.start(part);
  bubbles = std::move(part.bubbles);
  bubbles.rank = comm.rank();
  bubbles.owner.assign(bubbles.size(), comm.rank());
  return static_cast<std::size_t>(comm.sum(static_cast<std::int64_t>(bubbles.size())));
}

/// Places bubbles and simulates them, all ranks together: those that `relax_bubbles()` makes on one. Their
/// numbers are their indices there. `points`: see `place_distributed()`;
/// `traffic`: what this rank sent and held, if it is asked for.
/// \pre sizes of `problem` keep what they throw until ranks agree on it
inline Placed_part_2 simulate_distributed(Communicator& comm,
                                          const Problem_2& problem, Progress& progress, Report& report,
                                          const Bubbles_2& points = {}, Traffic_2* traffic = nullptr)
{
  Checkpoints_2 checkpoints(comm, hash_of_places(problem.domain, problem.given), problem.options);
  Simulation_team_2 team(comm, checkpoints, problem.options);
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    report.number_of_initial_bubbles =
      find_first_bubbles(comm, problem, points, checkpoints, team, bubbles);
  }
  relax(problem, bubbles, team, progress, report);
  if (traffic)
    *traffic = team.traffic();
  remove_crowded_of_ours(problem.domain, team.population(), bubbles);
  return bring_home_and_number(comm, team.partition(), team.population().next_number(),
                               std::move(bubbles));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_SIMULATE_DISTRIBUTED_H
