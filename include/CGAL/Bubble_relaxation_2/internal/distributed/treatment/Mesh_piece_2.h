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
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/disc_of_triangle.h>

#include <CGAL/Bbox_2.h>

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
  deliver(comm, wanted, [&](int rank, std::int64_t number) {
    piece.shared.sent[rank].push_back(known.index_of(number));
  });
}

/// how many bubbles of a triangle are of this rank
inline int number_of_ours(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return bubbles.is_ours(vertices[0]) + bubbles.is_ours(vertices[1]) + bubbles.is_ours(vertices[2]);
}

/// the triangles of a piece with a bubble of another rank: among them all at its border
inline std::vector<Index> triangles_beside_others(const Bubble_mesh_2& piece)
{
  return indices_where(piece.triangles.inside.size(), [&piece](std::size_t t) {
    tick(t);
    return piece.triangles.inside[t] && number_of_ours(piece.bubbles, piece.triangles.vertices[t]) < 3;
  });
}

/// Finds the triangles of a piece of a mesh, Delaunay for itself, that the whole may not have any more: there can be
/// bubbles beyond the sides where the piece ends. A triangle that is as it was stays one of the whole unless a bubble has
/// come into its circle. One that was changed may be wrong if its circle reaches such a side. The triangles whose circle
/// does so hang together, so they are found from there.
class Border_check_2
{
public:
  /// `box`: of the domain; `changed`: at least the triangles that are not as they were; `places`: at least those of moved
  /// and new bubbles in circles of triangles that do not know of them
  Border_check_2(Editable_triangulation_2& piece, const Bbox_2& box, const std::vector<Index>& changed,
                 std::vector<Point> places)
    : m_piece(piece), m_mesh(piece.mesh()), m_triangles(m_mesh.triangles), m_box(box), m_places(std::move(places)),
      m_seen_from(m_triangles.inside.size(), 0), m_state(m_seen_from.size(), AS_IT_WAS)
  {
    std::sort(m_places.begin(), m_places.end());
    for (Index t : changed)
      m_state[t] = CHANGED;
  }

  /// Forgets those triangles; returns whether all were between others' bubbles, so that the piece is still wide enough.
  /// `at_border`: at least all triangles with a side where the piece ends
  bool forget_doubtful(const std::vector<Index>& at_border)
  {
    for (Index t : at_border)
      for (int i = 0; i < 3 && m_triangles.inside[t]; ++i)
        if (m_triangles.neighbors[t][i] == no_index && m_triangles.edges[t][i] == no_index)
          find_from(t, i);
    for (Index t : m_doubtful) {
      if (number_of_ours(m_mesh.bubbles, m_triangles.vertices[t]) > 0)
        return false;
      m_piece.cut_off(t);
    }
    return true;
  }

private:
  enum State : char { AS_IT_WAS, CHANGED, SEEN };

  void find_from(Index start, int side)
  {
    const Point p = m_mesh.point(start, ccw(side)), q = m_mesh.point(start, cw(side));
    ++m_number_of_sides;
    m_stack.assign(1, start);
    m_seen_from[start] = m_number_of_sides;
    while (!m_stack.empty()) {
      const Index t = m_stack.back();
      m_stack.pop_back();
      if (m_state[t] == CHANGED || (m_state[t] == AS_IT_WAS && has_place_in_circle(t)))
        m_doubtful.push_back(t);
      m_state[t] = SEEN;
      for (int i = 0; i < 3; ++i) {
        const Index n = m_triangles.neighbors[t][i];
        if (n == no_index || m_triangles.edges[t][i] != no_index || m_seen_from[n] == m_number_of_sides)
          continue;
        m_seen_from[n] = m_number_of_sides;
        if (reaches(disc_of_triangle(m_mesh, n, m_box), p, q))
          m_stack.push_back(n);
      }
    }
  }

  bool has_place_in_circle(Index t) const
  {
    const Disc_2 disc = disc_of_triangle(m_mesh, t, m_box);
    const Point first(disc.x - disc.radius, disc.y - disc.radius), last(disc.x + disc.radius, disc.y + disc.radius);
    const auto begin = std::lower_bound(m_places.begin(), m_places.end(), first);
    return std::any_of(begin, std::upper_bound(begin, m_places.end(), last),
                       [&](const Point& p) { return reaches(disc, p, p); });
  }

  /// whether a disc may reach a segment
  static bool reaches(const Disc_2& disc, const Point& p, const Point& q)
  {
    const double px = p.x() - disc.x, py = p.y() - disc.y, ux = q.x() - p.x(), uy = q.y() - p.y();
    const double squared = ux * ux + uy * uy;
    const double s = squared > 0 ? (std::min)(1., (std::max)(0., -(px * ux + py * uy) / squared)) : 0.;
    return length_of(px + s * ux, py + s * uy) <= disc.radius;
  }

  Editable_triangulation_2& m_piece;
  const Bubble_mesh_2& m_mesh;           // of it
  const Marked_triangles_2& m_triangles; // of it
  const Bbox_2 m_box;
  std::vector<Point> m_places; // in order
  Index m_number_of_sides = 0;
  std::vector<Index> m_seen_from; // the last side from which a triangle was looked at
  std::vector<State> m_state;
  std::vector<Index> m_doubtful, m_stack;
};

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
    tick(t);
    const Index first = mesh.is_owned[t] ? mesh.first_vertex(t) : no_index;
    if (first != no_index && is_near[first])
      for (int rank : clearance.others_in_disc(b.x[first], b.y[first], reach * b.d[first]))
        out[rank].push_back(sorted_numbers(b, mesh.triangles.vertices[t]));
  }
  std::vector<Numbers_of_triangle> result;
  deliver(comm, out, [&](int, const Numbers_of_triangle& t) { result.push_back(t); });
  std::sort(result.begin(), result.end());
  return result;
}

/// Forgets others' bubbles that no triangle has.
inline void forget_lonely_ghosts(Bubble_mesh_2& mesh)
{
  std::vector<char> is_left(mesh.bubbles.size(), 0);
  for (const std::array<Index, 3>& vertices : mesh.triangles.vertices)
    for (Index v : vertices)
      is_left[v] = 1;
  for (std::size_t i = 0; i < is_left.size(); ++i)
    if (!is_left[i] && !mesh.bubbles.is_ours(i))
      mesh.bubbles.remove(i);
  const std::vector<Index> number = mesh.bubbles.indices_left();
  for (std::array<Index, 3>& vertices : mesh.triangles.vertices)
    for (Index& v : vertices)
      v = number[v];
  mesh.bubbles.forget_gone();
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
