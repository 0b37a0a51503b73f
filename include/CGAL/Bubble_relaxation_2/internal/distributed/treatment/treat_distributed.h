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
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/placement/place_distributed.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Distributed_surgery_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Piece_stitching_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Treatment_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Collective. The mesh of bubbles that may have left their homes, as `remove_coincident()` leaves them. `end`: all have
/// smaller ones
inline Distributed_mesh_2 triangulate_from_anywhere(const Domain_2& domain, const Hilbert_partition_2& partition,
                                                    Communicator& comm, std::int64_t end, Bubbles_2 bubbles)
{
  remove_confusing_of_ours(comm, domain, bubbles);
  return distributed_triangulate(domain, bring_home_and_number(comm, partition, end, std::move(bubbles)), partition, comm);
}

/// Collective. `Cut_domain_2::join()` by ranks.
inline Distributed_mesh_2 join_distributed(const Cut_domain_2& cut, const Distributed_mesh_2& mesh,
                                           const Hilbert_partition_2& partition, Communicator& comm)
{
  Bubbles_2 own = own_bubbles(mesh, comm.rank());
  cut.join(own);
  const std::int64_t end = comm.sum(static_cast<std::int64_t>(own.size()));
  return triangulate_from_anywhere(cut.whole(), partition, comm, end, std::move(own));
}

/// `Whole_treatment_2` by ranks: moves, insertions and deletions are those of one rank. Each works on a piece of the
/// mesh that is wider than its own triangles and gets narrower with what is done; when nothing wider is left, the pieces are
/// made anew from where the bubbles are then. All members are collective.
class Distributed_treatment_2
{
public:
  using Mesh = Distributed_mesh_2;
  using Piece = Mesh_piece_2;

  /// `points`: those that were given on this rank; `reach`: how much wider the pieces are, in units of d \pre it is
  /// positive
  Distributed_treatment_2(const Problem_2& problem, const Bubbles_2& points, const Hilbert_partition_2& partition,
                          Communicator& comm, double reach = usual_reach)
    : m_problem(problem), m_domain(problem.domain), m_points(points), m_partition(partition), m_comm(comm),
      m_reach(reach)
  {}

  const Problem_2& problem() const { return m_problem; }

  /// The mesh of all ranks' bubbles, each of which is at home.
  Mesh triangulate(const Bubbles_2& own) const { return triangulate(own, m_reach, 0); }

  /// \pre `mesh` was made by `triangulate()`
  Piece piece_of(Mesh&& mesh) const { return piece_of_whole(m_comm, std::move(mesh), m_partition, m_reach); }

  /// bubbles may have left their homes
  static Mesh mesh_of(Piece&& piece) { return std::move(piece.mesh); }

  double smallest_quality(const Mesh& mesh) const
  {
    double smallest = 1;
    for (Index t : marked(mesh.is_owned))
      smallest = (std::min)(smallest, quality(mesh, t));
    return m_comm.smallest(smallest);
  }

  /// moves vertices, unless the mesh gets worse by that; returns how many were moved
  std::size_t smooth(Piece& piece, double& smallest, int most_sweeps) const
  {
    if (smallest >= Smoothing_sweeps_2::treated_quality)
      return 0;
    Mesh& mesh = piece.mesh;
    Treatment_team_2 team(m_comm, piece, [&] { renew(piece, m_reach); });
    Smoothing_sweeps_2 treat(m_domain, mesh, team);
    std::vector<Index> moved;
    double smallest_now = -1;
    try {
      moved = treat(most_sweeps);
      mesh.mark_triangles(team.changed_triangles(), m_comm.rank());
      smallest_now = smallest_quality(mesh);
    } catch (const std::runtime_error&) { // of all ranks: edges have come too near to each other for a renewal
    }
    const bool moves_outline =
      std::any_of(moved.begin(), moved.end(), [&](Index v) { return mesh.bubbles.is_on_edge(v); });
    // the moves made none worse, but flips can; and parts of the outline can be as near as a rounding
    if (smallest_now < smallest || (m_comm.any(moves_outline) && !has_valid_outline(mesh))) {
      if (!team.undo())
        treat.undo();
      mesh.mark_triangles(m_comm.rank());
      return 0;
    }
    smallest = smallest_now;
    return number_of_all(moved.size());
  }

  void operate(Piece& piece, double& smallest, Treatment_counts& counts) const
  {
    if (smallest >= bad_qualities[0])
      return; // ranks need not know more of each other
    Treatment_counts changes;
    Piece last = piece;
    bool has_changed_outline = false;
    double smallest_now = -1;
    try {
      for (double bad_quality : bad_qualities)
        if (!operate_once(last, bad_quality, smallest, changes, has_changed_outline))
          break;
      smallest_now = smallest_quality(last.mesh);
    } catch (const std::runtime_error&) { // the same
    }
    // rounding can make a mess of a change; then what was there is good
    if (changes.inserted + changes.deleted == 0 || smallest_now < smallest ||
        (m_comm.any(has_changed_outline) && !has_valid_outline(last.mesh)))
      return;
    smallest = smallest_now;
    piece = std::move(last);
    counts += changes;
  }

  Distributed_treatment_2 triangulate_given(Mesh& given) const
  {
    const Placed_part_2 part = given_bubbles_distributed(m_comm, m_problem, m_points);
    const Distributed_treatment_2 result(m_problem, m_points, part.partition, m_comm, m_reach);
    given = result.triangulate(part.bubbles);
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
    return number_of_all(static_cast<std::size_t>(
      std::count(mesh.bubbles.owner.begin(), mesh.bubbles.owner.end(), m_comm.rank())));
  }

  bool is_to_be_refined(const Mesh& mesh) const
  {
    bool is_any = false;
    m_comm.agree_after([&] { is_any = !triangles_to_refine(m_problem, mesh, mesh.is_owned).empty(); });
    return m_comm.any(is_any);
  }

  /// after treatment a rank does not know where others' bubbles on edges are
  Mesh triangulated_anew(const Mesh& mesh) const { return with_points({}, mesh); }

  /// of all ranks
  std::vector<Steiner_point_2> wanted_points(const Mesh& mesh) const
  {
    std::vector<Steiner_point_2> points;
    m_comm.agree_after(
      [&] { points = internal::wanted_points(m_problem, mesh, triangles_to_refine(m_problem, mesh, mesh.is_owned)); });
    return gather_records(m_comm, points);
  }

  bool insert(const std::vector<Steiner_point_2>& points, Mesh& mesh) const
  {
    try {
      Mesh next = with_points(points, mesh);
      if (number_of_bubbles(next) != number_of_bubbles(mesh) + points.size())
        return false; // finer than coordinates can tell
      mesh = std::move(next);
      return true;
    } catch (const std::runtime_error&) { // the same, on all ranks
      return false;
    }
  }

  double smallest_free_sine(const Mesh& mesh) const
  {
    return m_comm.smallest(internal::smallest_free_sine(mesh, mesh.is_owned));
  }

  /// what refinement triangulates is no wider than it needs
  Mesh to_be_treated_again(const Mesh& mesh) const { return triangulate(own_bubbles(mesh, m_comm.rank())); }

  std::pair<std::int64_t, double> left_to_refine(const Mesh& mesh) const
  {
    std::pair<std::int64_t, double> left;
    m_comm.agree_after([&] { left = internal::left_to_refine(m_problem, mesh, mesh.is_owned); });
    return {m_comm.sum(left.first), m_comm.largest(left.second)};
  }

private:
  static constexpr double usual_reach = 12; // enough for the sweeps of most meshes, before and after surgery

  Distributed_mesh_2 triangulate(const Bubbles_2& own, double reach, double stray) const
  {
    Distributed_mesh_2 mesh = distributed_triangulate(m_domain, own, m_partition, m_comm, reach, stray);
    label_edges(mesh.triangles);
    return mesh;
  }

  /// Makes pieces that are too narrow from where all bubbles are.
  void renew(Mesh_piece_2& piece, double reach) const
  {
    const std::size_t renewals = piece.mesh.number_of_renewals;
    const Bubbles_2 own = own_bubbles(piece.mesh, m_comm.rank());
    const double stray = farthest_stray(m_comm, m_partition, own);
    piece = piece_of_whole(m_comm, triangulate(own, reach, stray), m_partition, reach);
    piece.mesh.number_of_renewals = renewals + 1;
  }

  bool has_valid_outline(const Distributed_mesh_2& mesh) const
  {
    Bubbles_2 bubbles;
    for (const Bubble_record_2& r : gather_outline(m_comm, mesh.bubbles))
      add_own(bubbles, r);
    bubbles.sort_by_id();
    Marked_triangles_2 outline;
    return triangulate_outline(m_domain, bubbles, outline);
  }

  /// inserts and deletes bubbles around bad triangles; returns whether there was something to be done
  bool operate_once(Mesh_piece_2& piece, double bad_quality, double smallest, Treatment_counts& counts,
                    bool& has_changed_outline) const
  {
    std::optional<Distributed_surgery_2> surgery(std::in_place, m_domain, piece, smallest, m_comm);
    for (double reach = m_reach; !surgery->find_patches(bad_quality); reach *= 2) { // they are cut off
      renew(piece, reach);
      surgery.emplace(m_domain, piece, smallest, m_comm);
    }
    const std::int64_t end = static_cast<std::int64_t>(number_of_bubbles(piece.mesh));
    const Patch_changes_2 changes = surgery->operate(end);
    if (surgery->number_of_insertions + surgery->number_of_deletions == 0)
      return false;
    counts.inserted += static_cast<std::size_t>(surgery->number_of_insertions);
    counts.deleted += static_cast<std::size_t>(surgery->number_of_deletions);
    Piece_stitching_2 stitch(piece, m_comm);
    if (!stitch(changes, end))
      renew(piece, m_reach);
    has_changed_outline = has_changed_outline || stitch.has_changed_outline;
    return true;
  }

  /// inserts points that all ranks want, each on the rank that owns its place, and triangulates
  Mesh with_points(const std::vector<Steiner_point_2>& points, const Mesh& mesh) const
  {
    Bubbles_2 own = own_bubbles(mesh, m_comm.rank());
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

  std::size_t number_of_all(std::size_t here) const
  {
    return static_cast<std::size_t>(m_comm.sum(static_cast<std::int64_t>(here)));
  }

  const Problem_2& m_problem;
  const Domain_2& m_domain;
  const Bubbles_2& m_points;
  const Hilbert_partition_2 m_partition;
  Communicator& m_comm;
  const double m_reach;
};

/// Collective. The triangulation of the simulated bubbles of all ranks, as `triangulate_and_treat()` makes it on one. What it
/// adds to the report are counts of all ranks. `points`: those that were given on this rank.
inline Distributed_mesh_2 treat_distributed(const Problem_2& problem, const Bubbles_2& points,
                                            const Placed_part_2& part, Communicator& comm, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  problem.options.progress->start_phase(Bubble_phase::TREATMENT);
  const Distributed_treatment_2 treatment(problem, points, part.partition, comm);
  Distributed_mesh_2 mesh = treatment.triangulate(part.bubbles);
  treat(treatment, mesh, report);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H
