// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_WIDEN_MESH_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_WIDEN_MESH_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Lists_of_few.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/treatment/Border_certificate_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

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
/// and to those with a neighbour of it; of the other ranks' triangles those count whose vertices all came so. Own
/// bubbles and triangles stay where they are in memory, as far as others do not come before them.
class Mesh_widening_2
{
public:
  /// \pre the edges of `mesh` are labelled, and its final triangles are right
  Mesh_widening_2(Distributed_mesh_2&& mesh, const Hilbert_partition_2& partition, Communicator& comm)
    : m_partition(partition), m_comm(comm),
      m_piece{std::move(mesh), {}, {}}, m_mesh(m_piece.mesh)
  {}

  Mesh_widening_2(const Mesh_widening_2&) = delete;
  Mesh_widening_2& operator=(const Mesh_widening_2&) = delete;

  /// Collective. To be called once. `reach`: the radius of the discs in units of the bubbles' sizes.
  Mesh_piece_2 operator()(double reach)
  {
    Messages<Bubble_record_2> bubbles;
    Messages<Triangle> triangles;
    m_comm.agree_after([&] {
      find_takers(reach);
      tell(bubbles, triangles);
    });
    const Messages<Bubble_record_2> others = deliver(m_comm, bubbles);
    const Messages<Triangle> others_triangles = deliver(m_comm, triangles);
    m_comm.agree_after([&] {
      take_in(others);
      keep_final_triangles();
      add_triangles(others_triangles);
      link_open_sides();
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

  bool is_own(Index v) const { return m_mesh.bubbles.owner[v] == m_comm.rank(); }

  /// the other ranks that have to know own bubbles
  void find_takers(double reach)
  {
    const Bubbles_2& b = m_mesh.bubbles;
    m_takers.resize(m_mesh.bubbles.size());
    Clearance_2 clearance(m_partition, m_comm.rank());
    for (std::size_t i = 0; i < m_mesh.bubbles.size(); ++i)
      if (is_own(static_cast<Index>(i)) && clearance(b.x[i], b.y[i], reach * b.d[i]) == 0)
        for (int rank : m_partition.owners_in_disc(b.x[i], b.y[i], reach * b.d[i]))
          add_taker(static_cast<Index>(i), rank);
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
          add_taker(v, owners[w]);
  }

  void add_taker(Index i, int rank)
  {
    if (rank != m_comm.rank() && !m_takers.has(i, rank))
      m_takers.add(i, rank);
  }

  void tell(Messages<Bubble_record_2>& bubbles, Messages<Triangle>& triangles)
  {
    const Bubbles_2& known = m_mesh.bubbles;
    for (std::size_t i = 0; i < known.size(); ++i)
      for (int rank : m_takers[static_cast<Index>(i)]) {
        bubbles[rank].push_back(record(known, i));
        m_piece.sent[rank].push_back(static_cast<Index>(i)); // as yet
      }
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
        m_piece.received[message.first].push_back(order.back());
        internal::add(known, r, message.first);
      }
    merge_tail(order, own, [&known](Index i, Index j) { return known.id[i] < known.id[j]; });
    find_places(order, before);
    known.select(order);
    for (auto* lists : {&m_piece.sent, &m_piece.received})
      for (auto& list : *lists)
        for (Index& i : list.second)
          i = m_place[i];
  }

  /// where bubbles will be that are now at `order[0], order[1], …`; those before `first_new` were there
  void find_places(const std::vector<Index>& order, Index first_new)
  {
    const Bubbles_2& known = m_mesh.bubbles;
    m_place.assign(known.size(), no_index);
    for (std::size_t k = 0; k < order.size(); ++k) {
      m_place[order[k]] = static_cast<Index>(k);
      if (order[k] >= first_new)
        m_ghosts.emplace_back(known.id[order[k]], static_cast<Index>(k));
    }
    for (Index i = 0; i < first_new; ++i)
      if (!is_own(i))
        m_place[i] = ghost(known.id[i]);
  }

  /// the place of a bubble of others with a number, `no_index` if there is none
  Index ghost(std::int64_t number) const
  {
    const auto found = std::lower_bound(m_ghosts.begin(), m_ghosts.end(), std::make_pair(number, Index(0)));
    return found != m_ghosts.end() && found->first == number ? found->second : no_index;
  }

  void keep_final_triangles()
  {
    Marked_triangles_2& m = m_mesh.triangles;
    std::vector<Index> number(m.inside.size(), no_index);
    std::size_t next = 0;
    for (std::size_t t = 0; t < number.size(); ++t)
      if (m_mesh.is_final[t])
        number[t] = static_cast<Index>(next++);
    for (std::size_t t = 0; t < number.size(); ++t) {
      if (number[t] == no_index)
        continue;
      const std::size_t k = static_cast<std::size_t>(number[t]);
      for (int i = 0; i < 3; ++i) {
        const Index n = m.neighbors[t][i];
        m.vertices[k][i] = m_place[m.vertices[t][i]];
        m.neighbors[k][i] = n == no_index ? no_index : number[n];
        if (m.neighbors[k][i] == no_index)
          m_open.emplace_back(number[t], i);
      }
      m.edges[k] = m.edges[t];
      m_mesh.is_owned[k] = m_mesh.is_owned[t];
    }
    m_number_of_own_triangles = next;
    m.vertices.resize(next);
    m.neighbors.resize(next);
    m.edges.resize(next);
    m.inside.assign(next, 1);
    m_mesh.is_owned.resize(next);
    m_mesh.is_final.assign(next, 1);
  }

  /// of others'
  void add_triangles(const Messages<Triangle>& received)
  {
    std::size_t most = 0;
    for (const auto& message : received)
      most += message.second.size();
    make_room_for(most);
    for (const auto& message : received)
      for (const Triangle& t : message.second) {
        std::array<Index, 3> v;
        for (int i = 0; i < 3; ++i)
          v[i] = ghost(t.vertices[i]);
        if (std::find(v.begin(), v.end(), no_index) == v.end()) // else it has an own vertex, or one that is too far away
          add(v, t.edges);
      }
  }

  void make_room_for(std::size_t n)
  {
    Marked_triangles_2& m = m_mesh.triangles;
    internal::make_room_for(n, m.vertices);
    internal::make_room_for(n, m.neighbors);
    internal::make_room_for(n, m.edges);
    internal::make_room_for(n, m.inside);
    internal::make_room_for(n, m_mesh.is_owned);
    internal::make_room_for(n, m_mesh.is_final);
  }

  void add(const std::array<Index, 3>& vertices, const std::array<Index, 3>& edges)
  {
    Marked_triangles_2& m = m_mesh.triangles;
    m.vertices.push_back(vertices);
    m.neighbors.push_back({no_index, no_index, no_index});
    m.edges.push_back(edges);
    m.inside.push_back(1);
    m_mesh.is_owned.push_back(0);
    m_mesh.is_final.push_back(0);
  }

  /// links others' triangles with each other and with own ones
  void link_open_sides()
  {
    Marked_triangles_2& tr = m_mesh.triangles;
    std::vector<Open_side> sides;
    const auto add_side = [&](Index t, int i) {
      const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)];
      sides.push_back(Open_side{(std::min)(a, b), (std::max)(a, b), t, i});
    };
    for (const auto& side : m_open)
      add_side(side.first, side.second);
    for (std::size_t t = m_number_of_own_triangles; t < tr.vertices.size(); ++t)
      for (int i = 0; i < 3; ++i)
        add_side(static_cast<Index>(t), i);
    std::sort(sides.begin(), sides.end());
    for (std::size_t k = 1; k < sides.size(); ++k) {
      const Open_side &s = sides[k - 1], &t = sides[k];
      if (s.first != t.first || s.second != t.second)
        continue;
      tr.neighbors[s.triangle][s.index] = t.triangle;
      tr.neighbors[t.triangle][t.index] = s.triangle;
    }
  }

  const Hilbert_partition_2& m_partition;
  Communicator& m_comm;
  Lists_of_few<int> m_takers; // the other ranks that have to know a bubble
  Mesh_piece_2 m_piece;
  Distributed_mesh_2& m_mesh;                            // of the piece
  std::vector<Index> m_place;                            // of each bubble that was there or came
  std::vector<std::pair<std::int64_t, Index>> m_ghosts;  // others' bubbles, by their numbers, and where they are
  std::size_t m_number_of_own_triangles = 0;             // the first ones, when others' are added
  std::vector<std::pair<Index, int>> m_open;             // sides of own triangles without neighbours
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_WIDEN_MESH_H
