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
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

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
  Shared_lists shared; ///< bubbles, in the order of their numbers
};

/// Collective. Each rank tells the others which of their bubbles it knows.
inline void link_with_others(Communicator& comm, Mesh_piece_2& piece)
{
  const Bubbles_2& known = piece.mesh.bubbles;
  Messages<std::int64_t> wanted;
  piece.shared = {};
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known.is_ours(i)) {
      wanted[known.owner[i]].push_back(known.id[i]);
      piece.shared.received[known.owner[i]].push_back(static_cast<Index>(i));
    }
  for (const auto& message : deliver(comm, wanted))
    for (std::int64_t number : message.second)
      piece.shared.sent[message.first].push_back(known.index_of(number));
}

/// how many bubbles of a triangle are of this rank
inline int number_of_ours(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return bubbles.is_ours(vertices[0]) + bubbles.is_ours(vertices[1]) + bubbles.is_ours(vertices[2]);
}

/// the triangles of a piece with a bubble of another rank: among them all at its border
inline std::vector<Index> triangles_beside_others(const Bubble_mesh_2& piece)
{
  std::vector<Index> result;
  for (std::size_t t = 0; t < piece.triangles.inside.size(); ++t)
    if (piece.triangles.inside[t] && number_of_ours(piece.bubbles, piece.triangles.vertices[t]) < 3)
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

/// Collective. The triangles that others own around this rank's part, sorted: each rank tells of its own ones.
inline std::vector<Numbers_of_triangle> triangles_around_part(Communicator& comm, const Distributed_mesh_2& mesh,
                                                              const Hilbert_partition_2& partition, double reach)
{
  const Bubbles_2& b = mesh.bubbles;
  Messages<Numbers_of_triangle> out;
  Clearance_2 clearance(partition, comm.rank());
  std::vector<char> is_near(b.size(), 0); // to others
  for (std::size_t i = 0; i < is_near.size(); ++i)
    is_near[i] = b.is_ours(i) && clearance(b.x[i], b.y[i], reach * b.d[i]) == 0;
  for (std::size_t t = 0; t < mesh.is_owned.size(); ++t) {
    const Index first = mesh.is_owned[t] ? mesh.first_vertex(t) : no_index;
    if (first != no_index && is_near[first])
      for (int rank : clearance.others_in_disc(b.x[first], b.y[first], reach * b.d[first]))
        out[rank].push_back(sorted_numbers(b, mesh.triangles.vertices[t]));
  }
  std::vector<Numbers_of_triangle> result;
  for (const auto& message : deliver(comm, out))
    result.insert(result.end(), message.second.begin(), message.second.end());
  std::sort(result.begin(), result.end());
  return result;
}

/// Forgets others' bubbles that no triangle has.
inline void forget_lonely_ghosts(Bubble_mesh_2& mesh)
{
  std::vector<char> is_left(mesh.bubbles.size(), 0);
  for (std::size_t i = 0; i < is_left.size(); ++i)
    is_left[i] = mesh.bubbles.is_ours(i);
  for (const std::array<Index, 3>& vertices : mesh.triangles.vertices)
    for (Index v : vertices)
      is_left[v] = 1;
  const std::vector<Index> left = marked(is_left);
  std::vector<Index> number(is_left.size(), no_index);
  for (std::size_t k = 0; k < left.size(); ++k)
    number[left[k]] = static_cast<Index>(k);
  for (std::array<Index, 3>& vertices : mesh.triangles.vertices)
    for (Index& v : vertices)
      v = number[v];
  mesh.bubbles.select(left);
}

/// Collective. The triangles of a mesh that the whole has, too: own ones, and those that others own and told of. \pre
/// the edges are labelled; each rank got bubbles with this `reach` for the mesh
inline Mesh_piece_2 piece_of_whole(Communicator& comm, Distributed_mesh_2&& mesh, const Hilbert_partition_2& partition,
                                   double reach)
{
  const auto around = triangles_around_part(comm, mesh, partition, reach);
  Mesh_piece_2 piece{std::move(mesh), {}};
  Distributed_mesh_2& m = piece.mesh;
  keep_triangles(m.triangles, [&](std::size_t t) {
    return m.is_final[t] != 0 ||
           (m.triangles.inside[t] != 0 &&
            std::binary_search(around.begin(), around.end(), sorted_numbers(m.bubbles, m.triangles.vertices[t])));
  });
  forget_lonely_ghosts(m);
  m.mark_triangles(comm.rank());
  link_with_others(comm, piece);
  return piece;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_MESH_PIECE_2_H
