// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Team_of_ranks.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
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
  Treatment_team_2(Communicator& comm, Mesh_piece_2& piece, std::function<void()> renew)
    : Team_of_ranks(comm), m_piece(piece), m_renew(std::move(renew))
  {
    start();
  }

  bool is_alone() const override { return m_comm.size() == 1; }

  std::size_t largest_number(std::size_t here) const override
  {
    return static_cast<std::size_t>(m_comm.largest(static_cast<std::int64_t>(here)));
  }

  void share(std::vector<char>& values) override { m_piece.shared.share(m_comm, values); }

  void share_moved(Bubble_mesh_2& mesh, const std::vector<Index>& moved, Undo_log_2& log) override
  {
    if (is_alone())
      return;
    Bubbles_2& b = mesh.bubbles;
    Messages<Move> out, in;
    for (const auto& list : m_piece.shared.sent)
      out[list.first];
    for (const auto& list : m_piece.shared.received)
      in[list.first].resize(list.second.size());
    for (Index v : moved)
      for (const auto& target : m_targets[v])
        out[target.first].push_back(Move{target.second, b.host[v], b.x[v], b.y[v], b.s[v]});
    deliver_expected(m_comm, out, in);
    for (const auto& message : in)
      for (const Move& m : message.second) {
        const Index v = m_piece.shared.received.at(message.first)[m.position];
        log.note(Undo_log_2::vertex(b, v));
        b.host[v] = m.host;
        b.x[v] = m.x;
        b.y[v] = m.y;
        b.s[v] = m.s;
        m_was_moved[v] = 1;
        m_moved.push_back(v);
      }
  }

  bool restore_border(Editable_triangulation_2& mesh, Undo_log_2& log, std::vector<Index>& moved,
                      std::vector<char>& was_moved) override
  {
    follow_flips(mesh);
    if (is_alone())
      return false;
    for (Index t : m_beside_others)
      if (mesh.is_inside(t) && has_moved_vertex(mesh.vertices(t)))
        mesh.restore_delaunay_around(t);
    follow_flips(mesh);
    if (!m_comm.any(!forget_doubtful(m_beside_others, *m_certificate, mesh)))
      return false;
    renew(log, moved, was_moved);
    return true;
  }

  /// Makes the piece what it was at first if it was made anew since; returns whether it was.
  bool undo()
  {
    if (m_before)
      m_piece = *std::move(m_before);
    return m_before.has_value();
  }

  void add_neighbors_of_others(const Editable_triangulation_2& mesh, std::vector<Index>& result) override
  {
    if (is_alone())
      return;
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

  /// the triangles that are not marked as what they are now, and perhaps some more
  const std::vector<Index>& changed_triangles() const { return m_beside_others; }

private:
  void start()
  {
    const std::size_t n = m_piece.mesh.bubbles.size();
    m_targets = Lists_of_few<std::pair<int, std::int32_t>>(n);
    for (const auto& list : m_piece.shared.sent)
      for (std::size_t k = 0; k < list.second.size(); ++k)
        m_targets.add(list.second[k], {list.first, static_cast<std::int32_t>(k)});
    m_beside_others = triangles_beside_others(m_piece.mesh);
    m_certificate.emplace(m_piece.mesh);
    m_was_moved.assign(n, 0);
    m_moved.clear();
  }

  void renew(Undo_log_2& log, std::vector<Index>& moved, std::vector<char>& was_moved)
  {
    const Bubbles_2& b = m_piece.mesh.bubbles;
    std::vector<std::int64_t> moved_now, moved_ever;
    for (Index v : moved)
      moved_now.push_back(b.id[v]);
    for (Index v : marked(was_moved))
      moved_ever.push_back(b.id[v]);
    if (!m_before)
      log.undo(m_before.emplace(m_piece).mesh);
    log = Undo_log_2();
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

  struct Move
  {
    std::int32_t position;
    Index host;
    double x, y, s;
  };

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

  Mesh_piece_2& m_piece;
  const std::function<void()> m_renew;
  std::optional<Mesh_piece_2> m_before; // the first that was made anew
  /// of each own bubble: the ranks that know it, and its position in the lists of both
  Lists_of_few<std::pair<int, std::int32_t>> m_targets;
  std::vector<Index> m_beside_others; // triangles, and all that were flipped, wherever they are
  std::optional<Border_certificate_2> m_certificate;
  std::vector<char> m_was_moved; // of others' bubbles, in this sweep
  std::vector<Index> m_moved;    // those
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H
