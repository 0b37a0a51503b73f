// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hole_choice_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_limits_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_proposals_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Fills the faces of a domain with a crystal: each bubble of a front proposes the six places around it for
/// neighbours at the wanted distance, aligned with the lattice around it.
///
/// Who proposes first matters where d changes. A crystal that grows from fine to coarse loses rows where
/// it must; one that grows from coarse to fine has no room for new ones and tears. So the smallest bubble
/// is the next, but where d falls away from the start the front goes on in rows: a bubble counts as no
/// smaller than the one that proposed it.
///
/// The crystal grows by generations: all of about the smallest size propose at once, by what was there
/// before; of proposals for one place the one that fits best is accepted; then the new bubbles settle
/// among each other. Nothing depends on an order within a generation, so threads change no bit.
class Crystal_growth_2
{
public:
  /// `directions`: angles of the lattice for the bubbles that are there, or for some; read for those in faces only;
  /// `turns`: when they propose, see `turns_of()`; `expected`: how many will come
  Crystal_growth_2(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles,
                   const std::vector<double>& directions, std::vector<char> turns, std::size_t expected,
                   Lattice_direction lattice, Team& team, const Threads& threads)
    : m_domain(domain), m_sizing(sizing), m_team(team), m_threads(threads),
      m_crystal(domain, bubbles, std::move(turns), threads), m_front(domain),
      m_propose(domain, sizing, m_crystal, m_front, lattice, team, threads)
  {
    m_expected = bubbles.size() + expected;
    m_crystal.make_room_for(expected);
    for (std::size_t i = 0; i < directions.size(); ++i)
      m_crystal.direction(i) = Direction{cosine_of(directions[i]), sine_of(directions[i])};
    team.start_growth(m_crystal, expected);
    m_crystal.link_from(0);
  }

  /// grows from the bubbles that were there before and whose turn it is, until there is no front left
  void operator()(char turn)
  {
    for (std::size_t i = 0, n = m_crystal.size(); i < n; ++i) {
      tick(i);
      if (m_crystal.turn(i) == turn)
        add_to_front(i, m_crystal.bubbles().d[i]);
    }
    for (;;) {
      tell_progress();
      add_late();
      const double smallest = m_team.start_generation(m_front.smallest_key());
      if (smallest == std::numeric_limits<double>::infinity())
        return;
      m_front.take_generation(smallest, m_generation);
      m_team.take(m_generation);
      m_proposals.clear();
      m_propose(m_generation, m_proposals);
      const std::size_t number_of_ours = m_proposals.size();
      m_team.share_proposals(m_proposals);
      choose(number_of_ours);
      const std::size_t first = m_crystal.size();
      accept();
      m_crystal.link_from(first);
      settle_from(first);
      add_to_front_from(first);
    }
  }

private:
  static constexpr int settling_rounds = 3;

  /// Which share is there is told of the growth that fills the domain, not of those of a few large bubbles before it.
  void tell_progress() const
  {
    constexpr std::size_t few = 2000;
    if (m_expected > few && progress_of_thread != nullptr)
      progress_of_thread->tick_share((std::min)(1., double(m_crystal.size()) / double(m_expected)));
    else
      tick();
  }

  void add_to_front(std::size_t i, double key)
  {
    m_front.add(m_crystal.bubbles(), i, key, m_crystal.direction(i));
    m_team.enter_front(m_crystal, static_cast<Index>(i), key);
  }

  /// the bubbles from `first` on, which are `m_new`
  void add_to_front_from(std::size_t first)
  {
    for (std::size_t k = 0; k < m_new.size(); ++k)
      if (m_new[k].key > 0) // else it has left the front
        add_to_front(first + k, (std::max)(m_new[k].key, m_crystal.bubbles().d[first + k]));
  }

  void add_late()
  {
    const std::size_t first = m_crystal.size();
    m_new.clear();
    m_team.catch_up(m_crystal, m_new);
    m_crystal.link_from(first);
    add_to_front_from(first);
  }

  /// of proposals too near to each other the one that fits best is to be accepted
  void choose(std::size_t number_of_ours)
  {
    m_holes.clear();
    for (const Growth_proposal_2& p : m_proposals)
      m_holes.push_back(Hole_2{p.misfit, p.x, p.y, p.d, p.triangle, {p.key, p.direction.x, p.direction.y}});
    m_choice(m_holes, number_of_ours, Growth_limits_2::least_distance, m_team, m_threads,
             [this](const Hole_2& p) { return m_crystal.is_free(p.x, p.y, p.d); });
  }

  void accept()
  {
    m_new.clear();
    m_choice.for_each_chosen([this](Index k) { m_new.push_back(m_proposals[k]); });
    m_team.forget_far(m_new);
    for (const Growth_proposal_2& p : m_new)
      m_crystal.add(Point(p.x, p.y), p.d, p.triangle, p.direction);
    m_team.complete(m_crystal, m_new);
  }

  /// the bubbles from `first` on settle among each other
  void settle_from(std::size_t first)
  {
    const auto for_all_new = [this](const auto& f) { // not for those that were there before
      parallel_for(
        m_threads, m_new.size(),
        [this, &f](std::size_t k) {
          if (m_new[k].from != no_index)
            f(k);
        },
        m_crystal.grain);
    };
    m_settled.resize((std::max)(m_settled.size(), m_new.size()));
    for (int round = 0; round < settling_rounds; ++round) {
      for_all_new([this, first](std::size_t k) {
        if (m_team.owns(static_cast<Index>(first + k)))
          m_settled[k] = m_crystal.settled(first + k);
      });
      m_team.share_settled(m_settled);
      for_all_new([this, first](std::size_t k) { m_crystal.set_point(first + k, m_settled[k]); });
    }
    for_all_new([this, first](std::size_t k) { m_crystal.finish(m_domain, m_sizing, first + k); });
    m_crystal.find_again_from(first);
  }

  const Domain_2& m_domain;
  const Sizes_2& m_sizing;
  Team& m_team;
  const Threads m_threads;
  std::size_t m_expected = 0; // number of bubbles when all are there
  Crystal_2 m_crystal;
  Growth_front_2 m_front;
  Growth_proposals_2 m_propose;
  Hole_choice_2 m_choice;
  // of the present generation
  std::vector<Growth_proposer> m_generation;
  std::vector<Growth_proposal_2> m_proposals;
  std::vector<Hole_2> m_holes;          // where they are
  std::vector<Growth_proposal_2> m_new; // bubbles
  std::vector<Point> m_settled;         // where they go
};

/// When bubbles that are there propose: 1 for those that are the first, 2 for the others, and 0 for never: of those that
/// are crowded on an outline far finer than d few are enough.
template <class Is_first>
std::vector<char> turns_of(const Domain_2& domain, const Bubbles_2& b, const Is_first& is_first)
{
  constexpr double crowded = 0.3; // distance, in units of d
  Bubble_buckets_2 speakers(crowded, b.d[0], domain.bbox().xmin(), domain.bbox().ymin(), 0);
  std::vector<char> turns(b.size(), 0);
  for (char turn : {char(1), char(2)})
    for (std::size_t i = 0; i < b.size(); ++i) {
      tick(i);
      if (is_first(i) != (turn == 1))
        continue;
      if (!b.is_in_face(i)) {
        if (!speakers.is_free(b.x[i], b.y[i], b.d[i]))
          continue;
        speakers.insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
      }
      turns[i] = turn;
    }
  return turns;
}

/// keeps the values of some bubbles, if there are any
template <class T>
void select(const std::vector<Index>& bubbles, std::vector<T>& values)
{
  std::vector<T> selected;
  for (Index i : bubbles)
    if (static_cast<std::size_t>(i) < values.size())
      selected.push_back(values[i]);
  values = std::move(selected);
}

/// Grows a crystal from the bubbles that are there, in their turns; the other arguments as for `Crystal_growth_2`.
inline void grow_in_turns(const Domain_2& domain, const Sizes_2& sizing, std::vector<double> directions,
                          std::vector<char> turns, Lattice_direction lattice, Bubbles_2& bubbles, Team& team,
                          const Threads& threads)
{
  const std::size_t expected = team.part_of((std::max)(0., sizing.expected_number - double(bubbles.size())));
  if (!team.is_alone()) {
    const std::vector<Index> near = team.keep_near(bubbles);
    bubbles.select(near);
    select(near, directions);
    select(near, turns);
  }
  Crystal_growth_2 grow(domain, sizing, bubbles, directions, std::move(turns), expected, lattice, team, threads);
  for (char turn : {char(1), char(2)})
    grow(turn);
}

/// The ways to fill the faces.
enum class Growth { FROM_ALL, SINGLE_STRAIGHT, SINGLE_BENT };

/// Initial bubbles of the faces by fronts that grow from all bubbles that are there: those of the edges
/// aligned with their edge, those of the faces, if there are any, in given directions.
/// `directions`: angles for the bubbles that are there; read for those in faces only
inline void grow_from_all(const Domain_2& domain, const Sizes_2& sizing, const std::vector<double>& directions,
                          Bubbles_2& bubbles, Team& team, const Threads& threads)
{
  std::vector<char> turns = turns_of(domain, bubbles, [](std::size_t) { return true; });
  grow_in_turns(domain, sizing, directions, std::move(turns), Lattice_direction::BENDS, bubbles, team, threads);
}

/// Whether bubbles belong to an edge, as its ends or between.
inline bool touches_edge(const Domain_2& domain, const Bubbles_2& b, std::size_t i, Index e)
{
  if (b.is_on_edge(i))
    return b.host[i] == e;
  const Domain_edge_2& edge = domain.edges()[e];
  return b.is_corner(i) && b.host[i] != no_index &&
         (b.host[i] == edge.source || b.host[i] == edge.target);
}

/// Initial bubbles of the faces as a single crystal as far as possible: it grows from the longest edge
/// and meets the others where they are; what it does not reach is filled from the others then.
inline void grow_single_crystal(const Domain_2& domain, const Sizes_2& sizing, Growth way, Bubbles_2& bubbles,
                                Team& team, const Threads& threads)
{
  const Lattice_direction lattice =
    way == Growth::SINGLE_STRAIGHT ? Lattice_direction::KEEPS : Lattice_direction::BENDS;
  const Index longest = longest_edge(domain);
  std::vector<char> turns =
    turns_of(domain, bubbles, [&](std::size_t i) { return touches_edge(domain, bubbles, i, longest); });
  grow_in_turns(domain, sizing, {}, std::move(turns), lattice, bubbles, team, threads);
}

/// How far bubbles are from a crystal: the share of those in faces that have not six neighbours, times
/// the energy of the springs to them.
inline double disorder(const Domain_2& domain, const Bubbles_2& b)
{
  constexpr double reach = 1.35;
  Bubble_buckets_2 buckets(reach, b.d[0], domain.bbox().xmin(), domain.bbox().ymin(), b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    buckets.insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
  double defects = 0, energy = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!b.is_in_face(i))
      continue;
    int number = 0;
    buckets.for_each_near(b.x[i], b.y[i], b.d[i], [&](Index j, double squared, double d) {
      if (j == static_cast<Index>(i))
        return true;
      ++number;
      const double w = 2 * std::sqrt(squared) / (b.d[i] + d);
      energy += (w - 1) * (w - 1);
      return true;
    });
    defects += number != 6;
  }
  return defects * energy;
}

/// The bubbles that have room when all are `factor` times as large, the first of several.
inline Bubbles_2 enlarge(const Domain_2& domain, const Bubbles_2& b, double factor)
{
  Bubble_buckets_2 buckets(Growth_limits_2::least_distance, factor * b.d[0], domain.bbox().xmin(),
                           domain.bbox().ymin(), b.size());
  Bubbles_2 large;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double d = factor * b.d[i];
    if (!buckets.is_free(b.x[i], b.y[i], d))
      continue;
    buckets.insert(static_cast<Index>(large.size()), b.x[i], b.y[i], d);
    large.add(b, i);
    large.d.back() = d;
  }
  return large;
}

/// Fills the faces in the way that suits the domain and d, and returns which it is. Fronts from all edges
/// are right where d follows the boundary; where d is constant, or smallest inside, they may meet badly,
/// and a single crystal is tried as well.
inline Growth fill_in_better_way(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles,
                                 const Threads& threads)
{
  constexpr double nearly_constant = 1.25, clearly_less = 0.75, better = 0.8;
  Bubbles_2 single = bubbles;
  Team alone;
  grow_from_all(domain, sizing, {}, bubbles, alone, threads);
  const double least_at_start = *std::min_element(single.d.begin(), single.d.end());
  const auto sizes = std::minmax_element(bubbles.d.begin(), bubbles.d.end());
  const bool is_constant = *sizes.second < nearly_constant * *sizes.first;
  if (!is_constant && !(*sizes.first < clearly_less * least_at_start))
    return Growth::FROM_ALL;
  const Growth way = is_constant ? Growth::SINGLE_STRAIGHT : Growth::SINGLE_BENT;
  grow_single_crystal(domain, sizing, way, single, alone, threads);
  if (!(disorder(domain, single) < better * disorder(domain, bubbles)))
    return Growth::FROM_ALL;
  bubbles = std::move(single);
  return way;
}

/// How many times as large bubbles are that tell enough of a domain: 1 if there will be few anyway.
inline double factor_of_large_bubbles(double expected_number)
{
  constexpr double enough = 400;
  double factor = 1;
  while (expected_number >= 4 * factor * factor * enough)
    factor *= 2;
  return factor;
}

/// Whether a crystal that grew from all has far fewer bubbles than d asks for, which are many. That comes of an outline
/// with short edges of a length that is no multiple of d: each row takes over the distances of the one before.
inline bool is_sparse(const Sizes_2& sizing, const Bubbles_2& crystal, const Team& team)
{
  constexpr double least_share = 0.87; // usually it is .93 to 1; less where the outline takes most
  if (factor_of_large_bubbles(sizing.expected_number) == 1)
    return false;
  std::size_t number = 0;
  for (std::size_t i = 0; i < crystal.size(); ++i)
    number += team.owns(static_cast<Index>(i));
  team.add_up(&number, 1);
  return static_cast<double>(number) < least_share * sizing.expected_number;
}

/// Initial bubbles of the faces. What suits a domain is found with large bubbles if there will be many.
/// `sizing`: has `expected_number`
inline void place_frontal(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles, Team& team,
                          const Threads& threads)
{
  const double factor = factor_of_large_bubbles(sizing.expected_number);
  if (factor == 1) {
    fill_in_better_way(domain, sizing, bubbles, threads);
    team.note_common(bubbles);
    return;
  }
  Bubbles_2 large = enlarge(domain, bubbles, factor);
  Growth way = fill_in_better_way(domain, scaled(sizing, factor), large, threads);
  team.divide(domain, large);
  if (way == Growth::FROM_ALL) {
    Bubbles_2 outline = bubbles;
    grow_from_all(domain, sizing, {}, bubbles, team, threads);
    if (!is_sparse(sizing, bubbles, team))
      return;
    way = Growth::SINGLE_BENT;
    bubbles = std::move(outline);
    team.note_common(bubbles);
  }
  grow_single_crystal(domain, sizing, way, bubbles, team, threads);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H
