// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_BORDER_CERTIFICATE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_BORDER_CERTIFICATE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mesh/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Messages.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A rank's triangles of the domain and others' triangles around them: only such as the mesh of all ranks has, so
/// that they stay a part of it while all ranks tell each other how they move the vertices. Where the domain goes
/// on and the piece ends, a triangle has no neighbour, and its side is no edge or labelled as an inner one.
struct Mesh_piece_2
{
  Distributed_mesh_2 mesh;
  Messages<Index> sent;     ///< own bubbles that other ranks have, in the order of their numbers
  Messages<Index> received; ///< others' bubbles that this rank has, in the same order as there
};

/// whether a triangle has a bubble of another rank
inline bool is_beside_others(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return !bubbles.is_ours(vertices[0]) || !bubbles.is_ours(vertices[1]) || !bubbles.is_ours(vertices[2]);
}

/// whether all three bubbles of a triangle are others'
inline bool is_between_others(const Bubbles_2& bubbles, const std::array<Index, 3>& vertices)
{
  return !bubbles.is_ours(vertices[0]) && !bubbles.is_ours(vertices[1]) && !bubbles.is_ours(vertices[2]);
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
    if (!is_between_others(piece.mesh().bubbles, piece.vertices(t)))
      return false;
    piece.cut_off(t);
  }
  return true;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_TREATMENT_BORDER_CERTIFICATE_2_H
