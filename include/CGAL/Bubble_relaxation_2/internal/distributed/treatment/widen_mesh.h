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
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

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
    : m_partition(partition), m_comm(comm), m_piece{std::move(mesh), {}, {}}, m_mesh(m_piece.mesh)
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
      replace_triangles(others_triangles);
      m_mesh.mark_triangles(m_comm.rank());
    });
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
    for (auto* lists : {&m_piece.sent, &m_piece.received})
      for (auto& list : *lists)
        for (Index& i : list.second)
          i = m_place[i];
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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_WIDEN_MESH_H
