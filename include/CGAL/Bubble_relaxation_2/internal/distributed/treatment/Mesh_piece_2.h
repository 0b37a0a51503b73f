// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_MESH_PIECE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_MESH_PIECE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A rank's triangles of the domain and others' triangles around them: only such as the mesh of all ranks has, so
/// that they stay a part of it while all ranks tell each other how they move the vertices. Where the domain goes
/// on and the piece ends, a triangle has no neighbour, and its side is no edge or labelled as an inner one.
struct Mesh_piece_2
{
  Distributed_mesh_2 mesh;
  Messages<Index> sent;     ///< own bubbles that other ranks have, in the order of their numbers
  Messages<Index> received; ///< others' bubbles that this rank has, in the same order as there
};

/// Collective. Each rank tells the others which of their bubbles it knows.
inline void link_with_others(Communicator& comm, Mesh_piece_2& piece)
{
  const Bubbles_2& known = piece.mesh.bubbles;
  Messages<std::int64_t> wanted;
  piece.sent.clear();
  piece.received.clear();
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known.is_ours(i)) {
      wanted[known.owner[i]].push_back(known.id[i]);
      piece.received[known.owner[i]].push_back(static_cast<Index>(i));
    }
  for (const auto& message : deliver(comm, wanted))
    for (std::int64_t number : message.second)
      piece.sent[message.first].push_back(known.index_of(number));
}

/// how many bubbles of a triangle are of this rank
inline int number_of_ours(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return bubbles.is_ours(vertices[0]) + bubbles.is_ours(vertices[1]) + bubbles.is_ours(vertices[2]);
}

/// whether a triangle has a bubble of another rank
inline bool is_beside_others(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return number_of_ours(bubbles, vertices) < 3;
}

/// the triangles of a piece with a bubble of another rank: among them all at its border
inline std::vector<Index> triangles_beside_others(const Bubble_mesh_2& piece)
{
  std::vector<Index> result;
  for (std::size_t t = 0; t < piece.triangles.inside.size(); ++t)
    if (piece.triangles.inside[t] && is_beside_others(piece.bubbles, piece.triangles.vertices[t]))
      result.push_back(static_cast<Index>(t));
  return result;
}

/// Finds the triangles of a piece of a mesh, Delaunay for itself, that the whole may not have: there can be bubbles
/// beyond the sides where the piece ends, and in the circles of triangles that reach across. The triangles whose
/// circle reaches a side hang together, so they are found from there. The mesh may change from one time to the next,
/// but not the number of its triangles.
class Border_certificate_2
{
public:
  explicit Border_certificate_2(const Bubble_mesh_2& mesh)
    : m_mesh(mesh), m_triangles(mesh.triangles), m_seen_from(mesh.triangles.inside.size(), 0),
      m_is_doubtful(mesh.triangles.inside.size(), 0)
  {}

  /// `at_border`: at least all triangles with a side where the piece ends
  const std::vector<Index>& doubtful(const std::vector<Index>& at_border)
  {
    for (Index t : m_doubtful)
      m_is_doubtful[t] = 0;
    m_doubtful.clear();
    for (Index t : at_border)
      for (int i = 0; i < 3 && m_triangles.inside[t]; ++i)
        if (m_triangles.neighbors[t][i] == no_index && m_triangles.edges[t][i] == no_index)
          find_from(t, i);
    return m_doubtful;
  }

private:
  void find_from(Index start, int side)
  {
    const Point p = m_mesh.point(start, ccw(side)), q = m_mesh.point(start, cw(side));
    ++m_number_of_sides;
    m_stack.assign(1, start);
    m_seen_from[start] = m_number_of_sides;
    while (!m_stack.empty()) {
      const Index t = m_stack.back();
      m_stack.pop_back();
      if (!m_is_doubtful[t])
        m_doubtful.push_back(t);
      m_is_doubtful[t] = 1;
      for (int i = 0; i < 3; ++i) {
        const Index n = m_triangles.neighbors[t][i];
        if (n == no_index || m_triangles.edges[t][i] != no_index || m_seen_from[n] == m_number_of_sides)
          continue;
        m_seen_from[n] = m_number_of_sides;
        if (may_reach(n, p, q))
          m_stack.push_back(n);
      }
    }
  }

  /// whether the circle of a triangle may reach a segment; with a margin for rounding
  bool may_reach(Index t, const Point& p, const Point& q) const
  {
    constexpr double flat = 1e-4, margin = 1e-6;
    const Point o = m_mesh.point(t, 0), r = m_mesh.point(t, 1), u = m_mesh.point(t, 2);
    const double ax = r.x() - o.x(), ay = r.y() - o.y();
    const double bx = u.x() - o.x(), by = u.y() - o.y();
    const double a = ax * ax + ay * ay, b = bx * bx + by * by, area2 = ax * by - ay * bx;
    if (!(area2 > flat * (std::max)(a, b)))
      return true;
    const double x = (by * a - ay * b) / (2 * area2), y = (ax * b - bx * a) / (2 * area2); // the centre
    const double px = p.x() - o.x() - x, py = p.y() - o.y() - y, ux = q.x() - p.x(), uy = q.y() - p.y();
    const double s = (std::min)(1., (std::max)(0., -(px * ux + py * uy) / (ux * ux + uy * uy)));
    const double dx = px + s * ux, dy = py + s * uy;
    return !(dx * dx + dy * dy > (1 + margin) * (x * x + y * y));
  }

  const Bubble_mesh_2& m_mesh;
  const Marked_triangles_2& m_triangles; // of it
  std::size_t m_number_of_sides = 0;
  std::vector<std::size_t> m_seen_from; // the last side from which a triangle was looked at
  std::vector<char> m_is_doubtful;
  std::vector<Index> m_doubtful, m_stack;
};

/// Forgets the triangles at the border of a piece that the whole mesh may not have; returns whether only those between
/// others' bubbles had to be forgotten, so that the piece is still wide enough. `beside_others`: at least all triangles
/// with a bubble of another rank. `certificate`: of the piece
inline bool forget_doubtful(const std::vector<Index>& beside_others, Border_certificate_2& certificate,
                            Editable_triangulation_2& piece)
{
  for (Index t : certificate.doubtful(beside_others)) {
    if (number_of_ours(piece.mesh().bubbles, piece.vertices(t)) > 0)
      return false;
    piece.cut_off(t);
  }
  return true;
}

/// Gives each rank the triangles around its own ones. A bubble goes to the ranks with a part of a disc around it,
/// and to those with a neighbour of it; of the other ranks' triangles those count whose vertices all came so. Own
/// bubbles and triangles stay where they are in memory, as far as others do not come before them.
class Mesh_widening_2
{
public:
  /// \pre the edges of `mesh` are labelled, and its final triangles are right
  Mesh_widening_2(Distributed_mesh_2&& mesh, const Hilbert_partition_2& partition, Communicator& comm)
    : m_partition(partition), m_comm(comm), m_piece{std::move(mesh), {}, {}}, m_mesh(m_piece.mesh)
  {}

  Mesh_widening_2(const Mesh_widening_2&) = delete;
  Mesh_widening_2& operator=(const Mesh_widening_2&) = delete;

  /// Collective. To be called once. `reach`: the radius of the discs in units of the bubbles' sizes.
  Mesh_piece_2 operator()(double reach)
  {
    Messages<Bubble_record_2> bubbles;
    Messages<Triangle> triangles;
    find_takers(reach);
    tell(bubbles, triangles);
    take_in(deliver(m_comm, bubbles));
    replace_triangles(deliver(m_comm, triangles));
    m_mesh.mark_triangles(m_comm.rank());
    link_with_others(m_comm, m_piece);
    return std::move(m_piece);
  }

private:
  struct Triangle
  {
    std::array<std::int64_t, 3> vertices; // numbers
    std::array<Index, 3> edges;
  };

  bool is_own(Index v) const { return m_mesh.bubbles.owner[v] == m_comm.rank(); }

  /// the other ranks that have to know own bubbles
  void find_takers(double reach)
  {
    const Bubbles_2& b = m_mesh.bubbles;
    m_takers.resize(m_mesh.bubbles.size());
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t i = 0; i < m_mesh.bubbles.size(); ++i)
      if (is_own(static_cast<Index>(i)))
        for (int rank : clearance.others_in_disc(b.x[i], b.y[i], reach * b.d[i]))
          m_takers.add_once(static_cast<Index>(i), rank);
    for (std::size_t t = 0; t < m_mesh.is_final.size(); ++t)
      if (m_mesh.is_final[t])
        find_takers_beside(m_mesh.triangles.vertices[t]);
  }

  /// own vertices of a triangle with others
  void find_takers_beside(const std::array<Index, 3>& vertices)
  {
    const std::vector<std::int32_t>& owners = m_mesh.bubbles.owner;
    if (owners[vertices[0]] == owners[vertices[1]] && owners[vertices[0]] == owners[vertices[2]])
      return;
    for (Index v : vertices)
      for (Index w : vertices)
        if (is_own(v) && !is_own(w))
          m_takers.add_once(v, owners[w]);
  }

  void tell(Messages<Bubble_record_2>& bubbles, Messages<Triangle>& triangles)
  {
    const Bubbles_2& known = m_mesh.bubbles;
    for (std::size_t i = 0; i < known.size(); ++i)
      for (int rank : m_takers[static_cast<Index>(i)])
        bubbles[rank].push_back(record(known, i));
    for (std::size_t t = 0; t < m_mesh.is_owned.size(); ++t) {
      const Index first = m_mesh.first_vertex(t);
      if (!m_mesh.is_owned[t] || m_takers.is_empty(first))
        continue;
      const std::array<Index, 3>& v = m_mesh.triangles.vertices[t];
      for (int rank : m_takers[first])
        triangles[rank].push_back(Triangle{{known.id[v[0]], known.id[v[1]], known.id[v[2]]},
                                           m_mesh.triangles.edges[t]});
    }
  }

  /// Keeps own bubbles and takes in others', all in the order of their numbers.
  void take_in(const Messages<Bubble_record_2>& others)
  {
    Bubbles_2& known = m_mesh.bubbles;
    const Index before = static_cast<Index>(known.size());
    std::vector<Index> order;
    order.reserve(known.size());
    for (Index i = 0; i < before; ++i)
      if (is_own(i))
        order.push_back(i);
    const std::size_t own = order.size();
    for (const auto& message : others)
      for (const Bubble_record_2& r : message.second) {
        order.push_back(static_cast<Index>(known.size()));
        internal::add(known, r, message.first);
      }
    merge_tail(order, own, [&known](Index i, Index j) { return known.id[i] < known.id[j]; });
    std::vector<std::pair<Index, std::int64_t>> ghosts; // that were known before
    for (Index i = 0; i < before; ++i)
      if (!is_own(i))
        ghosts.emplace_back(i, known.id[i]);
    m_place.assign(known.size(), no_index);
    for (std::size_t k = 0; k < order.size(); ++k)
      m_place[order[k]] = static_cast<Index>(k);
    known.select(order);
    for (const auto& ghost : ghosts)
      m_place[ghost.first] = known.index_of(ghost.second);
  }

  /// in the place of those without own bubbles come such that their owners tell
  void replace_triangles(const Messages<Triangle>& received)
  {
    Marked_triangles_2& m = m_mesh.triangles;
    for (std::array<Index, 3>& vertices : m.vertices)
      for (Index& v : vertices)
        v = m_place[v];
    std::vector<New_triangle_2> made;
    for (const auto& message : received)
      for (const Triangle& t : message.second) {
        const Bubbles_2& b = m_mesh.bubbles;
        const std::array<Index, 3> v{b.index_of(t.vertices[0]), b.index_of(t.vertices[1]), b.index_of(t.vertices[2])};
        // else it has an own vertex, or one that is too far away
        if (std::all_of(v.begin(), v.end(), [this](Index i) { return i != no_index && !is_own(i); }))
          made.push_back(New_triangle_2{v, t.edges});
      }
    std::vector<Index> old;
    for (std::size_t t = 0; t < m_mesh.is_final.size(); ++t)
      if (!m_mesh.is_final[t])
        old.push_back(static_cast<Index>(t));
    Mesh_stitching_2 stitching(m_mesh);
    stitching.replace(old, {});
    stitching.forget_triangles(); // first: the order in which own ones are given to users stays
    for (std::size_t t = 0; t < m.number_of_triangles(); ++t)
      stitching.open(static_cast<Index>(t));
    internal::make_room_for(made.size(), m.vertices);
    internal::make_room_for(made.size(), m.neighbors);
    internal::make_room_for(made.size(), m.edges);
    internal::make_room_for(made.size(), m.inside);
    stitching.replace({}, made);
  }

  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  Lists_of_few<int> m_takers; // the other ranks that have to know a bubble
  Mesh_piece_2 m_piece;
  Distributed_mesh_2& m_mesh; // of the piece
  std::vector<Index> m_place; // of each bubble that was there or came
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_MESH_PIECE_2_H
