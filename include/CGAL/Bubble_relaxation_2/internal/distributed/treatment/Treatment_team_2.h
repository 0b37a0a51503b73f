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
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/sparse_exchange.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Treatment_inside_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/Greedy_coloring_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The ranks that treat the defects of a mesh together, see `Team`. Each treats its own vertices, and
/// moves those of others as it is told. Its piece of the mesh gets narrower with each sweep, by what bubbles that it
/// does not know may have changed; when triangles around its own vertices are concerned, it knows too little.
class Treatment_team_2 : public Treating_team
{
public:
  Treatment_team_2(const Communicator& comm, const Mesh_piece_2& piece)
    : m_comm(comm), m_piece(piece), m_targets(piece.mesh.bubbles.size()),
      m_beside_others(triangles_beside_others(piece.mesh)),
      m_certificate(piece.mesh), m_was_moved(piece.mesh.bubbles.size(), 0)
  {
    for (const auto& list : piece.sent)
      for (std::size_t k = 0; k < list.second.size(); ++k)
        m_targets.add(list.second[k], {list.first, static_cast<std::int32_t>(k)});
  }

  bool is_collective() const override { return true; }
  bool is_alone() const override { return m_comm.size() == 1; }

  bool goes_on_treating(bool here) override
  {
    const std::int32_t answer = m_comm.largest(std::int32_t(m_knows_too_little ? 2 : here ? 1 : 0));
    m_has_failed = answer == 2;
    return answer == 1;
  }

  /// Collective. Whether any rank knew too little: then what was done is worth nothing.
  bool has_failed() const override { return m_has_failed || m_comm.any(m_knows_too_little); }

  std::size_t largest_number(std::size_t here) const override
  {
    return static_cast<std::size_t>(m_comm.largest(static_cast<std::int64_t>(here)));
  }

  void share_colors(const Editable_triangulation_2& mesh, const std::vector<Index>& candidates,
                    Greedy_coloring_2& coloring) override
  {
    if (is_alone())
      return;
    const std::vector<Index> at_border = vertices_beside_others(mesh, candidates);
    std::vector<Index> changed, foreign;
    for (Index v : candidates)
      if (!m_targets.is_empty(v))
        changed.push_back(v);
    for (bool is_wrong = true; is_wrong; is_wrong = m_comm.any(!changed.empty())) {
      take_colors(share<Color>(changed, [&](Index v) { return Color{0, coloring[v]}; }), coloring, foreign);
      changed = color_anew(mesh, at_border, coloring);
    }
    coloring.forget(foreign);
  }

  void share_moved(Bubble_mesh_2& mesh, const std::vector<Index>& moved, Undo_log_2& log) override
  {
    if (is_alone())
      return;
    Bubbles_2& b = mesh.bubbles;
    const Messages<Move> in = share<Move>(moved, [&](Index v) { return Move{0, b.host[v], b.x[v], b.y[v], b.s[v]}; });
    for (const auto& message : in)
      for (const Move& m : message.second) {
        const Index v = m_piece.received.at(message.first)[m.position];
        log.note(Undo_log_2::vertex(b, v));
        b.host[v] = m.host;
        b.x[v] = m.x;
        b.y[v] = m.y;
        b.s[v] = m.s;
        m_was_moved[v] = 1;
        m_moved.push_back(v);
      }
  }

  void restore_border(Editable_triangulation_2& mesh) override
  {
    follow_flips(mesh);
    if (is_alone())
      return;
    for (Index t : m_beside_others)
      if (mesh.is_inside(t) && has_moved_vertex(mesh.vertices(t)))
        mesh.restore_delaunay_around(t);
    follow_flips(mesh);
    m_knows_too_little =
      !forget_doubtful(m_beside_others, m_certificate, mesh) || m_knows_too_little;
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
  const std::vector<Index>& changed_triangles() const override { return m_beside_others; }

private:
  struct Color
  {
    std::int32_t position, color;
  };

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

  /// tells the ranks that know some own bubbles of these; returns what they tell
  template <class T, class Tell>
  Messages<T> share(const std::vector<Index>& bubbles, const Tell& tell) const
  {
    Messages<T> out, in;
    for (const auto& list : m_piece.sent)
      out[list.first];
    for (const auto& list : m_piece.received)
      in[list.first].resize(list.second.size());
    for (Index v : bubbles)
      for (const auto& target : m_targets[v]) {
        out[target.first].push_back(tell(v));
        out[target.first].back().position = target.second;
      }
    exchange_known(m_comm, out, in);
    return in;
  }

  std::vector<Index> vertices_beside_others(const Editable_triangulation_2& mesh,
                                            const std::vector<Index>& candidates) const
  {
    std::vector<Index> result;
    for (Index v : candidates) {
      bool is_beside = false;
      if (!m_targets.is_empty(v)) // all with a neighbour of another rank have
        for (const Corner_2& c : mesh.star(v))
          for (Index w : mesh.vertices(c.triangle))
            is_beside = is_beside || !m_piece.mesh.bubbles.is_ours(w);
      if (is_beside)
        result.push_back(v);
    }
    return result;
  }

  void take_colors(const Messages<Color>& in, Greedy_coloring_2& coloring, std::vector<Index>& foreign) const
  {
    for (const auto& message : in)
      for (const Color& c : message.second) {
        const Index v = m_piece.received.at(message.first)[c.position];
        coloring.set(v, static_cast<unsigned char>(c.color));
        foreign.push_back(v);
      }
  }

  /// colours own candidates beside others anew, and what depends on them; returns those that others have to know
  std::vector<Index> color_anew(const Editable_triangulation_2& mesh, const std::vector<Index>& at_border,
                                Greedy_coloring_2& coloring) const
  {
    std::set<Index> queue(at_border.begin(), at_border.end());
    std::vector<Index> changed;
    while (!queue.empty()) { // in order: what a colour depends on is right then
      const Index v = *queue.begin();
      queue.erase(queue.begin());
      if (!coloring.color(mesh, v))
        continue;
      if (!m_targets.is_empty(v))
        changed.push_back(v);
      for (const Corner_2& c : mesh.star(v))
        for (Index w : mesh.vertices(c.triangle))
          if (w > v && m_piece.mesh.bubbles.is_ours(w) && coloring[w] != Greedy_coloring_2::none)
            queue.insert(w);
    }
    return changed;
  }

  const Communicator& m_comm;
  const Mesh_piece_2& m_piece;
  /// of each own bubble: the ranks that know it, and its position in the lists of both
  Lists_of_few<std::pair<int, std::int32_t>> m_targets;
  std::vector<Index> m_beside_others; // triangles, and all that were flipped, wherever they are
  Border_certificate_2 m_certificate;
  std::vector<char> m_was_moved; // of others' bubbles, in this sweep
  std::vector<Index> m_moved;    // those
  bool m_knows_too_little = false, m_has_failed = false;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_TREATMENT_TEAM_2_H
