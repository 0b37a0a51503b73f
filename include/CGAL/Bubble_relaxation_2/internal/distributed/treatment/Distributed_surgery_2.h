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
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Defect_surgery_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// an operation on the triangles around a bad one
struct Ranked_operation_2
{
  Index place; ///< among the worst triangles of all ranks: who comes first
  Index triangle;
  std::vector<Index> triangles; ///< of its patch
  std::optional<Mesh_patch_2> patch; ///< when it is operated on
  Patch_outcome_2 outcome;
  bool is_chosen;

  bool is_inserted(std::size_t k) const ///< of a bubble of the outcome
  {
    return static_cast<std::size_t>(outcome.original[k]) >= patch->indices().size();
  }
};

/// The operations of `Defect_surgery_2` by ranks: each operates on the triangles it owns that are among the worst of
/// all. An operation looks at the mesh as it was before all of them, so its outcome does not depend on others; of
/// patches that overlap the one with the worse triangle counts. What comes out is put in the place of the patches in
/// the pieces of all ranks, as far as each piece reaches, and bubbles are numbered without gaps then, as on one rank.
class Distributed_surgery_2
{
public:
  /// \param smallest the smallest q of the whole mesh, which does not get smaller
  /// \param renew `renew(times)` makes the pieces of all ranks anew, so many times as wide as they usually are
  Distributed_surgery_2(const Domain_2& domain, Mesh_piece_2& piece, double smallest, std::int64_t first,
                        Communicator& comm, std::function<void(double)> renew)
    : first_number(first), m_domain(domain), m_piece(piece), m_known(piece.mesh.bubbles), m_triangles(piece.mesh.triangles),
      m_operate(domain, piece.mesh, smallest), m_comm(comm), m_renew(std::move(renew))
  {}

  /// what was done on all ranks
  std::size_t number_of_insertions = 0, number_of_deletions = 0;
  bool has_changed_outline = false;
  std::int64_t first_number; ///< of the vertices whose triangles are operated on; falls when others before it go

  /// Collective. Operates on triangles with less than `bad_quality`; returns whether any of them got better. `end`: the
  /// number of bubbles of all ranks
  bool operator()(double bad_quality, std::int64_t end)
  {
    for (double times = 1; !find_patches(bad_quality); times *= 2) // they are cut off
      m_renew(times);
    const std::vector<Index> taken_away = choose();
    std::vector<std::int64_t> first(m_number_of_places, 0); // numbers are as if all operations were made by one rank
    for (const Ranked_operation_2& operation : m_operations)
      for (std::size_t k = 0; operation.is_chosen && k < operation.outcome.original.size(); ++k)
        first[operation.place] += operation.is_inserted(k);
    m_comm.reduce_each(first, MPI_SUM);
    const std::int64_t inserted = std::accumulate(first.begin(), first.end(), std::int64_t(0));
    std::exclusive_scan(first.begin(), first.end(), first.begin(), end);
    std::vector<Bubble_record_2> bubbles;
    std::vector<Made_triangle> triangles;
    for (const Ranked_operation_2& operation : m_operations)
      if (operation.is_chosen)
        describe(operation, first[operation.place], bubbles, triangles);
    bubbles = gather_records(m_comm, bubbles); // all get all: operations are few
    std::sort(bubbles.begin(), bubbles.end(),
              [](const Bubble_record_2& a, const Bubble_record_2& b) { return a.id < b.id; });
    const auto deleted = std::count_if(bubbles.begin(), bubbles.end(), is_gone);
    if (inserted + deleted == 0)
      return false;
    number_of_insertions += static_cast<std::size_t>(inserted);
    number_of_deletions += static_cast<std::size_t>(deleted);
    stitch(taken_away, bubbles, gather_records(m_comm, triangles), end);
    first_number -= std::count_if(bubbles.begin(), bubbles.end(), [this](const Bubble_record_2& r) {
      return is_gone(r) && r.id < first_number;
    });
    return true;
  }

private:
  /// a triangle that an operation wants to change
  struct Claim
  {
    Numbers_of_triangle triangle;
    std::int64_t place;

    bool operator<(const Claim& c) const { return std::tie(triangle, place) < std::tie(c.triangle, c.place); }
  };

  /// a triangle that an operation makes, by the numbers of its vertices
  struct Made_triangle
  {
    std::array<std::int64_t, 3> vertices;
    std::array<Index, 3> edges; ///< labels
  };

  static bool is_gone(const Bubble_record_2& r) { return r.dimension == Bubbles_2::GONE; }

  /// Collective. Finds the bad triangles of all and their patches; returns whether all ranks' pieces are wide enough.
  bool find_patches(double bad_quality)
  {
    bool is_any_cut_off = false;
    std::vector<Bad_triangle_2> own = bad_triangles(m_piece.mesh, bad_quality, first_number);
    own.erase(std::remove_if(own.begin(), own.end(),
                             [this](const Bad_triangle_2& t) { return !m_piece.mesh.is_owned[t.triangle]; }),
              own.end());
    std::vector<Bad_triangle_2> worst = gather_records(m_comm, own);
    std::sort(worst.begin(), worst.end());
    m_number_of_places = worst.size();
    m_operations.clear();
    for (const Bad_triangle_2& bad : own) {
      const auto place = std::lower_bound(worst.begin(), worst.end(), bad) - worst.begin();
      std::vector<Index> triangles = triangles_around(m_triangles, bad.triangle);
      is_any_cut_off = is_any_cut_off || is_cut_off(m_triangles, triangles);
      m_operations.push_back({static_cast<Index>(place), bad.triangle, std::move(triangles), std::nullopt, {}, false});
    }
    return !m_comm.any(is_any_cut_off);
  }

  /// Collective. Operates where that is worth it, the first ones first, and nowhere if a triangle is shared with one
  /// before that was worth it. Returns the triangles that are known here of the patches of all that did.
  std::vector<Index> choose()
  {
    std::vector<Claim> claims;
    for (const Ranked_operation_2& operation : m_operations)
      for (Index t : operation.triangles)
        claims.push_back(Claim{sorted_numbers(m_known, m_triangles.vertices[t]), operation.place});
    claims = gather_records(m_comm, claims);
    std::sort(claims.begin(), claims.end());
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

    const auto is_refused = [&](const Claim& c) { return !choice.is_chosen(static_cast<Index>(c.place)); };
    claims.erase(std::remove_if(claims.begin(), claims.end(), is_refused), claims.end());
    std::vector<char> is_concerned(m_known.size(), 0);
    for (const Claim& claim : claims)
      for (std::int64_t number : claim.triangle)
        if (const Index v = m_known.index_of(number); v != no_index)
          is_concerned[v] = 1;
    std::vector<Index> result;
    for (std::size_t t = 0; t < m_triangles.inside.size() && !claims.empty(); ++t)
      if (m_triangles.inside[t] && is_concerned[m_triangles.vertices[t][0]]) {
        const Claim claim{sorted_numbers(m_known, m_triangles.vertices[t]), 0};
        const auto found = std::lower_bound(claims.begin(), claims.end(), claim);
        if (found != claims.end() && found->triangle == claim.triangle)
          result.push_back(static_cast<Index>(t));
      }
    return result;
  }

  /// returns whether it helped
  bool operate_on(Ranked_operation_2& operation)
  {
    operation.patch.emplace(m_piece.mesh, std::move(operation.triangles));
    operation.is_chosen = m_operate(*operation.patch, operation.triangle, operation.outcome);
    return operation.is_chosen;
  }

  /// adds what an operation moves, inserts and deletes, and its triangles. `number`: of the first that it inserts
  void describe(const Ranked_operation_2& operation, std::int64_t number, std::vector<Bubble_record_2>& bubbles,
                std::vector<Made_triangle>& triangles) const
  {
    const std::vector<Index>& indices = operation.patch->indices();
    const Bubbles_2& b = operation.outcome.mesh.bubbles;
    std::vector<char> is_left(indices.size(), 0);
    std::vector<std::int64_t> numbers; // of the bubbles of the outcome
    for (std::size_t k = 0; k < b.size(); ++k) {
      const bool is_inserted = operation.is_inserted(k);
      const Index original = operation.outcome.original[k];
      numbers.push_back(is_inserted ? number++ : m_known.id[indices[original]]);
      if (!is_inserted)
        is_left[original] = 1;
      if (b.can_move(k)) { // those on the rim look like corners
        bubbles.push_back(record(b, k, numbers.back()));
        bubbles.back().owner = is_inserted ? m_comm.rank() : m_known.owner[indices[original]];
      }
    }
    for (std::size_t l = 0; l < indices.size(); ++l)
      if (!is_left[l]) {
        bubbles.push_back(record(m_known, static_cast<std::size_t>(indices[l])));
        bubbles.back().dimension = Bubbles_2::GONE;
      }
    const Marked_triangles_2& m = operation.outcome.mesh.triangles;
    for (std::size_t t = 0; t < m.number_of_triangles(); ++t) {
      const std::array<Index, 3>& v = m.vertices[t];
      triangles.push_back(Made_triangle{{numbers[v[0]], numbers[v[1]], numbers[v[2]]}, m.edges[t]});
    }
  }

  /// Collective. Puts what was made in the place of what is taken away, as far as it is known here. `end`: the first
  /// number of an inserted bubble
  void stitch(const std::vector<Index>& taken_away, const std::vector<Bubble_record_2>& bubbles,
              const std::vector<Made_triangle>& triangles, std::int64_t end)
  {
    Mesh_stitching_2 stitching(m_piece.mesh);
    for (const Bubble_record_2& r : bubbles)
      replace(r, end);
    std::vector<New_triangle_2> made;
    for (const Made_triangle& t : triangles) {
      const auto index = [&](int i) { return m_known.index_of(t.vertices[i]); };
      const New_triangle_2 triangle{{index(0), index(1), index(2)}, t.edges};
      if (*std::min_element(triangle.vertices.begin(), triangle.vertices.end()) != no_index)
        made.push_back(triangle);
    }
    stitching.replace(taken_away, made);
    Editable_triangulation_2 mesh = stitching.finish();
    std::vector<Index> changed = mesh.take_flipped();
    changed.insert(changed.end(), stitching.made().begin(), stitching.made().end());
    std::vector<Point> places; // all know all of them
    for (const Bubble_record_2& r : bubbles)
      if (!is_gone(r))
        places.emplace_back(r.x, r.y);
    Border_check_2 check(mesh, m_domain.bbox(), changed, std::move(places));
    const bool is_wide_enough = check.forget_doubtful(triangles_beside_others(m_piece.mesh));
    close_gaps(bubbles);
    forget_lonely_ghosts(m_piece.mesh);
    link_with_others(m_comm, m_piece);
    m_piece.mesh.mark_triangles(m_comm.rank());
    has_changed_outline = m_comm.any(has_changed_outline);
    if (m_comm.any(!is_wide_enough))
      m_renew(1);
  }

  void replace(const Bubble_record_2& r, std::int64_t end)
  {
    Bubbles_2& b = m_known;
    const Index i = b.index_of(r.id);
    if (i == no_index) {
      if (r.id >= end) { // else it is not known here
        add(b, r, r.owner);
        has_changed_outline = has_changed_outline || r.dimension == Bubbles_2::EDGE;
      }
      return;
    }
    has_changed_outline = has_changed_outline || (b.is_on_edge(i) && (is_gone(r) || Point(r.x, r.y) != b.point(i)));
    if (is_gone(r)) {
      b.remove(i);
      return;
    }
    b.x[i] = r.x;
    b.y[i] = r.y;
    b.s[i] = r.s;
    b.host[i] = r.host;
  }

  /// `changed`: in the order of their numbers
  void close_gaps(const std::vector<Bubble_record_2>& changed)
  {
    auto next = changed.begin();
    std::int64_t gone = 0; // before
    for (std::int64_t& number : m_known.id) {
      for (; next != changed.end() && next->id < number; ++next)
        gone += is_gone(*next);
      number -= gone;
    }
  }

  const Domain_2& m_domain;
  Mesh_piece_2& m_piece;
  Bubbles_2& m_known;
  const Marked_triangles_2& m_triangles;
  Patch_operations_2 m_operate;
  Communicator& m_comm;
  const std::function<void(double)> m_renew;
  std::vector<Ranked_operation_2> m_operations;
  std::size_t m_number_of_places = 0; // of operations of all ranks
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_DISTRIBUTED_SURGERY_2_H
