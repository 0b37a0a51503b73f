// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Part_team_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The ranks that treat the defects of a mesh together, see `Team`. Each treats its own vertices, and
/// moves those of others as it is told. Its piece of the mesh gets narrower with each sweep, by what bubbles that it
/// does not know may have changed; when triangles around its own vertices are concerned, the pieces are made anew.
class Treatment_team_2 : public Team_of_ranks
{
public:
  /// `renew`: makes the pieces of all ranks anew from where their bubbles are
  Treatment_team_2(Communicator& comm, const Domain_2& domain, Mesh_piece_2& piece, std::function<void()> renew)
    : Team_of_ranks(comm), m_domain(domain), m_piece(piece), m_renew(std::move(renew))
  {
    start();
  }

  void share(std::vector<char>& values) override { share_values(m_comm, m_piece.shared, values); }

  void share_moved(Bubble_mesh_2& mesh, const std::vector<Index>& moved) override
  {
    Bubbles_2& b = mesh.bubbles;
    std::vector<char> is_told(b.size(), 0);
    for (Index v : moved)
      is_told[v] = 1;
    using Vertex = Undo_log_2::Vertex; // in messages by its position among those that are shared
    Shared_delivery<Vertex> delivery(m_comm);
    delivery.start(m_piece.shared, [&](Index v, std::size_t position, std::vector<Vertex>& message) {
      if (!is_told[v])
        return;
      message.push_back(Undo_log_2::vertex(b, v));
      message.back().bubble = static_cast<Index>(position);
    });
    delivery.finish(m_piece.shared, [&](const std::vector<Index>& list, const std::vector<Vertex>& message) {
      for (Vertex moved_there : message) {
        const Index v = moved_there.bubble = list[moved_there.bubble];
        Undo_log_2::put(moved_there, b);
        m_was_moved[v] = 1;
        m_moved.push_back(v);
      }
    });
  }

  bool restore_border(Editable_triangulation_2& mesh, std::vector<Index>& moved, std::vector<char>& was_moved) override
  {
    const std::vector<Index> changed = restore_delaunay(mesh, moved);
    const std::vector<Point> places = places_of_moved(mesh, changed, was_moved);
    Border_check_2 check(mesh, m_domain.bbox(), changed, places);
    if (!m_comm.any(!check.forget_doubtful(m_beside_others)))
      return false;
    renew(moved, was_moved);
    return true;
  }

  void add_neighbors_of_others(const Editable_triangulation_2& mesh, std::vector<Index>& result) override
  {
    const Bubbles_2& b = mesh.mesh().bubbles;
    for (Index t : m_beside_others)
      if (mesh.is_inside(t) && has_moved_vertex(mesh.vertices(t)))
        for (Index v : mesh.vertices(t))
          if (b.is_ours(v) && b.can_move(v))
            result.push_back(v);
    for (Index v : m_moved)
      m_was_moved[v] = 0;
    m_moved.clear();
  }

private:
  void start()
  {
    const std::size_t n = m_piece.mesh.bubbles.size();
    m_beside_others = triangles_beside_others(m_piece.mesh);
    m_was_moved.assign(n, 0);
    m_moved.clear();
    assign_in_turn(m_holders, n, {});
    for (const auto& list : m_piece.shared.sent)
      for (Index v : list.second)
        m_holders[v].push_back(list.first);
  }

  void renew(std::vector<Index>& moved, std::vector<char>& was_moved)
  {
    const Bubbles_2& b = m_piece.mesh.bubbles;
    std::vector<std::int64_t> moved_now, moved_ever;
    for (Index v : moved)
      moved_now.push_back(b.id[v]);
    for (Index v : marked(was_moved))
      moved_ever.push_back(b.id[v]);
    m_renew();
    start();
    std::transform(moved_now.begin(), moved_now.end(), moved.begin(),
                   [&b](std::int64_t number) { return b.index_of(number); });
    was_moved.assign(b.size(), 0);
    for (std::int64_t number : moved_ever)
      was_moved[b.index_of(number)] = 1;
    for (Index v : moved)
      m_was_moved[v] = 1;
    share(m_was_moved);
    for (Index v : moved)
      m_was_moved[v] = 0;
    m_moved = marked(m_was_moved);
  }

  /// flips edges around vertices of others, too; returns the triangles that were flipped or have a vertex that was moved
  std::vector<Index> restore_delaunay(Editable_triangulation_2& mesh, const std::vector<Index>& moved)
  {
    const std::size_t first_flipped = m_beside_others.size();
    follow_flips(mesh);
    for (Index t : m_beside_others)
      if (mesh.is_inside(t) && has_moved_vertex(mesh.vertices(t)))
        mesh.restore_delaunay_around(t);
    follow_flips(mesh);
    std::vector<Index> changed(m_beside_others.begin() + static_cast<std::ptrdiff_t>(first_flipped), m_beside_others.end());
    for (Index t : m_beside_others)
      if (has_moved_vertex(mesh.vertices(t)))
        changed.push_back(t);
    for (Index v : moved)
      for (const Corner_2& c : mesh.star(v))
        changed.push_back(c.triangle);
    return changed;
  }

  /// Collective. Where vertices of others are that were moved: such as are known here, which may have lost all their
  /// triangles, and unknown ones that have come into the circle of a triangle. Each vertex w of that is a neighbour of such
  /// a moved vertex v now. Who owns w tells those who have it; and who owns v tells the owner of w, who may not have v.
  /// `was_moved`: in this sweep or before, so that too much is told at most
  std::vector<Point> places_of_moved(const Editable_triangulation_2& mesh, const std::vector<Index>& changed,
                                     const std::vector<char>& was_moved) const
  {
    const Bubbles_2& b = m_piece.mesh.bubbles;
    std::set<std::pair<int, Index>> told; // who, and of what
    const auto tell = [&](int rank, Index v) {
      if (rank != b.owner[v] && !is_among(m_holders[v], rank))
        told.emplace(rank, v);
    };
    for (Index t : changed)
      for (Index v : mesh.vertices(t)) {
        if (!was_moved[v] && !m_was_moved[v])
          continue;
        for (Index w : mesh.vertices(t)) {
          for (int rank : m_holders[w])
            tell(rank, v);
          if (b.is_ours(v))
            tell(b.owner[w], v);
        }
      }
    Messages<std::array<double, 2>> out;
    for (const auto& [rank, v] : told)
      out[rank].push_back({b.x[v], b.y[v]});
    std::vector<Point> result;
    deliver(m_comm, out, [&](int, const std::array<double, 2>& p) { result.emplace_back(p[0], p[1]); });
    for (Index v : m_moved)
      result.push_back(b.point(v));
    return result;
  }

  /// flipped triangles may have a bubble of another rank now
  void follow_flips(Editable_triangulation_2& mesh)
  {
    const std::vector<Index> flipped = mesh.take_flipped();
    m_beside_others.insert(m_beside_others.end(), flipped.begin(), flipped.end());
  }

  bool has_moved_vertex(const std::array<Index, 3>& v) const
  {
    return m_was_moved[v[0]] || m_was_moved[v[1]] || m_was_moved[v[2]];
  }

  const Domain_2& m_domain;
  Mesh_piece_2& m_piece;
  const std::function<void()> m_renew;
  std::vector<Index> m_beside_others; // triangles, and all that were flipped, wherever they are
  std::vector<char> m_was_moved; // of others' bubbles, in this sweep
  std::vector<Index> m_moved;    // those
  std::vector<Hilbert_partition_2::Ranks> m_holders; // other ranks that have a bubble of ours
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H
