// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TREATMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TREATMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_surgery_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Treatment_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/compact_numbers.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distribute_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/distributed_triangulate.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/widen_mesh.h>
#include <CGAL/Bubble_relaxation_2/internal/Outside_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Treatment_counts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// `treat_defects()` by ranks: moves, insertions and deletions are those of one rank. Each works on a piece of the
/// mesh that is wider than its own triangles; if it was not wide enough, all begin again with a wider one.
class Distributed_treatment_2
{
public:
  /// `first_reach`: how much wider the pieces are at first, in units of d
  Distributed_treatment_2(const Domain_2& domain, const Hilbert_partition_2& partition, const Communicator& comm,
                          Agreement& agreement, Sparse_exchange& exchange, double first_reach = usual_reach)
    : m_domain(domain), m_partition(partition), m_comm(comm), m_agreement(agreement), m_exchange(exchange),
      m_first_reach(first_reach)
  {}

  /// Collective. The mesh of all ranks' bubbles, each of which is at home.
  Distributed_mesh_2 triangulate(const Numbered_bubbles_2& own) const
  {
    Distributed_mesh_2 mesh =
      distributed_triangulate(m_domain, own, m_partition, m_comm, m_agreement, m_exchange);
    label_edges(mesh.triangulation);
    return mesh;
  }

  /// Collective.
  double smallest_quality(const Distributed_mesh_2& mesh) const
  {
    double smallest = 1;
    m_agreement.reach_after([&] {
      for (std::size_t t = 0; t < mesh.is_owned.size(); ++t)
        if (mesh.is_owned[t])
          smallest = (std::min)(smallest, quality(mesh.triangulation.tr, static_cast<Index>(t)));
    });
    return m_comm.smallest(smallest);
  }

  /// Collective. \pre `mesh` was made by `triangulate()`. Afterwards bubbles may have left their homes.
  Treatment_counts operator()(Distributed_mesh_2& mesh, bool may_operate) const
  {
    Treatment_counts counts;
    double smallest = smallest_quality(mesh);
    counts.treated = smooth(mesh, smallest);
    if (may_operate)
      operate(mesh, smallest, counts);
    return counts;
  }

  /// Collective.
  std::int64_t number_of_bubbles(const Distributed_mesh_2& mesh) const
  {
    return m_comm.sum(std::count(mesh.known.owners.begin(), mesh.known.owners.end(), m_comm.rank()));
  }

  /// Collective. The bubbles of a mesh, brought home.
  Numbered_bubbles_2 bubbles(const Distributed_mesh_2& mesh) const
  {
    Numbered_bubbles_2 own;
    own.make_room_for(mesh.known.size());
    for (std::size_t i = 0; i < mesh.known.size(); ++i)
      if (mesh.known.owners[i] == m_comm.rank())
        own.add(record(mesh.known.bubbles, i, mesh.known.numbers[i]));
    return at_home(std::move(own));
  }

private:
  static constexpr double usual_reach = 8; // enough for the sweeps of most meshes, and for patches

  Mesh_piece_2 widen(const Distributed_mesh_2& mesh, double reach) const
  {
    return Mesh_widening_2(mesh, m_partition, m_comm, m_agreement, m_exchange)(reach);
  }

  std::size_t smooth(Distributed_mesh_2& mesh, double& smallest) const
  {
    if (smallest >= Defect_treatment_2<Sequential_tag>::treated_quality)
      return 0;
    for (double reach = m_first_reach;; reach *= 2) {
      Mesh_piece_2 piece = widen(mesh, reach);
      Treatment_team_2 team(m_comm, piece);
      Bubbles_2& bubbles = piece.mesh.known.bubbles;
      const std::vector<Index> moved = Defect_treatment_2<Sequential_tag, Treatment_team_2>(
        m_domain, piece.mesh.triangulation, bubbles, team)();
      if (team.has_failed())
        continue;
      piece.mesh.mark_triangles(m_comm.rank());
      const double smallest_now = smallest_quality(piece.mesh);
      const bool moves_outline =
        std::any_of(moved.begin(), moved.end(), [&](Index v) { return bubbles.is_on_edge(v); });
      // the moves made none worse, but flips can; and parts of the outline can be as near as a rounding
      if (smallest_now < smallest || (m_comm.any(moves_outline) && !has_valid_outline(piece.mesh)))
        return 0;
      smallest = smallest_now;
      mesh = std::move(piece.mesh);
      return static_cast<std::size_t>(m_comm.sum(static_cast<std::int64_t>(moved.size())));
    }
  }

  bool has_valid_outline(const Distributed_mesh_2& mesh) const
  {
    std::vector<Bubble_record_2> own;
    for (std::size_t i = 0; i < mesh.known.size(); ++i)
      if (mesh.known.owners[i] == m_comm.rank() && is_on_outline(mesh.known.bubbles, i))
        own.push_back(record(mesh.known.bubbles, i, mesh.known.numbers[i]));
    std::vector<Bubble_record_2> all = gather_records(m_comm, own);
    bool is_valid = false;
    m_agreement.reach_after([&] {
      std::sort(all.begin(), all.end(), [](const Bubble_record_2& r, const Bubble_record_2& s) {
        return r.number < s.number;
      });
      Bubbles_2 bubbles;
      for (const Bubble_record_2& r : all)
        add(bubbles, r);
      Marked_triangulation_2 outline;
      is_valid = triangulate_outline(m_domain, bubbles, outline);
    });
    return is_valid;
  }

  void operate(Distributed_mesh_2& mesh, double smallest, Treatment_counts& counts) const
  {
    for (double bad_quality : bad_qualities) {
      if (smallest >= bad_quality)
        break;
      Treatment_counts changes;
      Numbered_bubbles_2 changed_bubbles = operate_once(mesh, bad_quality, changes);
      if (changes.inserted + changes.deleted == 0)
        break;
      // rounding can make a mess of a change; then what was there is good
      Distributed_mesh_2 changed;
      const bool is_valid = try_to_triangulate(at_home(std::move(changed_bubbles)), changed);
      double smallest_now = is_valid ? smallest_quality(changed) : 0.;
      changes.treated = is_valid ? smooth(changed, smallest_now) : 0;
      if (!is_valid || smallest_now < smallest)
        break;
      smallest = smallest_now;
      mesh = std::move(changed);
      counts += changes;
    }
  }

  /// inserts and deletes bubbles around the worst triangles; returns all that a rank has then
  Numbered_bubbles_2 operate_once(const Distributed_mesh_2& mesh, double bad_quality, Treatment_counts& counts) const
  {
    const std::int64_t end = number_of_bubbles(mesh);
    for (double reach = m_first_reach;; reach *= 2) {
      const Mesh_piece_2 piece = widen(mesh, reach);
      Distributed_surgery_2 surgery(m_domain, piece, m_partition, m_comm, m_agreement, m_exchange);
      if (!surgery.find_patches(bad_quality, most_operations(static_cast<std::size_t>(end))))
        continue;
      Numbered_bubbles_2 changed = surgery.operate(end);
      counts.inserted = static_cast<std::size_t>(surgery.number_of_insertions);
      counts.deleted = static_cast<std::size_t>(surgery.number_of_deletions);
      return changed;
    }
  }

  /// brings bubbles to the ranks that own their places, and numbers them without gaps
  Numbered_bubbles_2 at_home(Numbered_bubbles_2 bubbles) const
  {
    const std::vector<std::int64_t>& numbers = bubbles.numbers;
    const std::int64_t last = numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
    const std::int64_t end = m_comm.largest(last) + 1;
    Numbered_bubbles_2 home = bring_home(m_partition, m_exchange, m_comm.rank(), std::move(bubbles));
    compact_numbers(m_comm, m_exchange, end, home.numbers);
    return home;
  }

  /// on all ranks or on none
  bool try_to_triangulate(const Numbered_bubbles_2& own, Distributed_mesh_2& mesh) const
  {
    try {
      mesh = triangulate(own);
      return true;
    } catch (const std::runtime_error&) {
      m_comm.all_go_on();
      return false;
    }
  }

  const Domain_2& m_domain;
  const Hilbert_partition_2& m_partition;
  const Communicator& m_comm;
  Agreement& m_agreement;
  Sparse_exchange& m_exchange;
  const double m_first_reach;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_DISTRIBUTED_TREATMENT_2_H
