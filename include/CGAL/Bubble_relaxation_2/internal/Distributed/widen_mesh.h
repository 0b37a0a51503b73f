// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WIDEN_MESH_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WIDEN_MESH_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Agreement.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Clearance_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Mesh_piece_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Edge_label.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Gives each rank the triangles around its own ones. A bubble goes to the ranks with a part of a disc around it,
/// and to those with a neighbour of it; of the other ranks' triangles those count whose vertices all came so.
class Mesh_widening_2
{
public:
  /// \pre the edges of `mesh` are labelled, and its final triangles are right
  Mesh_widening_2(const Distributed_mesh_2& mesh, const Hilbert_partition_2& partition, const Communicator& comm,
                  Agreement& agreement, Sparse_exchange& exchange)
    : m_mesh(mesh), m_partition(partition), m_comm(comm), m_agreement(agreement), m_exchange(exchange)
  {}

  /// Collective. `reach`: the radius of the discs in units of the bubbles' sizes.
  Mesh_piece_2 operator()(double reach)
  {
    Messages<Bubble_record_2> bubbles;
    Messages<Triangle> triangles;
    m_agreement.reach_after([&] {
      find_takers(reach);
      tell(bubbles, triangles);
    });
    const Messages<Bubble_record_2> others = m_exchange(bubbles);
    const Messages<Triangle> others_triangles = m_exchange(triangles);
    m_agreement.reach_after([&] {
      collect_bubbles(bubbles, others);
      add_own_triangles();
      add_triangles(others_triangles);
      link_open_sides();
      m_piece.mesh.mark_triangles(m_comm.rank());
    });
    return std::move(m_piece);
  }

private:
  struct Triangle
  {
    std::array<std::int64_t, 3> vertices; // numbers
    std::array<Index, 3> edges;
  };

  /// a side without a neighbour, between vertices in order
  struct Open_side
  {
    Index first, second, triangle;
    int index;

    bool operator<(const Open_side& s) const
    {
      return std::make_pair(first, second) < std::make_pair(s.first, s.second);
    }
  };

  bool is_own(Index v) const { return m_mesh.known.owners[v] == m_comm.rank(); }

  /// the other ranks that have to know own bubbles
  void find_takers(double reach)
  {
    const Bubbles_2& b = m_mesh.known.bubbles;
    m_position.assign(m_mesh.known.size(), no_index);
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t i = 0; i < m_mesh.known.size(); ++i)
      if (is_own(static_cast<Index>(i)) && clearance(b.x[i], b.y[i], reach * b.d[i]) == 0)
        for (int rank : m_partition.owners_in_disc(b.x[i], b.y[i], reach * b.d[i]))
          add_taker(static_cast<Index>(i), rank);
    for (std::size_t t = 0; t < m_mesh.is_final.size(); ++t)
      if (m_mesh.is_final[t])
        find_takers_beside(m_mesh.triangulation.tr.vertices[t]);
  }

  /// own vertices of a triangle with others
  void find_takers_beside(const std::array<Index, 3>& vertices)
  {
    const std::vector<std::int32_t>& owners = m_mesh.known.owners;
    if (owners[vertices[0]] == owners[vertices[1]] && owners[vertices[0]] == owners[vertices[2]])
      return;
    for (Index v : vertices)
      for (Index w : vertices)
        if (is_own(v) && !is_own(w))
          add_taker(v, owners[w]);
  }

  void add_taker(Index i, int rank)
  {
    if (rank == m_comm.rank())
      return;
    if (m_position[i] == no_index) {
      m_position[i] = static_cast<Index>(m_takers.size());
      m_takers.emplace_back();
    }
    Hilbert_partition_2::Ranks& takers = m_takers[m_position[i]];
    if (std::find(takers.begin(), takers.end(), rank) == takers.end())
      takers.push_back(rank);
  }

  void tell(Messages<Bubble_record_2>& bubbles, Messages<Triangle>& triangles) const
  {
    const Known_bubbles_2& known = m_mesh.known;
    for (std::size_t i = 0; i < known.size(); ++i)
      if (m_position[i] != no_index)
        for (int rank : m_takers[m_position[i]])
          bubbles[rank].push_back(record(known.bubbles, i, known.numbers[i]));
    for (std::size_t t = 0; t < m_mesh.is_owned.size(); ++t) {
      const Index position = m_mesh.is_owned[t] ? m_position[m_mesh.first_vertex(t)] : no_index;
      if (position == no_index)
        continue;
      const std::array<Index, 3>& v = m_mesh.triangulation.tr.vertices[t];
      for (int rank : m_takers[position])
        triangles[rank].push_back(Triangle{{known.numbers[v[0]], known.numbers[v[1]], known.numbers[v[2]]},
                                           m_mesh.triangulation.edges[t]});
    }
  }

  void collect_bubbles(const Messages<Bubble_record_2>& sent, const Messages<Bubble_record_2>& received)
  {
    Known_bubbles_2& known = m_piece.mesh.known;
    known.make_room_for(m_mesh.known.size());
    for (std::size_t i = 0; i < m_mesh.known.size(); ++i)
      if (is_own(static_cast<Index>(i)))
        known.add(record(m_mesh.known.bubbles, i, m_mesh.known.numbers[i]), m_comm.rank());
    for (const auto& message : received)
      for (const Bubble_record_2& r : message.second)
        known.add(r, message.first);
    known.sort();
    known.bubbles.number = known.numbers;
    known.bubbles.is_foreign.reserve(known.size());
    for (std::int32_t owner : known.owners)
      known.bubbles.is_foreign.push_back(owner != m_comm.rank());
    for (const auto* side : {&sent, &received})
      for (const auto& message : *side)
        for (const Bubble_record_2& r : message.second)
          (side == &sent ? m_piece.sent : m_piece.received)[message.first].push_back(known.index(r.number));
    m_piece.mesh.triangulation.tr.points.reserve(known.size());
    for (std::size_t i = 0; i < known.size(); ++i)
      m_piece.mesh.triangulation.tr.points.push_back(known.bubbles.point(i));
  }

  void add(const std::array<Index, 3>& vertices, const std::array<Index, 3>& neighbors,
           const std::array<Index, 3>& edges)
  {
    Marked_triangulation_2& m = m_piece.mesh.triangulation;
    m.tr.vertices.push_back(vertices);
    m.tr.neighbors.push_back(neighbors);
    m.edges.push_back(edges);
    m.inside.push_back(1);
  }

  void add_own_triangles()
  {
    const Marked_triangulation_2& m = m_mesh.triangulation;
    std::vector<Index> number(m.inside.size(), no_index);
    Index next = 0;
    for (std::size_t t = 0; t < number.size(); ++t)
      if (m_mesh.is_final[t])
        number[t] = next++;
    make_room_for_triangles(static_cast<std::size_t>(next));
    const std::vector<Index> index = indices_in_piece();
    for (std::size_t t = 0; t < number.size(); ++t) {
      if (number[t] == no_index)
        continue;
      std::array<Index, 3> vertices, neighbors;
      for (int i = 0; i < 3; ++i) {
        vertices[i] = index[m.tr.vertices[t][i]];
        const Index n = m.tr.neighbors[t][i];
        neighbors[i] = n == no_index ? no_index : number[n];
      }
      add(vertices, neighbors, m.edges[t]);
    }
  }

  void make_room_for_triangles(std::size_t n)
  {
    Marked_triangulation_2& m = m_piece.mesh.triangulation;
    m.tr.vertices.reserve(n);
    m.tr.neighbors.reserve(n);
    m.edges.reserve(n);
    m.inside.reserve(n);
  }

  /// of the bubbles of the mesh, as far as the piece has them
  std::vector<Index> indices_in_piece() const
  {
    const std::vector<std::int64_t>&from = m_mesh.known.numbers, &to = m_piece.mesh.known.numbers;
    std::vector<Index> index(from.size(), no_index);
    for (std::size_t i = 0, k = 0; i < from.size() && k < to.size(); ++i) {
      while (k < to.size() && to[k] < from[i])
        ++k;
      if (k < to.size() && to[k] == from[i])
        index[i] = static_cast<Index>(k);
    }
    return index;
  }

  void add_triangles(const Messages<Triangle>& received)
  {
    const Known_bubbles_2& known = m_piece.mesh.known;
    for (const auto& message : received)
      for (const Triangle& t : message.second) {
        std::array<Index, 3> v;
        for (int i = 0; i < 3; ++i)
          v[i] = known.index(t.vertices[i]);
        const bool is_new = std::all_of(v.begin(), v.end(), [&](Index i) {
          return i != no_index && known.owners[i] != m_comm.rank();
        });
        if (is_new)
          add(v, {no_index, no_index, no_index}, t.edges);
      }
  }

  void link_open_sides()
  {
    Flat_triangulation_2& tr = m_piece.mesh.triangulation.tr;
    std::vector<Open_side> sides;
    for (std::size_t t = 0; t < tr.neighbors.size(); ++t)
      for (int i = 0; i < 3; ++i)
        if (tr.neighbors[t][i] == no_index) {
          const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
          sides.push_back(Open_side{(std::min)(a, b), (std::max)(a, b), static_cast<Index>(t), i});
        }
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 1; k < sides.size(); ++k) {
      const Open_side &s = sides[k - 1], &t = sides[k];
      if (s.first != t.first || s.second != t.second)
        continue;
      tr.neighbors[s.triangle][s.index] = t.triangle;
      tr.neighbors[t.triangle][t.index] = s.triangle;
    }
  }

  const Distributed_mesh_2& m_mesh;
  const Hilbert_partition_2& m_partition;
  const Communicator& m_comm;
  Agreement& m_agreement;
  Sparse_exchange& m_exchange;
  std::vector<Hilbert_partition_2::Ranks> m_takers; // of own bubbles that others have to know
  std::vector<Index> m_position;                    // in these, of each bubble
  Mesh_piece_2 m_piece;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_WIDEN_MESH_H
