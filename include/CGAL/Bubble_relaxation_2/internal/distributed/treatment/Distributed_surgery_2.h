// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_DISTRIBUTED_SURGERY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_DISTRIBUTED_SURGERY_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Patch_changes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Defect_surgery_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// an operation on the triangles around a bad one, which tells who comes first
struct Ranked_operation_2
{
  Bad_triangle_2 bad;
  Mesh_patch_2 patch;
  Patch_outcome_2 outcome;
  bool is_chosen;
  std::int32_t place = 0;        ///< among all that are chosen
  std::int64_t first_number = 0; ///< of what is inserted

  std::int64_t number_of_insertions() const
  {
    return std::count_if(outcome.original.begin(), outcome.original.end(), [this](Index i) {
      return static_cast<std::size_t>(i) >= patch.indices().size();
    });
  }
};

/// Chooses among the claims of all ranks those that are worth it, the first ones first, and none that shares a
/// triangle with one chosen before. The owners of the triangles' first vertices compare the claims.
class Patch_choice_2
{
public:
  Patch_choice_2(Communicator& comm, const std::vector<Ranked_operation_2>& claims,
                 const Distributed_mesh_2& mesh)
    : m_comm(comm)
  {
    add_candidates(claims.size(), find_rivals(claims, mesh));
  }

  /// Collective. `is_worth_it(k)` is asked only of claims that no other one is in the way of, in whatever order.
  template <class Predicate>
  void operator()(const Predicate& is_worth_it)
  {
    const auto decide = [&] {
      bool is_open = false;
      m_comm.agree_after([&] { is_open = m_choice.decide(is_worth_it); });
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
  Messages<Rivalry> find_rivals(const std::vector<Ranked_operation_2>& claims, const Distributed_mesh_2& mesh)
  {
    const Bubbles_2& known = mesh.bubbles;
    Messages<Claimed> out;
    for (std::size_t k = 0; k < claims.size(); ++k)
      for (Index triangle : claims[k].patch.triangles()) {
        const std::array<Index, 3>& t = mesh.triangles.vertices[triangle];
        Claimed claimed{{known.id[t[0]], known.id[t[1]], known.id[t[2]]},
                        claims[k].bad, m_comm.rank(), static_cast<std::int32_t>(k)};
        std::sort(claimed.triangle.begin(), claimed.triangle.end());
        out[known.owner[*std::min_element(t.begin(), t.end())]].push_back(claimed);
      }
    std::vector<Claimed> claimed;
    for (const auto& message : deliver(m_comm, out))
      claimed.insert(claimed.end(), message.second.begin(), message.second.end());
    std::sort(claimed.begin(), claimed.end());
    Messages<Rivalry> rivalries;
    for (std::size_t first = 0, k = 0; k < claimed.size(); ++k) {
      if (claimed[k].triangle != claimed[first].triangle)
        first = k;
      for (std::size_t r = first; r < k; ++r)
        rivalries[claimed[k].rank].push_back(Rivalry{claimed[k].claim, claimed[r].rank, claimed[r].claim});
    }
    return deliver(m_comm, rivalries);
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
    m_sent = deliver(m_comm, questions);
    m_choice.start(static_cast<std::size_t>(next));
    for (std::size_t k = 0; k < n; ++k)
      m_choice.add(static_cast<Index>(k));
    for (const auto& message : rivalries)
      for (const Rivalry& r : message.second)
        m_choice.rivals(static_cast<std::size_t>(r.claim))
          .push_back(r.rival_rank == m_comm.rank() ? r.rival : others.at({r.rival_rank, r.rival}));
  }

  Communicator& m_comm;
  Greedy_choice m_choice;
  Messages<Index> m_sent, m_received; // claims that others ask for, and theirs that this rank asks for
};

/// The operations of `Defect_surgery_2` by ranks: each operates on the triangles it owns that are among the worst of
/// all. An operation looks at the mesh as it was before all of them, so its outcome does not depend on others; of
/// patches that overlap the one with the worse triangle counts.
class Distributed_surgery_2
{
public:
  Distributed_surgery_2(const Domain_2& domain, const Mesh_piece_2& piece, Communicator& comm)
    : m_domain(domain), m_piece(piece), m_known(piece.mesh.bubbles), m_triangles(piece.mesh.triangles),
      m_comm(comm)
  {}

  /// what was done on all ranks
  std::int64_t number_of_insertions = 0, number_of_deletions = 0;

  /// Collective. Finds the worst triangles of all, `most` at most, and their patches; returns whether the piece is
  /// wide enough for that on all ranks.
  bool find_patches(double bad_quality, std::size_t most)
  {
    bool is_cut_off = false;
    std::vector<Bad_triangle_2> worst;
    m_comm.agree_after([&] {
      worst = bad_triangles(m_piece.mesh, bad_quality);
      worst.erase(std::remove_if(worst.begin(), worst.end(),
                                 [this](const Bad_triangle_2& t) { return !m_piece.mesh.is_owned[t.triangle]; }),
                  worst.end());
      worst.resize((std::min)(most, worst.size()));
    });
    keep_worst_of_all(most, worst);
    m_comm.agree_after([&] {
      for (const Bad_triangle_2& bad : worst) {
        m_operations.push_back(
          Ranked_operation_2{bad, Mesh_patch_2(m_piece.mesh, bad.triangle), {}, false});
        is_cut_off = is_cut_off || m_operations.back().patch.is_cut_off();
      }
    });
    return !m_comm.any(is_cut_off);
  }

  /// Collective. Operates on patches that do not overlap: returns what became of those that are known here. What is
  /// inserted gets numbers from `end` on.
  Patch_changes_2 operate(std::int64_t end)
  {
    Patch_choice_2 choose(m_comm, m_operations, m_piece.mesh);
    choose([this](std::size_t k) { return operate_on(m_operations[k]); });
    number_operations(end);
    Patch_changes_2 own;
    m_comm.agree_after([&] {
      for (const Ranked_operation_2& operation : m_operations)
        if (operation.is_chosen)
          own[operation.place] = describe(operation);
    });
    number_of_insertions = m_comm.sum(number_of_insertions);
    number_of_deletions = m_comm.sum(number_of_deletions);
    return Patch_announcement_2(m_piece, m_comm)(own);
  }

private:
  void keep_worst_of_all(std::size_t most, std::vector<Bad_triangle_2>& worst) const
  {
    std::vector<Bad_triangle_2> all = gather_records(m_comm, worst);
    if (all.size() <= most)
      return;
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(most), all.end());
    const Bad_triangle_2& first_too_many = all[most];
    worst.erase(std::lower_bound(worst.begin(), worst.end(), first_too_many), worst.end());
  }

  /// returns whether it helped
  bool operate_on(Ranked_operation_2& operation) const
  {
    Patch_operation_2 operate(m_domain, m_piece.mesh, operation.patch);
    operation.is_chosen = operate(operation.bad.triangle);
    operation.outcome = operate.best();
    return operation.is_chosen;
  }

  /// numbers operations, and what they insert, as if all were made by one rank
  void number_operations(std::int64_t end)
  {
    struct Insertion
    {
      Bad_triangle_2 bad;
      std::int64_t number;

      bool operator<(const Insertion& i) const { return bad < i.bad; }
    };
    std::vector<Insertion> own;
    for (const Ranked_operation_2& operation : m_operations)
      if (operation.is_chosen)
        own.push_back(Insertion{operation.bad, operation.number_of_insertions()});
    std::vector<Insertion> all = gather_records(m_comm, own);
    std::sort(all.begin(), all.end());
    for (Insertion& i : all)
      end += std::exchange(i.number, end);
    for (Ranked_operation_2& operation : m_operations)
      if (operation.is_chosen) {
        const auto found = std::lower_bound(all.begin(), all.end(), Insertion{operation.bad, 0});
        operation.place = static_cast<std::int32_t>(found - all.begin());
        operation.first_number = found->number;
      }
  }

  Patch_change_2 describe(const Ranked_operation_2& operation)
  {
    Patch_change_2 result;
    const std::vector<Index>& indices = operation.patch.indices();
    const Bubbles_2& b = operation.outcome.mesh.bubbles;
    std::vector<char> is_left(indices.size(), 0);
    std::vector<std::int64_t> numbers; // of the bubbles of the outcome
    std::int64_t number = operation.first_number;
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t original = static_cast<std::size_t>(operation.outcome.original[k]);
      if (original >= indices.size()) {
        result.bubbles.push_back({operation.place, m_comm.rank(), record(b, k, number)});
        numbers.push_back(number++);
        ++number_of_insertions;
        continue;
      }
      is_left[original] = 1;
      const std::size_t i = static_cast<std::size_t>(indices[original]);
      numbers.push_back(m_known.id[i]);
      result.bubbles.push_back({operation.place, m_known.owner[i], // those on the rim look like corners
                                b.can_move(k) ? record(b, k, numbers.back()) : record(m_known, i)});
    }
    for (std::size_t l = 0; l < indices.size(); ++l)
      if (!is_left[l]) {
        Bubble_record_2 gone = record(m_known, static_cast<std::size_t>(indices[l]));
        gone.dimension = Bubbles_2::GONE;
        result.bubbles.push_back({operation.place, m_known.owner[indices[l]], gone});
        ++number_of_deletions;
      }
    describe_triangles(operation, numbers, result);
    return result;
  }

  void describe_triangles(const Ranked_operation_2& operation, const std::vector<std::int64_t>& numbers,
                          Patch_change_2& change) const
  {
    for (Index t : operation.patch.triangles()) {
      const std::array<Index, 3>& v = m_triangles.vertices[t];
      change.triangles.push_back(
        {operation.place, 0, {m_known.id[v[0]], m_known.id[v[1]], m_known.id[v[2]]}, {}});
    }
    std::vector<Index> same(numbers.size());
    std::iota(same.begin(), same.end(), Index(0));
    for (const New_triangle_2& t : operation.outcome.triangles(operation.patch, same)) {
      const std::array<Index, 3>& v = t.vertices;
      change.triangles.push_back({operation.place, 1, {numbers[v[0]], numbers[v[1]], numbers[v[2]]}, t.edges});
    }
  }

  const Domain_2& m_domain;
  const Mesh_piece_2& m_piece;
  const Bubbles_2& m_known;
  const Marked_triangles_2& m_triangles;
  Communicator& m_comm;
  std::vector<Ranked_operation_2> m_operations;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_DISTRIBUTED_SURGERY_2_H
