// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_HALO_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_HALO_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/population/Local_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Boundary_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What a rank of a simulation holds of others and sends to them, without control of the population and reductions.
struct Traffic_2
{
  std::int64_t steps = 0;
  std::int64_t ghosts = 0;    ///< bubbles of others that it holds, summed over the steps
  std::int64_t neighbors = 0; ///< ranks that it has such bubbles of, summed over the steps
  std::int64_t waits = 0;     ///< bubbles that stopped in another's part until the next exchange (paper's protocol)
  std::int64_t messages = 0;  ///< that it has sent: moves, bubbles made known, and bubbles that go home
  std::int64_t bytes = 0;     ///< in these messages

  /// what it sends now
  template <class T>
  void add(const Messages<T>& out)
  {
    messages += static_cast<std::int64_t>(out.size());
    for (const auto& message : out)
      bytes += static_cast<std::int64_t>(message.second.size() * sizeof(T));
  }
};

/// The bubbles of other ranks that lie around those of one, and who knows which of its own. Two bubbles nearer to
/// each other than the reach times the size of the larger one are known to the owners of both: each is sent to the
/// ranks whose parts a disc around it meets, and owners of larger ones are told of smaller ones around them.
///
/// This holds for where bubbles were when it was last looked after. It stays good enough, for neighbours of neighbours,
/// while none has gone far or grown much, of which `is_outgrown_by()` tells; those are looked after again by
/// `look_after()`. Ownership does not change: `is_far_from_home()` tells of a bubble that may have left the part of its
/// owner so far that all have to be distributed anew.
///
/// For the paper's protocol it can have one width for all instead: then each bubble is known to the ranks whose
/// parts are nearer than that.
class Halo_2
{
public:
  /// In sizes: bubbles may go as far as the first until they are looked after, and then with the step in which they
  /// do; and as far as the second from their owner's part.
  static constexpr double most_moved = 0.5, farthest_from_home = 1;

  /// how far a bubble may be from its owner's part, with what it has moved since it was looked after
  static constexpr double away_from_part = farthest_from_home + most_moved + Boundary_2::longest_step;

  /// `neighbor_radius`: of the neighbour sets
  Halo_2(Communicator& comm, Traffic_2& traffic, double neighbor_radius)
    : m_comm(comm), m_traffic(traffic),
      m_needed_reach((std::max)(least_needed_reach, 2 * neighbor_radius)),
      m_reach(m_needed_reach + away_from_part + most_moved + Boundary_2::longest_step)
  {}

  /// Starts with bubbles of this rank only. `width`: that of the paper, or 0 for each bubble's own; `expected`: about
  /// so many bubbles will be added
  void start(const Bubbles_2& bubbles, const Hilbert_partition_2& partition, double width = 0, std::size_t expected = 0)
  {
    m_bubbles = &bubbles;
    m_partition = &partition;
    m_clearance.emplace(partition, m_comm.rank());
    m_width = width;
    m_places.clear();
    m_holders.clear();
    m_near_border.clear();
    m_is_near_border.clear();
    m_has_gone_far = false;
    m_lists = {};
    reserve_each(expected, m_places, m_is_near_border);
  }

  /// a bubble was added after the last
  void add(const Bubbles_2& b, Index i)
  {
    const int owner = this->owner(i);
    m_is_near_border.push_back(0);
    m_places.push_back(Place{b.x[i], b.y[i], b.x[i], b.y[i], 0, 0, 0});
    if (owner == m_comm.rank())
      find_clearance(b, i);
    else {
      m_lists.received[owner].push_back(i);
      note_near_border(i);
    }
    set_limits(b, i);
  }

  /// for each neighbouring rank, the bubbles that it has of ours, and those that we have of it, in one order
  const Shared_lists& lists() const { return m_lists; }
  const Messages<Index>& received() const { return m_lists.received; }

  /// of bubbles that we have of others, and others of ours, by their numbers
  std::unordered_map<std::int64_t, Index> indices_at_border(const Bubbles_2& b) const
  {
    std::unordered_map<std::int64_t, Index> result;
    for (const auto* lists : {&m_lists.sent, &m_lists.received})
      for (const auto& list : *lists)
        for (Index i : list.second)
          result[b.id[i]] = i;
    return result;
  }

  int owner(Index i) const { return m_bubbles->owner[i]; }

  /// whether another rank may have a bubble of ours
  bool is_at_border(Index i) const { return m_is_near_border[i] != 0; }

  /// whether no other rank has to know of a bubble of ours
  bool is_far_from_others(Index i) const { return m_places[i].clearance > 0; }

  /// whether a bubble of ours cannot have come to another rank's part since it was looked after
  bool is_surely_home(const Bubbles_2& b, Index i) const
  {
    const Place& p = m_places[i];
    const double x = b.x[i] - p.x, y = b.y[i] - p.y;
    return x * x + y * y < p.clearance * p.clearance;
  }

  /// whether a bubble has gone so far, or grown so much, that it is to be looked after
  bool is_outgrown_by(const Bubbles_2& b, Index i) const
  {
    const Place& p = m_places[i];
    const double x = b.x[i] - p.x, y = b.y[i] - p.y, square_moved = x * x + y * y;
    if (square_moved > p.most_moved * p.most_moved)
      return true;
    const double left = p.largest_disc - (m_needed_reach + away_from_part) * b.d[i];
    return left < 0 || square_moved > left * left;
  }

  /// Those that are to be looked after: the bubbles that have outgrown their places, which are `outgrown`, and of those
  /// near the border all that have gone a third of the way to this.
  std::vector<Index> almost_outgrown(const Bubbles_2& b, const std::vector<Index>& outgrown) const
  {
    std::vector<Index> result;
    for (Index i : m_near_border) {
      const Place& p = m_places[i];
      if (b.is_gone(i))
        continue;
      if (9 * CGAL::squared_distance(Point(p.x, p.y), b.point(i)) > p.most_moved * p.most_moved ||
          is_outgrown_by(b, i))
        result.push_back(i);
    }
    for (Index i : outgrown)
      if (!m_is_near_border[i] && !b.is_gone(i))
        result.push_back(i);
    return result;
  }

  /// whether a bubble that was looked after may have gone far from its owner's part; until all are distributed anew
  bool has_gone_far() const { return m_has_gone_far; }

  /// whether it may have gone far from its owner's part
  bool is_far_from_home(const Bubbles_2& b, Index i) const
  {
    const Place& p = m_places[i];
    return !is_surely_home(b, i) && length_of(b.x[i] - p.home_x, b.y[i] - p.home_y) > farthest_from_home * b.d[i];
  }

  /// Makes bubbles known to those who need them, and others to those who need them for these. `finder` finds them;
  /// `state(i)` and `add(state, owner)` give away and take in a bubble. Collective.
  template <class State, class Add>
  void look_after(const Bubbles_2& b, std::vector<Index> those, const Neighbor_sets_2& finder,
                  const State& state, const Add& add)
  {
    for (int turn = 0; turn < 2; ++turn) { // who gets to know a bubble knows what it needs
      Messages<Bubble_state_2> out;
      for (Index i : those)
        note_place(b, i);
      for (Index i : those)
        if (is_ours(i))
          tell_of(b, i, finder, state, out);
      for (Index i : those)
        if (!is_ours(i) && m_width == 0) // else it is the same from the other side
          tell_owner(b, i, finder, state, out);
      m_traffic.add(out);
      those.clear();
      deliver(m_comm, out, [&](int owner, const Bubble_state_2& s) {
        those.push_back(static_cast<Index>(b.size()));
        add(s, owner);
      });
    }
  }

  /// whether it is known that nothing within `radius` of a bubble of ours is in other ranks' parts
  bool is_ours_within(const Bubbles_2& b, Index i, double radius) const
  {
    const Place& p = m_places[i];
    return p.clearance > 0 && length_of(b.x[i] - p.x, b.y[i] - p.y) + radius < p.clearance;
  }

  /// gives a bubble of ours to a rank that has not got it
  template <class State>
  void give(Index i, int rank, const State& state, Messages<Bubble_state_2>& out)
  {
    if (rank == m_comm.rank() || !add_once(m_holders[i], rank))
      return;
    m_lists.sent[rank].push_back(i);
    note_near_border(i);
    out[rank].push_back(state(i));
  }

private:
  /// The control of the population looks so far; and neighbours of neighbours count.
  static constexpr double least_needed_reach = 3.5;

  /// Where a bubble was when it was last looked after, and when it was in its owner's part then; how far it was from
  /// other ranks' parts, if it is known to be as far as this; and how far it may go, and its disc reach.
  struct Place
  {
    double x, y, home_x, home_y, clearance, most_moved, largest_disc;
  };

  /// how far away the ranks are that get to know a bubble of ours
  double reach_of(const Bubbles_2& b, Index i) const { return m_width > 0 ? m_width : m_reach * b.d[i]; }

  void find_clearance(const Bubbles_2& b, Index i)
  {
    m_places[i].clearance = (*m_clearance)(b.x[i], b.y[i], reach_of(b, i));
    if (m_places[i].clearance == 0)
      note_near_border(i);
  }

  void note_near_border(Index i)
  {
    if (!m_is_near_border[i])
      m_near_border.push_back(i);
    m_is_near_border[i] = 1;
  }

  void set_limits(const Bubbles_2& b, Index i)
  {
    Place& p = m_places[i];
    // one of others that far away is so large that it has as much of a margin in its own size
    p.most_moved = most_moved * (std::max)(b.d[i], p.clearance / (m_reach + most_moved));
    p.largest_disc = (std::max)(p.clearance, m_reach * b.d[i]);
  }

  void note_place(const Bubbles_2& b, Index i)
  {
    Place& p = m_places[i];
    p.x = b.x[i];
    p.y = b.y[i];
    if (is_ours(i))
      find_clearance(b, i);
    if (p.clearance > 0 || m_partition->owner(p.x, p.y) == owner(i)) {
      p.home_x = p.x;
      p.home_y = p.y;
    }
    m_has_gone_far = m_has_gone_far || is_far_from_home(b, i);
    set_limits(b, i);
  }

  bool is_ours(Index i) const { return owner(i) == m_comm.rank(); }

  /// tells of a bubble of ours all ranks near it, and the owners of larger ones that reach it
  template <class State>
  void tell_of(const Bubbles_2& b, Index i, const Neighbor_sets_2& finder, const State& state,
               Messages<Bubble_state_2>& out)
  {
    const double clearance = m_places[i].clearance;
    if (clearance == 0)
      for (int rank : m_partition->owners_in_disc(b.x[i], b.y[i], reach_of(b, i)))
        give(i, rank, state, out);
    if (m_width > 0 || is_known_to_all_around(i))
      return;
    finder.find_large(b.x[i], b.y[i], (std::max)(b.d[i], clearance / m_reach), m_reach, [&](Index j) {
      if (!is_ours(j) && is_reached_by(b, j, i))
        give(i, owner(j), state, out);
    });
  }

  /// whether all ranks of which we have bubbles have this one of ours
  bool is_known_to_all_around(Index i) const
  {
    const auto holders = m_holders.find(i);
    return std::all_of(received().begin(), received().end(), [&](const Messages<Index>::value_type& list) {
      return holders != m_holders.end() && is_among(holders->second, list.first);
    });
  }

  /// tells the owner of another's bubble of ours that this one reaches
  template <class State>
  void tell_owner(const Bubbles_2& b, Index i, const Neighbor_sets_2& finder, const State& state,
                  Messages<Bubble_state_2>& out)
  {
    finder.find_within(b.x[i], b.y[i], b.d[i], m_reach, [&](Index j) {
      if (is_ours(j) && is_reached_by(b, i, j))
        give(j, owner(i), state, out);
    });
  }

  bool is_reached_by(const Bubbles_2& b, Index i, Index j) const
  {
    const double far = m_reach * b.d[i];
    return CGAL::squared_distance(b.point(i), b.point(j)) < far * far;
  }

  Communicator& m_comm;
  Traffic_2& m_traffic;
  const Bubbles_2* m_bubbles = nullptr;
  const Hilbert_partition_2* m_partition = nullptr;
  std::optional<Clearance_2> m_clearance;
  double m_needed_reach, m_reach; // in sizes
  double m_width = 0;             // of all, or 0
  std::vector<Place> m_places;
  std::unordered_map<Index, Hilbert_partition_2::Ranks> m_holders; // other ranks that have a bubble of ours
  std::vector<Index> m_near_border;   // others', and ours that others have or whose disc met another part once
  std::vector<char> m_is_near_border; // the same, of each bubble
  bool m_has_gone_far = false;
  Shared_lists m_lists;
};

/// where a bubble is that asks for others around it, by its reference, and as how large
struct Wide_hole_side_2
{
  double x, y, d;
};

/// Those of our bubbles among `touched` that lie beside wide holes, by the other ranks that may own bubbles across:
/// those are farther away than others ever look.
inline Messages<Wide_hole_side_2> wide_hole_sides(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                                                  const std::vector<Index>& touched, const Halo_2& halo,
                                                  const Hilbert_partition_2& partition, int our_rank)
{
  using Triangulation = Local_triangulation_2;
  constexpr double largest_ratio = 4;
  Messages<Wide_hole_side_2> asked;
  for (Index i : touched) {
    // one that is asked for, and not known anyway, is not much larger; it may have left the part of its owner
    const double size = neighbors.reference_d(i);
    const double most = (0.5 * neighbors.radius() * (Triangulation::far + largest_ratio) +
                         largest_ratio * Halo_2::away_from_part) * size;
    if (!bubbles.is_ours(i) || bubbles.is_gone(i) || halo.is_ours_within(bubbles, i, most) ||
        !Triangulation::is_beside_wide_hole(bubbles, neighbors, i))
      continue;
    const Wide_hole_side_2 side{neighbors.reference_x(i), neighbors.reference_y(i), Triangulation::far * size};
    for (int rank : partition.owners_in_disc(side.x, side.y, most))
      if (rank != our_rank)
        asked[rank].push_back(side);
  }
  return asked;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_SIMULATION_HALO_2_H
