// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Growth_candidates_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Growth_front_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Growth_proposals_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
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
template <class Concurrency_tag, class Sizing>
class Crystal_growth_2
{
public:
  Crystal_growth_2(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles,
                   Lattice_direction lattice)
    : m_domain(domain), m_sizing(sizing), m_crystal(domain, bubbles), m_front(domain),
      m_propose(domain, sizing, m_crystal, m_front, lattice), m_candidates(domain)
  {}

  void set_direction(std::size_t i, const Direction& u) { m_crystal.direction(i) = u; }

  /// one of the bubbles that were there before belongs to the front when the growth begins
  void add_to_front(std::size_t i) { add_to_front(i, m_crystal.bubbles().d[i]); }

  /// grows until there is no front left
  void operator()()
  {
    const auto all = [](Index) { return true; };
    while (!m_front.empty()) {
      m_front.take_generation(m_front.smallest_key(), m_generation);
      m_proposals.clear();
      m_propose(m_generation, all, m_proposals);
      m_candidates.assign(m_proposals, m_crystal);
      m_candidates.decide(all);
      const std::size_t first = m_crystal.size();
      accept();
      m_crystal.link_from(first);
      settle_from(first);
      for (std::size_t i = first; i < m_crystal.size(); ++i)
        add_to_front(i, (std::max)(m_keys[i - first], m_crystal.bubbles().d[i]));
    }
  }

private:
  static constexpr int settling_rounds = 3;

  void add_to_front(std::size_t i, double key) { m_front.add(m_crystal.bubbles(), i, key, m_crystal.direction(i)); }

  void accept()
  {
    m_keys.clear();
    m_candidates.for_each_accepted([this](Index k) {
      const Growth_proposal_2& p = m_proposals[k];
      m_crystal.add(Point(p.x, p.y), p.d, p.triangle, p.direction);
      m_keys.push_back(p.key);
    });
  }

  /// the bubbles from `first` on settle among each other
  void settle_from(std::size_t first)
  {
    const std::size_t n = m_crystal.size() - first;
    m_settled.resize((std::max)(m_settled.size(), n));
    for (int round = 0; round < settling_rounds; ++round) {
      parallel_for<Concurrency_tag>(
        n, [this, first](std::size_t k) { m_settled[k] = m_crystal.settled(first + k); }, m_crystal.grain);
      parallel_for<Concurrency_tag>(
        n, [this, first](std::size_t k) { m_crystal.set_point(first + k, m_settled[k]); }, m_crystal.grain);
    }
    parallel_for<Concurrency_tag>(
      n, [this, first](std::size_t k) { m_crystal.finish(m_domain, m_sizing, first + k); }, m_crystal.grain);
    m_crystal.find_again_from(first);
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
  Crystal_2<Concurrency_tag> m_crystal;
  Growth_front_2 m_front;
  Growth_proposals_2<Concurrency_tag, Sizing> m_propose;
  Growth_candidates_2<Concurrency_tag> m_candidates;
  // of the present generation
  std::vector<Proposer> m_generation;
  std::vector<Growth_proposal_2> m_proposals;
  std::vector<double> m_keys;   // of those that proposed the new bubbles
  std::vector<Point> m_settled; // the new bubbles' places
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H
