// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLAT_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLAT_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Triangles in arrays: triangle `t` has the vertices `vertices[t]` in counterclockwise order, which are indices of
/// points or of bubbles, and across the edge opposite to its vertex `i` lies `neighbors[t][i]`, `no_index` beyond the
/// convex hull. `inside[t]` tells whether it belongs to the domain, where that is known.
struct Triangles_2
{
  std::vector<std::array<Index, 3>> vertices;
  std::vector<std::array<Index, 3>> neighbors;
  std::vector<char> inside;

  std::size_t number_of_triangles() const { return vertices.size(); }

  int index_of_vertex(Index t, Index vertex) const
  {
    return vertices[t][0] == vertex ? 0 : vertices[t][1] == vertex ? 1 : 2;
  }

  int index_of_neighbor(Index t, Index neighbor) const
  {
    return neighbors[t][0] == neighbor ? 0 : neighbors[t][1] == neighbor ? 1 : 2;
  }

  /// that of the side between two vertices. The neighbour there would not tell while vertices are moved: outside of the
  /// domain a triangle, turned over by a rounding, can have one twice
  int index_of_side(Index t, Index u, Index v) const
  {
    const auto is_opposite = [&](Index vertex) { return vertex != u && vertex != v; };
    return is_opposite(vertices[t][0]) ? 0 : is_opposite(vertices[t][1]) ? 1 : 2;
  }
};

/// The triangles around each vertex, in their order: those for which `is_counted(t)` holds.
class Triangles_around_2
{
public:
  template <class Is_counted>
  Triangles_around_2(const std::vector<std::array<Index, 3>>& vertices, std::size_t number_of_vertices,
                     const Is_counted& is_counted)
    : m_begins(number_of_vertices + 1, 0)
  {
    for (std::size_t t = 0; t < vertices.size(); ++t)
      for (int i = 0; i < 3 && is_counted(t); ++i)
        ++m_begins[vertices[t][i]];
    std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
    m_triangles.resize(m_begins.back());
    for (std::size_t t = vertices.size(); t-- > 0;)
      for (int i = 0; i < 3 && is_counted(t); ++i)
        m_triangles[--m_begins[vertices[t][i]]] = static_cast<Index>(t);
  }

  auto operator[](std::size_t v) const
  {
    return CGAL::make_range(m_triangles.data() + m_begins[v], m_triangles.data() + m_begins[v + 1]);
  }

private:
  std::vector<std::size_t> m_begins; // of each vertex in `m_triangles`, and the end of the last one
  std::vector<Index> m_triangles;
};

/// Calls `visit(t, i)` for edges of the domain, each as the side `i` of the first of the triangles of the domain that
/// have it: for those of which it is one of the triangles from `first` to `last`, without.
template <class Visitor>
void for_each_edge(const Triangles_2& tr, std::size_t first, std::size_t last, const Visitor& visit)
{
  for (std::size_t k = first; k < last; ++k) {
    tick(k);
    for (int i = 0; i < 3 && tr.inside[k]; ++i) {
      const Index t = static_cast<Index>(k), n = tr.neighbors[k][i];
      if (n == no_index || !tr.inside[n] || n > t)
        visit(t, i);
    }
  }
}

/// A triangulation in arrays, for walks that many bubbles do at once.
struct Flat_triangulation_2 : Triangles_2
{
  std::vector<Point> points;

  const Point& point(Index t, int i) const { return points[vertices[t][i]]; }

  /// whether `q` is strictly beyond the edge of `t` opposite to its vertex `i`; exact
  bool is_beyond(Index t, int i, const Point& q) const
  {
    return CGAL::orientation(point(t, ccw(i)), point(t, cw(i)), q) == RIGHT_TURN;
  }
};

/// Where a walk ended: in triangle `triangle`, which contains the target, if `edge` is -1;
/// else at the edge opposite to vertex `edge` of `triangle`, which it may not cross.
struct Walk_end
{
  Index triangle;
  int edge;

  bool is_blocked() const { return edge != -1; }
};

/// Walks along the segment from `p` to `q`, where `t` contains `p`, and stops at the first edge that
/// `is_wall(triangle, edge index)` says is a wall, or at the hull. All turns are decided by exact
/// orientations; a segment through a vertex passes it on one side. If `p` lies on a side of `t`, only up
/// to rounding perhaps, `entry` is that side and `q` must lie on the inner side of it.
template <class Is_wall>
Walk_end walk_straight(const Flat_triangulation_2& tr, Index t, const Point& p, const Point& q,
                       const Is_wall& is_wall, int entry = -1)
{
  for (;;) {
    int exit = -1;
    for (int i = 0; i < 3; ++i) {
      if (i == entry || !tr.is_beyond(t, i, q))
        continue;
      if (exit == -1) {
        exit = i;
        continue;
      }
      // beyond two edges: the segment leaves on the side of their common vertex that it passes
      const int common = 3 - exit - i;
      exit = CGAL::orientation(p, q, tr.point(t, common)) == RIGHT_TURN ? cw(common) : ccw(common);
      break;
    }
    if (exit == -1)
      return Walk_end{t, -1};
    const Index next = tr.neighbors[t][exit];
    if (next == no_index || is_wall(t, exit))
      return Walk_end{t, exit};
    entry = tr.index_of_neighbor(next, t);
    t = next;
  }
}

/// The triangle that contains `q`, or the side of the convex hull that `q` lies beyond: a walk from `t`
/// over edges that `q` lies beyond, in changing order, since a fixed order can go round in circles where
/// the triangulation is not Delaunay.
inline Walk_end locate_or_exit(const Flat_triangulation_2& tr, Index t, const Point& q)
{
  std::uint32_t order = 1;
  int entry = -1;
  for (;;) {
    order = 1664525u * order + 1013904223u;
    int exit = -1;
    for (int k = 0; k < 3 && exit == -1; ++k) {
      const int i = static_cast<int>(((order >> 16) + k) % 3);
      if (i != entry && tr.is_beyond(t, i, q))
        exit = i;
    }
    if (exit == -1 || tr.neighbors[t][exit] == no_index)
      return Walk_end{t, exit};
    const Index next = tr.neighbors[t][exit];
    entry = tr.index_of_neighbor(next, t);
    t = next;
  }
}

/// The triangle that contains `q`, or `no_index` if `q` lies outside of the convex hull.
inline Index locate(const Flat_triangulation_2& tr, Index t, const Point& q)
{
  const Walk_end end = locate_or_exit(tr, t, q);
  return end.is_blocked() ? no_index : end.triangle;
}

/// The parts in which triangles hang together across sides, each from its first triangle on.
template <class Is_counted, class Is_wall>
std::vector<std::vector<Index>> connected_parts(const Triangles_2& tr, const Is_counted& is_counted,
                                                const Is_wall& is_wall)
{
  std::vector<std::vector<Index>> result;
  std::vector<char> is_done(tr.number_of_triangles(), 0);
  for (std::size_t k = 0; k < is_done.size(); ++k) {
    if (is_done[k] || !is_counted(static_cast<Index>(k)))
      continue;
    is_done[k] = 1;
    std::vector<Index> part{static_cast<Index>(k)};
    for (std::size_t j = 0; j < part.size(); ++j)
      for (int i = 0; i < 3; ++i) {
        const Index t = part[j], n = tr.neighbors[t][i];
        if (n == no_index || is_done[n] || is_wall(t, i) || !is_counted(n))
          continue;
        is_done[n] = 1;
        part.push_back(n);
      }
    result.push_back(std::move(part));
  }
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_FLAT_TRIANGULATION_2_H
