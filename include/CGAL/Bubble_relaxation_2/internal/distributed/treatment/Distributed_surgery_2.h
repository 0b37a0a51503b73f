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
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Piece_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Defect_surgery_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// an operation on the triangles around a bad one
struct Ranked_operation_2
{
  Index place; ///< among the worst triangles of all ranks: who comes first
  Index triangle;
  Mesh_patch_2 patch;
  Patch_outcome_2 outcome;
  bool is_chosen;

  std::int64_t number_of_insertions() const
  {
    return std::count_if(outcome.original.begin(), outcome.original.end(), [this](Index i) {
      return static_cast<std::size_t>(i) >= patch.indices().size();
    });
  }
};

/// The operations of `Defect_surgery_2` by ranks: each operates on the triangles it owns that are among the worst of
/// all. An operation looks at the mesh as it was before all of them, so its outcome does not depend on others; of
/// patches that overlap the one with the worse triangle counts.
class Distributed_surgery_2
{
public:
  Distributed_surgery_2(const Domain_2& domain, const Mesh_piece_2& piece, double smallest, Communicator& comm)
    : m_domain(domain), m_piece(piece), m_known(piece.mesh.bubbles), m_triangles(piece.mesh.triangles),
      m_smallest(smallest), m_comm(comm)
  {}

  /// what was done on all ranks
  std::int64_t number_of_insertions = 0, number_of_deletions = 0;

  /// Collective. Finds the bad triangles of all and their patches; returns whether the piece is wide enough for that on
  /// all ranks.
  bool find_patches(double bad_quality)
  {
    bool is_cut_off = false;
    std::vector<Bad_triangle_2> own = bad_triangles(m_piece.mesh, bad_quality);
    own.erase(std::remove_if(own.begin(), own.end(),
                             [this](const Bad_triangle_2& t) { return !m_piece.mesh.is_owned[t.triangle]; }),
              own.end());
    std::vector<Bad_triangle_2> worst = gather_records(m_comm, own);
    std::sort(worst.begin(), worst.end());
    m_number_of_places = worst.size();
    for (const Bad_triangle_2& bad : own) {
      const auto place = std::lower_bound(worst.begin(), worst.end(), bad) - worst.begin();
      Mesh_patch_2 patch(m_piece.mesh, triangles_around(m_triangles, bad.triangle));
      is_cut_off = is_cut_off || patch.is_cut_off();
      m_operations.push_back(Ranked_operation_2{static_cast<Index>(place), bad.triangle, std::move(patch), {}, false});
    }
    return !m_comm.any(is_cut_off);
  }

  /// Collective. Operates on patches that do not overlap: returns what became of those that are known here. What is
  /// inserted gets numbers from `end` on.
  Patch_changes_2 operate(std::int64_t end)
  {
    choose();
    std::vector<std::int64_t> insertions(m_number_of_places, 0);
    for (const Ranked_operation_2& operation : m_operations)
      if (operation.is_chosen)
        insertions[operation.place] = operation.number_of_insertions();
    m_comm.reduce_each(insertions, MPI_SUM);
    number_of_insertions = std::accumulate(insertions.begin(), insertions.end(), std::int64_t(0));
    std::exclusive_scan(insertions.begin(), insertions.end(), insertions.begin(), end);
    Patch_change_2 own;
    for (const Ranked_operation_2& operation : m_operations)
      if (operation.is_chosen) // numbers are as if all operations were made by one rank
        describe(operation, insertions[operation.place], own);
    number_of_deletions = m_comm.sum(number_of_deletions);
    return changes_known_here(m_comm, m_known, own);
  }

private:
  /// a triangle that an operation wants to change
  struct Claim
  {
    std::array<std::int64_t, 3> triangle; // numbers of its vertices, in order
    std::int64_t place;

    bool operator<(const Claim& c) const { return std::tie(triangle, place) < std::tie(c.triangle, c.place); }
  };

  /// Collective. Operates where that is worth it, the first ones first, and nowhere if a triangle is shared with one
  /// before that was worth it.
  void choose()
  {
    const std::vector<Claim> claims = claims_of_all();
    Greedy_choice choice;
    choice.start(m_number_of_places);
    std::vector<Ranked_operation_2*> at(m_number_of_places, nullptr);
    std::vector<std::size_t> place_here(m_number_of_places);
    for (Ranked_operation_2& operation : m_operations) {
      at[operation.place] = &operation;
      place_here[operation.place] = choice.add(operation.place);
    }
    for (std::size_t first = 0, k = 0; k < claims.size(); ++k) {
      if (claims[k].triangle != claims[first].triangle)
        first = k;
      for (std::size_t r = first; at[claims[k].place] && r < k; ++r)
        choice.rivals(place_here[claims[k].place]).push_back(static_cast<Index>(claims[r].place));
    }
    const auto decide = [&] { return choice.decide([&](Index place) { return operate_on(*at[place]); }); };
    decide_together(m_comm, decide, [&] { m_comm.reduce_each(choice.states(), MPI_MAX); });
  }

  std::vector<Claim> claims_of_all() const
  {
    std::vector<Claim> own;
    for (const Ranked_operation_2& operation : m_operations)
      for (Index triangle : operation.patch.triangles()) {
        const std::array<Index, 3>& t = m_triangles.vertices[triangle];
        own.push_back(Claim{{m_known.id[t[0]], m_known.id[t[1]], m_known.id[t[2]]}, operation.place});
        std::sort(own.back().triangle.begin(), own.back().triangle.end());
      }
    std::vector<Claim> all = gather_records(m_comm, own);
    std::sort(all.begin(), all.end());
    return all;
  }

  /// returns whether it helped
  bool operate_on(Ranked_operation_2& operation) const
  {
    Patch_operation_2 operate(m_domain, m_piece.mesh, operation.patch, m_smallest);
    operation.is_chosen = operate(operation.triangle);
    operation.outcome = operate.best();
    return operation.is_chosen;
  }

  /// adds what an operation does. `number`: that of the first bubble that it inserts
  void describe(const Ranked_operation_2& operation, std::int64_t number, Patch_change_2& result)
  {
    const std::vector<Index>& indices = operation.patch.indices();
    const Bubbles_2& b = operation.outcome.mesh.bubbles;
    std::vector<char> is_left(indices.size(), 0);
    std::vector<std::int64_t> numbers; // of the bubbles of the outcome
    for (std::size_t k = 0; k < b.size(); ++k) {
      const std::size_t original = static_cast<std::size_t>(operation.outcome.original[k]);
      if (original >= indices.size()) {
        result.bubbles.push_back({operation.place, m_comm.rank(), record(b, k, number)});
        numbers.push_back(number++);
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
  const double m_smallest;
  Communicator& m_comm;
  std::vector<Ranked_operation_2> m_operations;
  std::size_t m_number_of_places = 0; // of operations of all ranks
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_DISTRIBUTED_SURGERY_2_H
