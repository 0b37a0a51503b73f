// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_TEAM_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_TEAM_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace CGAL {

template <class FT_>
struct Bubble_relaxation_report_2;

namespace Bubble_relaxation_2 {
namespace internal {

class Crystal_2;
class Domain_2;
class Editable_triangulation_2;
class Neighbor_sets_2;
class Simulation_2;
struct Growth_proposal_2;
struct Bubble_mesh_2;
struct Growth_proposer;

/// what the stages tell of what they did, for the user
using Report = Bubble_relaxation_report_2<double>;

/// a place for a bubble
struct Hole_2
{
  double rank; ///< the one with the least is the best
  double x, y, d;
  Index triangle; ///< of the domain
  std::array<double, 3> among_equals{}; ///< the order of such that are equal in all that comes before

  bool operator<(const Hole_2& h) const
  {
    return std::tie(rank, x, y, among_equals) < std::tie(h.rank, h.x, h.y, h.among_equals);
  }
};

/// what all ranks together have to know after a step
struct Step_sums
{
  std::size_t restless = 0; ///< bubbles that moved more than the tolerance
  std::size_t far = 0;      ///< bubbles that wanted to move so far that steps may be too long
  std::size_t outrun = 0;   ///< bubbles that have used up their skin
};

/// how much of a disc belongs to a rank
enum class Share_of_disc { NONE, SOME, ALL };

/// The contract between the stages and the ranks that go through them together, each with its own part of the domain:
/// what a stage asks for, or tells, wherever that is more than what this rank has. A program without ranks is a team of
/// one, for whom all this is nothing to do; so a stage has one flow of control, whoever runs it. Ranks override what
/// concerns the stage at hand, and all of them call the same members in the same order.
class Team
{
public:
  virtual ~Team() = default;

  /// \name All Stages
  /// @{

  virtual bool is_alone() const { return true; }

  /// whether it holds on any rank
  virtual bool any(bool here) const { return here; }

  /// does what may fail on one rank, and then fails on all
  virtual void agree_after(const std::function<void()>& f) { f(); }

  virtual double smallest(double value) const { return value; } ///< of all ranks
  virtual double largest(double value) const { return value; }  ///< of all ranks

  /// how many all lower ranks have, of whatever this one has so many
  virtual std::size_t number_before(std::size_t /* here */) const { return 0; }

  /// whether a bubble that comes in there belongs to this rank
  virtual bool owns_place(const Point&) const { return true; }

  /// Keeps the holes at places of ours, adds those that others found there, and after these those of others that
  /// are nearer than `reach` times the mean size; returns how many are ours.
  virtual std::size_t share_holes(std::vector<Hole_2>& holes, double /* reach */) { return holes.size(); }

  /// puts in what others decided on their holes, or on places that they propose
  virtual void share_choice(std::vector<char>& /* states */) {}

  /// Puts in the values of bubbles that others own.
  virtual void share(std::vector<char>&) {}
  virtual void share(std::vector<double>&) {} ///< the same

  /// @}
  /// \name Placement
  /// @{

  virtual Share_of_disc share_of(const Point&, double /* radius */) const { return Share_of_disc::ALL; }

  /// All ranks have these bubbles, and more will come; those that have come are forgotten.
  virtual void note_common(const Bubbles_2&) {}

  /// divides the domain by bubbles that are some times as large, which all ranks have
  virtual void divide(const Domain_2&, const Bubbles_2& /* large */) {}

  /// how many of so many bubbles come to this rank, about
  virtual std::size_t part_of(double number) const { return static_cast<std::size_t>(number); }

  /// Brings the bubbles after the common ones, which are there before the growth begins, and the directions of their
  /// lattices to where they are needed.
  virtual void share_seeds(Bubbles_2&, std::vector<double>& /* directions */) {}

  /// Those of the bubbles that matter in this rank's part, by their indices; the others will be forgotten. A team of one is
  /// not asked.
  virtual std::vector<Index> keep_near(const Bubbles_2&) { return {}; }

  /// The crystal has its first bubbles, which were common or given to the team; so many will come.
  virtual void start_growth(Crystal_2&, std::size_t /* expected */) {}

  /// adds bubbles that this rank has to know of, though they are not new
  virtual void catch_up(Crystal_2&, std::vector<Growth_proposal_2>&) {}

  /// The smallest key of all fronts; with it the next generation begins.
  virtual double start_generation(double key) { return key; }

  /// a generation leaves the front
  virtual void take(const std::vector<Growth_proposer>&) {}

  /// whether this rank says what becomes of a bubble of the crystal
  virtual bool owns(Index) const { return true; }

  /// adds what others propose and might be in the way of ours
  virtual void share_proposals(std::vector<Growth_proposal_2>&) {}

  /// keeps of the new bubbles those that this rank has to know
  virtual void forget_far(std::vector<Growth_proposal_2>&) const {}

  /// adds bubbles of others, older ones too, that the new ones need around them
  virtual void complete(Crystal_2&, std::vector<Growth_proposal_2>&) {}

  /// puts in the places of new bubbles that others own
  virtual void share_settled(std::vector<Point>&) {}

  /// a bubble becomes one of the front
  virtual void enter_front(const Crystal_2&, Index, double /* key */) {}

  /// @}
  /// \name Simulation
  /// @{

  /// looks for the bubbles of other ranks around ours before the first step
  virtual void look_for_ghosts(Simulation_2&, Bubbles_2&) {}

  /// whether no rank wants to stop
  virtual bool goes_on(bool here) const { return here; }

  /// whether bubbles have gone so far that those of other ranks around them are to be looked for anew
  virtual bool is_outgrown() const { return false; }
  virtual void look_for_ghosts_anew(Simulation_2&, Bubbles_2&) {} ///< looks for them

  virtual std::size_t number_of_all(const Bubbles_2& bubbles) const { return bubbles.size(); } ///< of all ranks

  /// completes the neighbour sets of bubbles that other ranks own
  virtual void share_sets(const Bubbles_2&, Neighbor_sets_2&) {}

  /// begins to tell other ranks where bubbles are within a step
  virtual void send_positions(const std::vector<double>& /* x */, const std::vector<double>& /* y */) {}

  /// puts in where theirs are
  virtual void receive_positions(std::vector<double>& /* x */, std::vector<double>& /* y */) {}

  /// whether another rank has to know where a bubble is
  virtual bool is_at_border(Index) const { return false; }

  /// begins to tell other ranks of the bubbles at the border that were active, and whether they move
  virtual void send_moves(const Bubbles_2&, const std::vector<Index>& /* active */,
                          const std::vector<char>& /* is_moving */)
  {}

  /// takes over what others told: returns their bubbles that were active, and adds whether they move
  virtual const std::vector<Index>& receive_moves(Bubbles_2&, const std::vector<Index>& /* active */,
                                                  std::vector<char>& /* is_moving */)
  {
    return m_none;
  }

  /// over all ranks
  virtual Step_sums sum(const Step_sums& sums) { return sums; }

  /// after the last step of a round
  virtual void end_steps(Simulation_2&, Bubbles_2&) {}

  /// looks for bubbles of other ranks on the other side of holes that are wider than all is known
  virtual void look_across_holes(Simulation_2&, Bubbles_2&) {}

  /// tells other ranks of the bubbles from `first` on, which are new, and adds those of others
  virtual void share_new(Simulation_2&, Bubbles_2&, Index /* first */) {}

  /// @}
  /// \name Population
  /// @{

  /// adds bubbles of others that may have moved
  virtual std::vector<Index> share_touched(const Bubbles_2&, std::vector<Index> touched) { return touched; }

  /// adds triangles that others found around bubbles of ours; what we do not know of their corners is `no_index`
  virtual void share_triangles(const Bubbles_2&, std::vector<std::array<Index, 3>>&) {}

  /// gives new bubbles their numbers
  virtual void number(Bubbles_2&) {}

  /// @}
  /// \name Treatment
  /// @{

  /// tells other ranks of vertices that were moved, and moves theirs
  virtual void share_moved(Bubble_mesh_2&, const std::vector<Index>& /* moved */) {}

  /// Makes the mesh around the vertices of other ranks what it is after their moves. Returns whether it had to be made
  /// anew for that, with other indices also of the vertices that were moved in this sweep, and in any.
  virtual bool restore_border(Editable_triangulation_2&, std::vector<Index>& /* moved */,
                              std::vector<char>& /* was_moved */)
  {
    return false;
  }

  /// adds the neighbours of vertices that other ranks moved in this sweep
  virtual void add_neighbors_of_others(const Editable_triangulation_2&, std::vector<Index>&) {}

  /// @}
  /// \name Statistics
  /// @{

  /// adds up counts of all ranks, so many
  virtual void add_up(std::size_t* /* counts */, std::size_t) const {}
  virtual void add_up(std::uint64_t& /* sum */) const {} ///< the same, of more than a count may be

  /// @}

private:
  const std::vector<Index> m_none{};
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_TEAM_H
