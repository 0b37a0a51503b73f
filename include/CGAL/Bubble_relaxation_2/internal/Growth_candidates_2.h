// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_CANDIDATES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_CANDIDATES_2_H

#include <CGAL/Bubble_relaxation_2/internal/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Growth_proposals_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The proposals of a generation, those that fit best first, and which of them become bubbles: those that the
/// crystal leaves room for and that no better one has taken it from.
template <class Concurrency_tag>
class Growth_candidates_2
{
public:
  explicit Growth_candidates_2(const Domain_2& domain) : m_domain(domain) {}

  /// starts with the proposals of another generation
  void assign(const std::vector<Growth_proposal_2>& proposals, const Crystal_2<Concurrency_tag>& crystal)
  {
    m_sorted.clear();
    for (std::size_t k = 0; k < proposals.size(); ++k)
      m_sorted.push_back(Candidate{proposals[k].misfit, proposals[k].x, proposals[k].y, static_cast<Index>(k)});
    std::sort(m_sorted.begin(), m_sorted.end());
    find_rivals(proposals, crystal);
    m_is_accepted.assign(proposals.size(), 0);
  }

  /// decides on those for which `is_ours(proposal)` holds; what is decided of others stays
  template <class Is_ours>
  void decide(const Is_ours& is_ours)
  {
    for (std::size_t k = 0; k < m_sorted.size(); ++k) {
      const Index p = m_sorted[k].proposal;
      if (is_ours(p))
        m_is_accepted[p] = m_has_room[k] && std::none_of(m_rivals[k].begin(), m_rivals[k].end(), [this](Index r) {
          return m_is_accepted[r] != 0;
        });
    }
  }

  bool is_accepted(std::size_t proposal) const { return m_is_accepted[proposal] != 0; }
  void set_accepted(std::size_t proposal, bool value) { m_is_accepted[proposal] = value; }

  /// calls `visit(proposal)` for all accepted, the best first
  template <class Visitor>
  void for_each_accepted(const Visitor& visit) const
  {
    for (const Candidate& c : m_sorted)
      if (m_is_accepted[c.proposal])
        visit(c.proposal);
  }

private:
  using Rivals = boost::container::small_vector<Index, 6>;

  struct Candidate
  {
    double misfit, x, y;
    Index proposal;

    bool operator<(const Candidate& c) const
    {
      return std::tie(misfit, x, y) < std::tie(c.misfit, c.x, c.y);
    }
  };

  /// of each candidate: whether the crystal leaves room for it, and which better ones stand in its way
  void find_rivals(const std::vector<Growth_proposal_2>& proposals, const Crystal_2<Concurrency_tag>& crystal)
  {
    const std::size_t n = m_sorted.size();
    m_has_room.resize(n);
    m_rivals.resize((std::max)(m_rivals.size(), n));
    const auto proposal = [&](std::size_t k) -> const Growth_proposal_2& { return proposals[m_sorted[k].proposal]; };
    parallel_for<Concurrency_tag>(
      n, [&](std::size_t k) { m_has_room[k] = crystal.is_free(proposal(k).x, proposal(k).y, proposal(k).d); },
      crystal.grain);
    Bubble_buckets_2 near(Surroundings_2::least_distance, crystal.bubbles().d[0], m_domain.bbox().xmin(),
                          m_domain.bbox().ymin(), n);
    for (std::size_t k = 0; k < n; ++k)
      if (m_has_room[k])
        near.insert(static_cast<Index>(k), proposal(k).x, proposal(k).y, proposal(k).d);
    parallel_for<Concurrency_tag>(
      n,
      [&](std::size_t k) {
        m_rivals[k].clear();
        if (m_has_room[k])
          near.for_each_near(proposal(k).x, proposal(k).y, proposal(k).d, [&](Index r, double, double) {
            if (static_cast<std::size_t>(r) < k)
              m_rivals[k].push_back(m_sorted[r].proposal);
            return true;
          });
      },
      crystal.grain);
  }

  const Domain_2& m_domain;
  std::vector<Candidate> m_sorted;
  std::vector<char> m_has_room;    // in their order, like the next
  std::vector<Rivals> m_rivals;    // proposals
  std::vector<char> m_is_accepted; // of each proposal
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_CANDIDATES_2_H
