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
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// `treat_defects()` by ranks: moves, insertions and deletions are those of one rank. Each works on a piece of the mesh
/// that is wider than its own triangles; if that was not wide enough, all begin again with a wider one.
class Distributed_treatment_2
{
public:
  /// `first_reach`: how much wider the pieces are at first, in units of d \pre it is positive
  Distributed_treatment_2(const Domain_2& domain, const Hilbert_partition_2& partition, Communicator& comm,
                          double first_reach = usual_reach)
    : m_domain(domain), m_partition(partition), m_comm(comm), m_first_reach(first_reach)
  {}

  /// Collective. The mesh of all ranks' bubbles, each of which is at home.
  Distributed_mesh_2 triangulate(const Bubbles_2& own) const
  {
    Distributed_mesh_2 mesh = distributed_triangulate(m_domain, own, m_partition, m_comm);
    label_edges(mesh.triangles);
    return mesh;
  }

  /// Collective.
  double smallest_quality(const Distributed_mesh_2& mesh) const
  {
    double smallest = 1;
    for (std::size_t t = 0; t < mesh.is_owned.size(); ++t)
      if (mesh.is_owned[t])
        smallest = (std::min)(smallest, quality(mesh, static_cast<Index>(t)));
    return m_comm.smallest(smallest);
  }

  /// Collective.
  std::int64_t number_of_misfits(const Distributed_mesh_2& mesh) const
  {
    std::int64_t n = 0;
    for (std::size_t t = 0; t < mesh.is_owned.size(); ++t)
      n += mesh.is_owned[t] && is_misfit(mesh, static_cast<Index>(t));
    return m_comm.sum(n);
  }

  /// Collective. \pre `mesh` was made by `triangulate()`. Afterwards bubbles may have left their homes.
  Treatment_counts operator()(Distributed_mesh_2& mesh, bool may_operate) const
  {
    Treatment_counts counts;
    double smallest = smallest_quality(mesh);
    if (smallest >= treated_quality)
      return counts;
    Treated_piece piece{Mesh_piece_2{std::move(mesh), {}, {}}, m_first_reach, false};
    widen(piece);
    counts.treated = smooth(piece, smallest, sweeps_before_surgery);
    if (may_operate)
      operate(piece, smallest, counts);
    counts.treated += smooth(piece, smallest, Smoothing_sweeps_2::number_of_sweeps);
    mesh = std::move(piece.piece.mesh);
    return counts;
  }

  /// Collective.
  std::int64_t number_of_bubbles(const Distributed_mesh_2& mesh) const
  {
    return m_comm.sum(std::count(mesh.bubbles.owner.begin(), mesh.bubbles.owner.end(), m_comm.rank()));
  }

private:
  static constexpr double treated_quality = Smoothing_sweeps_2::treated_quality;
  static constexpr double usual_reach = 12; // enough for the sweeps of most meshes, before and after surgery

  enum class Smoothing { KEPT, TAKEN_BACK, TOO_NARROW };

  /// a piece, which gets narrower with what is done to it
  struct Treated_piece
  {
    Mesh_piece_2 piece;
    double reach;
    bool is_as_wide; ///< as `reach` says
    bool has_changed_outline = false; ///< by surgery
  };

  /// makes it as wide as it was meant to be; if it is so and that is too narrow, twice as wide
  void widen(Treated_piece& p) const
  {
    if (p.is_as_wide)
      p.reach *= 2;
    p.piece = Mesh_widening_2(std::move(p.piece.mesh), m_partition, m_comm)(p.reach);
    p.is_as_wide = true;
    ++p.piece.mesh.number_of_widenings;
  }

  /// moves vertices; returns how many were moved
  std::size_t smooth(Treated_piece& p, double& smallest, int most_sweeps) const
  {
    std::size_t number = 0;
    if (smallest >= treated_quality)
      return number;
    for (;; widen(p)) {
      const Smoothing result = try_to_smooth(p, smallest, most_sweeps, number);
      if (result == Smoothing::TOO_NARROW)
        continue;
      p.is_as_wide = p.is_as_wide && result == Smoothing::TAKEN_BACK;
      return number;
    }
  }

  /// Moves vertices, unless the mesh gets worse by that or a rank knows too little.
  Smoothing try_to_smooth(Treated_piece& p, double& smallest, int most_sweeps, std::size_t& number) const
  {
    Distributed_mesh_2& mesh = p.piece.mesh;
    Bubbles_2& bubbles = mesh.bubbles;
    Treatment_team_2 team(m_comm, p.piece);
    Smoothing_sweeps_2 treat(m_domain, mesh, team);
    const std::vector<Index> moved = treat(most_sweeps);
    if (team.has_failed()) {
      treat.undo();
      ++mesh.number_of_failed_treatments;
      return Smoothing::TOO_NARROW;
    }
    mesh.mark_triangles(team.changed_triangles(), m_comm.rank());
    const double smallest_now = smallest_quality(mesh);
    const bool moves_outline =
      std::any_of(moved.begin(), moved.end(), [&](Index v) { return bubbles.is_on_edge(v); });
    // the moves made none worse, but flips can; and parts of the outline can be as near as a rounding
    if (smallest_now < smallest || (m_comm.any(moves_outline) && !has_valid_outline(mesh))) {
      treat.undo();
      mesh.mark_triangles(team.changed_triangles(), m_comm.rank());
      return Smoothing::TAKEN_BACK;
    }
    smallest = smallest_now;
    number = static_cast<std::size_t>(m_comm.sum(static_cast<std::int64_t>(moved.size())));
    return Smoothing::KEPT;
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

  void operate(Treated_piece& piece, double& smallest, Treatment_counts& counts) const
  {
    if (smallest >= bad_qualities[0])
      return; // ranks need not know more of each other
    Treatment_counts changes;
    std::optional<Treated_piece> last;
    for (double bad_quality : bad_qualities) {
      std::optional<Treated_piece> next = operate_once(last ? *last : piece, bad_quality, changes);
      if (!next)
        break;
      last = std::move(next);
    }
    if (!last)
      return;
    const double smallest_now = smallest_quality(last->piece.mesh);
    // rounding can make a mess of a change; then what was there is good
    if (smallest_now < smallest || (m_comm.any(last->has_changed_outline) && !has_valid_outline(last->piece.mesh)))
      return;
    smallest = smallest_now;
    piece = std::move(*last);
    counts += changes;
  }

  /// inserts and deletes bubbles around bad triangles; returns nothing if there is nothing to be done
  std::optional<Treated_piece> operate_once(Treated_piece& p, double bad_quality, Treatment_counts& counts) const
  {
    const std::int64_t end = number_of_bubbles(p.piece.mesh);
    for (;; widen(p)) {
      Distributed_surgery_2 surgery(m_domain, p.piece, m_comm);
      if (!surgery.find_patches(bad_quality))
        continue;
      const Patch_changes_2 changes = surgery.operate(end);
      if (surgery.number_of_insertions + surgery.number_of_deletions == 0)
        return std::nullopt;
      Treated_piece changed{p.piece, p.reach, false, p.has_changed_outline};
      Piece_stitching_2 stitch(changed.piece, m_comm);
      if (!stitch(changes, end))
        continue;
      changed.has_changed_outline = changed.has_changed_outline || stitch.has_changed_outline;
      counts.inserted += static_cast<std::size_t>(surgery.number_of_insertions);
      counts.deleted += static_cast<std::size_t>(surgery.number_of_deletions);
      return changed;
    }
  }

  const Domain_2& m_domain;
  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  const double m_first_reach;
};

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

/// `keep_the_better()` by ranks: given bubbles whose mesh is better than what was made of them are treated instead.
inline void keep_the_better_of_all(const Problem_2& problem, const Bubbles_2& points, bool may_operate,
                                   Communicator& comm, Distributed_mesh_2& mesh, Treatment_counts& counts)
{
  const Placed_part_2 given = given_bubbles_distributed(comm, problem, points);
  const Distributed_treatment_2 treat(problem.domain, given.partition, comm);
  Distributed_mesh_2 given_mesh = treat.triangulate(given.bubbles);
  if (treat.smallest_quality(given_mesh) <= treat.smallest_quality(mesh) ||
      (may_operate && treat.number_of_misfits(given_mesh) > treat.number_of_misfits(mesh)))
    return;
  counts = treat(given_mesh, may_operate);
  mesh = std::move(given_mesh);
}

/// Collective. Inserts points that all ranks want, each on the rank that owns its place, and triangulates.
inline Distributed_mesh_2 insert_points(const Problem_2& problem, const Hilbert_partition_2& partition, Communicator& comm,
                                        const std::vector<Steiner_point_2>& points, const Distributed_mesh_2& mesh)
{
  Bubbles_2 own = own_bubbles(mesh, comm.rank());
  std::int64_t end = comm.sum(static_cast<std::int64_t>(own.size()));
  comm.agree_after([&] {
    for (const Steiner_point_2& p : points) {
      Bubbles_2 one;
      one.add(Point(p.x, p.y), problem.sizes(p.x, p.y), p.dimension, p.host, p.s);
      if (partition.owner(p.x, p.y) == comm.rank())
        add_own(own, record(one, 0, end));
      ++end;
    }
  });
  return triangulate_from_anywhere(problem.domain, partition, comm, end, std::move(own));
}

/// Collective. `refine_small_angles()` by ranks.
inline std::size_t refine_small_angles_of_all(const Problem_2& problem, const Hilbert_partition_2& partition,
                                              Communicator& comm, Distributed_mesh_2& mesh)
{
  const auto number_of_all = [&comm](std::size_t n) { return static_cast<std::size_t>(comm.sum(static_cast<std::int64_t>(n))); };
  const std::size_t number_of_vertices = number_of_all(own_bubbles(mesh, comm.rank()).size());
  Distributed_mesh_2 refined;
  std::size_t result = 0;
  for (;;) {
    std::vector<Index> bad;
    const auto find_bad = [&](const Distributed_mesh_2& m) {
      comm.agree_after([&] { bad = triangles_to_refine(problem, m, m.is_owned); });
      return number_of_all(bad.size());
    };
    const std::size_t number_of_bad = find_bad(result == 0 ? mesh : refined);
    if (number_of_bad == 0)
      break;
    if (is_endless(result + number_of_bad, number_of_vertices))
      return 0;
    if (result == 0) { // after treatment a rank does not know where others' bubbles on edges are
      refined = insert_points(problem, partition, comm, {}, mesh);
      find_bad(refined);
    }
    std::vector<Steiner_point_2> points;
    comm.agree_after([&] { points = wanted_points(problem, refined, bad); });
    points = Angle_refinement_2::independent(gather_records(comm, points));
    if (points.empty())
      break;
    try {
      Distributed_mesh_2 next = insert_points(problem, partition, comm, points, refined);
      if (number_of_all(own_bubbles(next, comm.rank()).size()) != number_of_vertices + result + points.size())
        break; // finer than coordinates can tell
      refined = std::move(next);
    } catch (const std::runtime_error&) {
      break; // the same, on all ranks
    }
    result += points.size();
  }
  const auto smallest = [&comm](const Distributed_mesh_2& m) { return comm.smallest(smallest_free_sine(m, m.is_owned)); };
  if (result == 0 || smallest(refined) < smallest(mesh))
    return 0;
  mesh = std::move(refined);
  return result;
}

/// Collective. The triangulation of the simulated bubbles of all ranks, as `triangulate_and_treat()` makes it on one. What it
/// adds to the report are counts of all ranks. `points`: those that were given on this rank.
inline Distributed_mesh_2 treat_distributed(const Problem_2& problem, const Bubbles_2& points,
                                            const Placed_part_2& part, Communicator& comm, Report& report)
{
  const Relaxation_options& options = problem.options;
  const Phase_timer timer(report.seconds.treatment);
  const Distributed_treatment_2 treat(problem.domain, part.partition, comm);
  Distributed_mesh_2 mesh = treat.triangulate(part.bubbles);
  if (!is_treatment_due(options, report))
    return mesh;
  const bool may_operate = options.population != Bubble_population::NONE;
  Treatment_counts counts = treat(mesh, may_operate);
  if (keeps_given_bubbles(options))
    keep_the_better_of_all(problem, points, may_operate, comm, mesh, counts);
  if (may_operate)
    counts.inserted += refine_small_angles_of_all(problem, part.partition, comm, mesh);
  counts.add_to(report);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H
