// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHOICE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHOICE_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Defect_surgery_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The triangles that an operation wants to change.
struct Patch_claim_2
{
  Bad_triangle_2 bad;                          ///< the one it is for, which tells who comes first
  std::vector<std::array<Index, 3>> triangles; ///< their vertices
};

/// Chooses among the claims of all ranks those that are worth it, the first ones first, and none that shares a
/// triangle with one chosen before. The owners of the triangles' first vertices compare the claims.
class Patch_choice_2
{
public:
  Patch_choice_2(const Communicator& comm, Sparse_exchange& exchange, const std::vector<Patch_claim_2>& claims,
                 const Bubbles_2& known)
    : m_comm(comm), m_exchange(exchange), m_states(claims.size(), UNDECIDED)
  {
    find_rivals(claims, known);
  }

  /// Collective. `is_worth_it(k)` is asked only of claims that no other one is in the way of, in whatever order.
  template <class Predicate>
  void operator()(const Predicate& is_worth_it, Agreement& agreement)
  {
    for (bool is_open = true; is_open; is_open = m_comm.any(is_open)) {
      take_states();
      agreement.reach_after([&] {
        for (std::size_t k = 0; k < m_states.size(); ++k)
          decide(k, is_worth_it);
      });
      is_open = std::find(m_states.begin(), m_states.end(), UNDECIDED) != m_states.end();
    }
  }

  bool is_chosen(std::size_t k) const { return m_states[k] == CHOSEN; }

private:
  enum State : char { UNDECIDED, CHOSEN, REFUSED };

  using Name = std::pair<std::int32_t, std::int32_t>; // rank and claim

  struct Claimed
  {
    std::array<std::int64_t, 3> triangle; // numbers of its vertices, in order
    Bad_triangle_2 bad;
    std::int32_t rank, claim;

    bool operator<(const Claimed& c) const { return std::tie(triangle, bad) < std::tie(c.triangle, c.bad); }
  };

  /// a claim, and one that comes before it and shares a triangle
  struct Rivalry
  {
    std::int32_t claim, rival_rank, rival;
  };

  /// if all claims before it are decided
  template <class Predicate>
  void decide(std::size_t k, const Predicate& is_worth_it)
  {
    bool may_be_chosen = true;
    for (const Name& name : m_rivals[k]) {
      const char state = name.first == m_comm.rank() ? m_states[name.second] : m_rival_states.at(name);
      if (state == CHOSEN)
        m_states[k] = REFUSED;
      may_be_chosen = may_be_chosen && state == REFUSED;
    }
    if (m_states[k] == UNDECIDED && may_be_chosen)
      m_states[k] = is_worth_it(k) ? CHOSEN : REFUSED;
  }

  void find_rivals(const std::vector<Patch_claim_2>& claims, const Bubbles_2& known)
  {
    Messages<Claimed> out;
    for (std::size_t k = 0; k < claims.size(); ++k)
      for (const std::array<Index, 3>& t : claims[k].triangles) {
        Claimed claimed{{known.id[t[0]], known.id[t[1]], known.id[t[2]]},
                        claims[k].bad, m_comm.rank(), static_cast<std::int32_t>(k)};
        std::sort(claimed.triangle.begin(), claimed.triangle.end());
        out[known.owner[*std::min_element(t.begin(), t.end())]].push_back(claimed);
      }
    std::vector<Claimed> claimed;
    for (const auto& message : m_exchange(out))
      claimed.insert(claimed.end(), message.second.begin(), message.second.end());
    std::sort(claimed.begin(), claimed.end());
    Messages<Rivalry> rivalries;
    for (std::size_t first = 0, k = 0; k < claimed.size(); ++k) {
      if (claimed[k].triangle != claimed[first].triangle)
        first = k;
      for (std::size_t r = first; r < k; ++r)
        rivalries[claimed[k].rank].push_back(Rivalry{claimed[k].claim, claimed[r].rank, claimed[r].claim});
    }
    m_rivals.resize(claims.size());
    for (const auto& message : m_exchange(rivalries))
      for (const Rivalry& r : message.second)
        m_rivals[r.claim].emplace_back(r.rival_rank, r.rival);
    for (std::vector<Name>& rivals : m_rivals) {
      std::sort(rivals.begin(), rivals.end());
      rivals.erase(std::unique(rivals.begin(), rivals.end()), rivals.end());
      for (const Name& name : rivals)
        if (name.first != m_comm.rank())
          m_rival_states[name] = UNDECIDED;
    }
    Messages<std::int32_t> questions;
    for (const auto& rival : m_rival_states)
      questions[rival.first.first].push_back(rival.first.second);
    m_asked = m_exchange(questions);
  }

  /// asks the other ranks what became of rivals
  void take_states()
  {
    Messages<char> out, in;
    for (const auto& message : m_asked)
      for (std::int32_t k : message.second)
        out[message.first].push_back(m_states[k]);
    for (const auto& rival : m_rival_states)
      in[rival.first.first].push_back(UNDECIDED);
    exchange_known(m_comm, out, in);
    std::map<int, std::size_t> next; // answers come in the order of the questions
    for (auto& rival : m_rival_states)
      rival.second = in[rival.first.first][next[rival.first.first]++];
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  std::vector<char> m_states;              // of own claims
  std::vector<std::vector<Name>> m_rivals; // of each claim those that come before it
  std::map<Name, char> m_rival_states;     // of other ranks
  Messages<std::int32_t> m_asked;          // claims of this rank that others ask for
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHOICE_2_H
