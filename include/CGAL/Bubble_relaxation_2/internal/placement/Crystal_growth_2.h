// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_GROWTH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_GROWTH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Place_choice_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_proposals_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

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
  /// `directions`: angles of the lattice for the bubbles that are there, or for some; read for those in faces only
  Crystal_growth_2(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles,
                   const std::vector<double>& directions, Lattice_direction lattice, Team& team, const Threads& threads)
    : m_domain(domain), m_sizing(sizing), m_team(team), m_threads(threads), m_crystal(domain, bubbles, threads),
      m_front(domain), m_propose(domain, sizing, m_crystal, m_front, lattice, team, threads)
  {
    const std::size_t expected = team.part_of((std::max)(0., sizing.expected_number - double(bubbles.size())));
    m_crystal.make_room_for(expected);
    for (std::size_t i = 0; i < directions.size(); ++i)
      m_crystal.direction(i) = Direction{std::cos(directions[i]), std::sin(directions[i])};
    team.start_growth(m_crystal, expected);
    m_crystal.link_from(0);
  }

  /// one of the bubbles that were there before belongs to the front when the growth begins
  void add_to_front(std::size_t i) { add_to_front(i, m_crystal.bubbles().d[i]); }

  /// grows until there is no front left
  void operator()()
  {
    for (;;) {
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
    m_places.clear();
    for (const Growth_proposal_2& p : m_proposals)
      m_places.push_back(Hole_2{p.misfit, p.x, p.y, p.d, p.triangle});
    m_choice(m_places, number_of_ours, Surroundings_2::least_distance, m_team, m_threads,
             [this](const Hole_2& p) { return m_crystal.is_free(p.x, p.y, p.d); });
  }

  void accept()
  {
    m_new.clear();
    m_choice.for_each_chosen([this](Index k) { m_new.push_back(m_proposals[k]); });
    m_team.exchange_new(m_new);
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
  Crystal_2 m_crystal;
  Growth_front_2 m_front;
  Growth_proposals_2 m_propose;
  Place_choice_2 m_choice;
  // of the present generation
  std::vector<Growth_proposer> m_generation;
  std::vector<Growth_proposal_2> m_proposals;
  std::vector<Hole_2> m_places;         // theirs
  std::vector<Growth_proposal_2> m_new; // bubbles
  std::vector<Point> m_settled;         // their places
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_GROWTH_2_H
