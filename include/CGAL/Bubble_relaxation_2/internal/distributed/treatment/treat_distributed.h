// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Distributed_surgery_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Treatment_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/rebuild_outside.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// `Whole_treatment_2` by ranks: moves, insertions and deletions are those of one rank. Each works on a piece of the
/// mesh that is wider than its own triangles and gets narrower with what is done; when nothing wider is left, the
/// pieces are made anew from where the bubbles are then. All members are collective.
class Distributed_treatment_2
{
public:
  using Mesh = Distributed_mesh_2;
  using Piece = Mesh_piece_2;

  /// `points`: those that were given on this rank; `reach`: how much wider the pieces are, in units of d, more than 0
  Distributed_treatment_2(const Problem_2& problem, const Bubbles_2& points, const Hilbert_partition_2& partition,
                          Communicator& comm, double reach = usual_reach)
    : m_problem(problem), m_domain(problem.domain), m_points(points), m_partition(partition), m_comm(comm),
      m_reach(reach)
  {}

  mutable std::size_t number_of_renewals = 0; ///< of pieces that had become too narrow, or whose change was refused
  const Problem_2& problem() const { return m_problem; }

  /// The mesh of all ranks' bubbles, each of which is at home.
  Mesh triangulate_own(const Bubbles_2& own) const { return triangulate(own, m_reach, 0); }

  Bubbles_2 own_bubbles(const Mesh& mesh) const { return internal::own_bubbles(mesh.bubbles); }

  /// \pre `mesh` was made by `triangulate_own()`
  Piece piece_of(Mesh&& mesh) const { return piece_of_whole(m_comm, std::move(mesh), m_partition, m_reach); }

  /// bubbles may have left their homes
  static Mesh mesh_of(Piece&& piece) { return std::move(piece.mesh); }

  double smallest_quality(const Mesh& mesh) const
  {
    return m_comm.smallest(internal::smallest_quality(mesh, mesh.is_owned));
  }

  void smooth(Piece& piece, const Sweeps& sweeps, Treatment_state& state) const
  {
    std::vector<Index> moved;
    const auto move = [&] {
      Treatment_team_2 team(m_comm, m_domain, piece, [&] { renew(piece, m_reach); });
      moved = Smoothing_sweeps_2(m_domain, piece.mesh, team)(sweeps, state.first_number);
      piece.mesh.mark_triangles(m_comm.rank());
      return std::any_of(moved.begin(), moved.end(), [&](Index v) { return piece.mesh.bubbles.is_on_edge(v); });
    };
    if (change(piece, state, move))
      state.counts.treated += m_comm.sum(std::uint64_t(moved.size()));
  }

  void operate(Piece& piece, Treatment_state& state) const
  {
    if (state.smallest >= bad_qualities[0])
      return; // ranks need not know more of each other
    Treatment_counts counts;
    std::int64_t first_number = state.first_number;
    const auto operate = [&] {
      Distributed_surgery_2 surgery(m_domain, piece, state.smallest, first_number, m_comm,
                                    [&](double times) { renew(piece, times * m_reach); });
      for (double bad_quality : bad_qualities)
        if (!surgery(bad_quality, static_cast<std::int64_t>(number_of_bubbles(piece.mesh))))
          break;
      counts = Treatment_counts{0, surgery.number_of_insertions, surgery.number_of_deletions};
      first_number = surgery.first_number;
      return surgery.has_changed_outline;
    };
    if (!change(piece, state, operate))
      return;
    state.counts += counts;
    state.first_number = first_number;
  }

  bool closes_outline(const Mesh& mesh) const
  {
    std::vector<Bubble_record_2> own;
    for (Index v : vertices_outside(mesh))
      if (mesh.bubbles.is_ours(v))
        own.push_back(record(mesh.bubbles, v));
    Bubbles_2 bubbles;
    for (const Bubble_record_2& r : gather_records(m_comm, own))
      add_own(bubbles, r);
    bubbles.sort_by_id();
    Marked_triangles_2 outside;
    return triangulate_outside(m_domain, bubbles, bubbles.left(), outside);
  }

  Distributed_treatment_2 triangulate_given(Mesh& given) const
  {
    const Placed_part_2 part = place_by_all(m_comm, m_problem, m_points, given_bubbles);
    const Distributed_treatment_2 result(m_problem, m_points, part.partition, m_comm, m_reach);
    given = result.triangulate_own(part.bubbles);
    return result;
  }

  Misfit_counts count_misfits(const Mesh& mesh) const
  {
    const Misfit_counts counts = internal::count_misfits(mesh, mesh.is_owned);
    return {m_comm.sum(counts.misfits), m_comm.sum(counts.all)};
  }

  bool is_stop_wanted() const { return m_comm.any(internal::is_stop_wanted()); }

  std::size_t number_of_bubbles(const Mesh& mesh) const
  {
    const auto here = std::count(mesh.bubbles.owner.begin(), mesh.bubbles.owner.end(), m_comm.rank());
    return static_cast<std::size_t>(m_comm.sum(std::int64_t(here)));
  }

  bool is_to_be_refined(const Mesh& mesh) const
  {
    bool is_any = false;
    m_comm.agree_after([&] { is_any = !triangles_to_refine(m_problem, mesh, mesh.is_owned).empty(); });
    return m_comm.any(is_any);
  }

  Mesh triangulated_anew(const Mesh& mesh) const { return with_points({}, mesh); }

  std::vector<Steiner_point_2> wanted_points(const Mesh& mesh) const
  {
    std::vector<Steiner_point_2> points;
    const auto positions = gather_records(m_comm, positions_on_edges(mesh.bubbles));
    m_comm.agree_after([&] {
      points = internal::wanted_points(m_problem, mesh, positions, triangles_to_refine(m_problem, mesh, mesh.is_owned));
    });
    return gather_records(m_comm, points);
  }

  bool insert(const std::vector<Steiner_point_2>& points, const Outline_care& care, Mesh& mesh) const
  {
    const std::size_t number_before = number_of_bubbles(mesh);
    try {
      mesh = with_points(points, mesh);
    } catch (const Edges_too_near&) { // on all ranks
      if (!care.is_careful)
        throw;
      return false;
    }
    return number_of_bubbles(mesh) == number_before + points.size(); // else they are finer than coordinates can tell
  }

  double smallest_free_sine(const Mesh& mesh) const
  {
    return m_comm.smallest(internal::smallest_free_sine(mesh, mesh.is_owned));
  }

  /// what refinement triangulates is no wider than it needs
  void prepare_to_treat_again(Mesh& mesh) const { mesh = triangulate_own(own_bubbles(mesh)); }

  std::pair<std::int64_t, double> left_to_refine(const Mesh& mesh) const
  {
    std::pair<std::int64_t, double> left;
    m_comm.agree_after([&] { left = internal::left_to_refine(m_problem, mesh, mesh.is_owned); });
    return {m_comm.sum(left.first), m_comm.largest(left.second)};
  }

private:
  /// Makes a change, unless the mesh gets worse by that; returns whether it was made. `make()` returns whether it moves
  /// the outline on this rank.
  template <class Make>
  bool change(Piece& piece, Treatment_state& state, const Make& make) const
  {
    Bubbles_2 before = piece.mesh.bubbles;
    bool changes_outline = false;
    double smallest_now = -1;
    try {
      changes_outline = m_comm.any(make());
      smallest_now = smallest_quality(piece.mesh);
    } catch (const Edges_too_near&) { // on all ranks: pieces cannot be renewed
      if (!state.care.is_careful)
        throw;
    }
    // moves make no triangle worse, but flips can, and rounding can make a mess of operations
    if (smallest_now < state.smallest ||
        !state.care.allows(changes_outline, [&] { return closes_outline(piece.mesh); })) {
      piece.mesh.bubbles = std::move(before);
      renew(piece, m_reach);
      return false;
    }
    state.smallest = smallest_now;
    return true;
  }

  static constexpr double usual_reach = 12; // enough for the sweeps of most meshes, before and after surgery

  Distributed_mesh_2 triangulate(const Bubbles_2& own, double reach, double stray) const
  {
    Distributed_mesh_2 mesh = distributed_triangulate(m_domain, own, m_partition, m_comm, reach, stray);
    label_edges(mesh.triangles);
    return mesh;
  }

  /// Makes pieces anew from where all bubbles are.
  void renew(Mesh_piece_2& piece, double reach) const
  {
    ++number_of_renewals;
    const Bubbles_2 own = own_bubbles(piece.mesh);
    const double stray = farthest_stray(m_comm, m_partition, own);
    piece = piece_of_whole(m_comm, triangulate(own, reach, stray), m_partition, reach);
  }

  /// inserts points that all ranks want, each on the rank that owns its place, and triangulates
  Mesh with_points(const std::vector<Steiner_point_2>& points, const Mesh& mesh) const
  {
    Bubbles_2 own = own_bubbles(mesh);
    std::int64_t end = static_cast<std::int64_t>(number_of_bubbles(mesh));
    m_comm.agree_after([&] {
      for (const Steiner_point_2& p : points) {
        Bubbles_2 one;
        one.add(Point(p.x, p.y), m_problem.sizes(p.x, p.y), p.dimension, p.host, p.s);
        if (m_partition.owner(p.x, p.y) == m_comm.rank())
          add_own(own, record(one, 0, end));
        ++end;
      }
    });
    return triangulate_from_anywhere(m_domain, m_partition, m_comm, end, std::move(own));
  }

  const Problem_2& m_problem;
  const Domain_2& m_domain;
  const Bubbles_2& m_points;
  const Hilbert_partition_2 m_partition;
  Communicator& m_comm;
  const double m_reach;
};

/// Collective. The triangulation of the simulated bubbles of all ranks, as `triangulate_and_treat()` makes it on one.
/// What it adds to the report are counts of all ranks. `points`: those that were given on this rank.
inline Distributed_mesh_2 treat_distributed(const Problem_2& problem, const Bubbles_2& points,
                                            const Placed_part_2& part, Communicator& comm, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  problem.options.progress->start_phase(Bubble_phase::TREATMENT);
  const Distributed_treatment_2 treatment(problem, points, part.partition, comm);
  Distributed_mesh_2 mesh = treatment.triangulate_own(part.bubbles);
  treat(treatment, mesh, report);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H
