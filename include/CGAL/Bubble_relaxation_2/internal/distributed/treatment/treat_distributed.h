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

/// `treat_defects()` by ranks: moves, insertions and deletions are those of one rank. Each works on a piece of the mesh
/// that is wider than its own triangles and gets narrower with what is done; when nothing wider is left, the pieces are
/// made anew from where the bubbles are then.
class Distributed_treatment_2
{
public:
  /// `reach`: how much wider the pieces are, in units of d \pre it is positive
  Distributed_treatment_2(const Domain_2& domain, const Hilbert_partition_2& partition, Communicator& comm,
                          double reach = usual_reach)
    : m_domain(domain), m_partition(partition), m_comm(comm), m_reach(reach)
  {}

  /// Collective. The mesh of all ranks' bubbles, each of which is at home.
  Distributed_mesh_2 triangulate(const Bubbles_2& own) const { return triangulate(own, m_reach, 0); }

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
  Misfit_counts count_misfits(const Distributed_mesh_2& mesh) const
  {
    const Misfit_counts counts = internal::count_misfits(mesh, mesh.is_owned);
    return {m_comm.sum(counts.misfits), m_comm.sum(counts.all)};
  }

  /// Collective. \pre `mesh` was made by `triangulate()`. Afterwards bubbles may have left their homes.
  Treatment_counts operator()(Distributed_mesh_2& mesh, bool may_operate) const
  {
    Treatment_counts counts;
    double smallest = smallest_quality(mesh);
    if (smallest >= treated_quality)
      return counts;
    Mesh_piece_2 piece = piece_of_whole(m_comm, std::move(mesh), m_partition, m_reach);
    counts.treated = smooth(piece, smallest, sweeps_before_surgery);
    if (may_operate)
      operate(piece, smallest, counts);
    counts.treated += smooth(piece, smallest, Smoothing_sweeps_2::number_of_sweeps);
    mesh = std::move(piece.mesh);
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
    piece = piece_of_whole(m_comm, triangulate(own, reach, farthest_stray(m_comm, m_partition, own)), m_partition, reach);
    piece.mesh.number_of_renewals = renewals + 1;
  }

  /// moves vertices, unless the mesh gets worse by that; returns how many were moved
  std::size_t smooth(Mesh_piece_2& piece, double& smallest, int most_sweeps) const
  {
    if (smallest >= treated_quality)
      return 0;
    Distributed_mesh_2& mesh = piece.mesh;
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
    return static_cast<std::size_t>(m_comm.sum(static_cast<std::int64_t>(moved.size())));
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

  void operate(Mesh_piece_2& piece, double& smallest, Treatment_counts& counts) const
  {
    if (smallest >= bad_qualities[0])
      return; // ranks need not know more of each other
    Treatment_counts changes;
    Mesh_piece_2 last = piece;
    bool has_changed_outline = false;
    double smallest_now = -1;
    try {
      for (double bad_quality : bad_qualities)
        if (!operate_once(last, bad_quality, changes, has_changed_outline))
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

  /// inserts and deletes bubbles around bad triangles; returns whether there was something to be done
  bool operate_once(Mesh_piece_2& piece, double bad_quality, Treatment_counts& counts, bool& has_changed_outline) const
  {
    std::optional<Distributed_surgery_2> surgery(std::in_place, m_domain, piece, m_comm);
    for (double reach = m_reach; !surgery->find_patches(bad_quality); reach *= 2) { // they are cut off
      renew(piece, reach);
      surgery.emplace(m_domain, piece, m_comm);
    }
    const std::int64_t end = number_of_bubbles(piece.mesh);
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

  const Domain_2& m_domain;
  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  const double m_reach;
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
      (may_operate && treat.count_misfits(given_mesh).is_worse_than(treat.count_misfits(mesh))))
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
    if (find_bad(result == 0 ? mesh : refined) == 0)
      break;
    if (result == 0) { // after treatment a rank does not know where others' bubbles on edges are
      refined = insert_points(problem, partition, comm, {}, mesh);
      find_bad(refined);
    }
    std::vector<Steiner_point_2> points;
    comm.agree_after([&] { points = wanted_points(problem, refined, bad); });
    if (is_endless(result + number_of_all(points.size()), number_of_vertices))
      return 0;
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
  options.progress->start_phase(Bubble_phase::TREATMENT);
  const Distributed_treatment_2 treat(problem.domain, part.partition, comm);
  Distributed_mesh_2 mesh = treat.triangulate(part.bubbles);
  if (is_treatment_due(options, report)) {
    const bool may_operate = options.population != Bubble_population::NONE;
    Treatment_counts counts = treat(mesh, may_operate);
    if (keeps_given_bubbles(options))
      keep_the_better_of_all(problem, points, may_operate, comm, mesh, counts);
    if (may_operate)
      counts.inserted += refine_small_angles_of_all(problem, part.partition, comm, mesh);
    counts.add_to(report);
  }
  if (comm.any(is_stop_wanted())) // what was left of it was not done
    tell_that_it_was_stopped(report);
  return mesh;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREAT_DISTRIBUTED_H
