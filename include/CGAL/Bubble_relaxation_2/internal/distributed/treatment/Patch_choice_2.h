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
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
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
    : m_comm(comm), m_exchange(exchange)
  {
    add_candidates(claims.size(), find_rivals(claims, known));
  }

  /// Collective. `is_worth_it(k)` is asked only of claims that no other one is in the way of, in whatever order.
  template <class Predicate>
  void operator()(const Predicate& is_worth_it, Agreement& agreement)
  {
    const auto decide = [&] {
      bool is_open = false;
      agreement.reach_after([&] { is_open = m_choice.decide(is_worth_it); });
      return is_open;
    };
    decide_together(m_comm, decide, [this] { share_values(m_comm, m_sent, m_received, m_choice.states()); });
  }

private:
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

  /// tells the ranks that claim triangles who comes before
  Messages<Rivalry> find_rivals(const std::vector<Patch_claim_2>& claims, const Bubbles_2& known)
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
    return m_exchange(rivalries);
  }

  /// the claims of this rank, and after them those of others that come before one of them
  void add_candidates(std::size_t n, const Messages<Rivalry>& rivalries)
  {
    std::map<Name, Index> others;
    for (const auto& message : rivalries)
      for (const Rivalry& r : message.second)
        if (r.rival_rank != m_comm.rank())
          others[{r.rival_rank, r.rival}] = no_index;
    Messages<std::int32_t> questions;
    Index next = static_cast<Index>(n);
    for (auto& other : others) {
      other.second = next++;
      questions[other.first.first].push_back(other.first.second);
      m_received[other.first.first].push_back(other.second);
    }
    m_sent = m_exchange(questions);
    m_choice.start(static_cast<std::size_t>(next));
    for (std::size_t k = 0; k < n; ++k)
      m_choice.add(static_cast<Index>(k));
    for (const auto& message : rivalries)
      for (const Rivalry& r : message.second)
        m_choice.rivals(static_cast<std::size_t>(r.claim))
          .push_back(r.rival_rank == m_comm.rank() ? r.rival : others.at({r.rival_rank, r.rival}));
  }

  const Communicator& m_comm;
  Sparse_exchange& m_exchange;
  Greedy_choice m_choice;
  Messages<Index> m_sent, m_received; // claims that others ask for, and theirs that this rank asks for
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_PATCH_CHOICE_2_H
