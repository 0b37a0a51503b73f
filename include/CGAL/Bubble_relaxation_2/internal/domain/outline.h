// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_OUTLINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_OUTLINE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bubbles on each edge of the domain in the order from source to target, without the ends.
inline std::vector<std::vector<Index>> bubbles_on_edges(const Domain_2& domain, const Bubbles_2& b)
{
  std::vector<std::vector<Index>> on_edge(domain.edges().size());
  for (std::size_t i = 0; i < b.size(); ++i) {
    tick(i);
    if (b.is_on_edge(i))
      on_edge[b.host[i]].push_back(static_cast<Index>(i));
  }
  for (std::vector<Index>& bubbles : on_edge)
    std::sort(bubbles.begin(), bubbles.end(), [&](Index i, Index j) {
      return b.s[i] < b.s[j] || (b.s[i] == b.s[j] && i < j);
    });
  return on_edge;
}

/// The bubble on each corner of the domain.
inline std::vector<Index> bubbles_on_corners(const Domain_2& domain, const Bubbles_2& b)
{
  std::vector<Index> on_corner(domain.corners().size(), no_index);
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.is_corner(i) && b.host[i] != no_index)
      on_corner[b.host[i]] = static_cast<Index>(i);
  return on_corner;
}

/// The edge of the domain that has the piece between two bubbles.
inline Index edge_of_piece(const Domain_2& domain, const Bubbles_2& b, Index i, Index j)
{
  if (b.is_on_edge(i))
    return b.host[i];
  return b.is_on_edge(j) ? b.host[j] : domain.edge_between(b.host[i], b.host[j]);
}

/// where a bubble is on an edge of the domain, or at an end of it: 0 at its source, 1 at its target
inline double position_on(const Domain_2& domain, const Bubbles_2& b, Index edge, Index i)
{
  return b.is_on_edge(i) ? b.s[i] : b.host[i] == domain.edges()[edge].source ? 0 : 1;
}

/// Calls `visit(t, i, e, is_left)` for the sides `i` of triangles of a mesh that lie on an edge `e` of the domain:
/// whether the triangle is left of it, seen from its source.
template <class Visit>
void for_each_piece(const Domain_2& domain, const Bubble_mesh_2& mesh, const Visit& visit)
{
  const Marked_triangles_2& tr = mesh.triangles;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (tr.edges[t][i] == no_index)
        continue;
      const Index a = tr.vertices[t][ccw(i)], b = tr.vertices[t][cw(i)],
                  e = edge_of_piece(domain, mesh.bubbles, a, b);
      const bool is_left = position_on(domain, mesh.bubbles, e, a) < position_on(domain, mesh.bubbles, e, b);
      visit(static_cast<Index>(t), i, e, is_left);
    }
}

/// The edges of the domain cut at their bubbles, between indices of bubbles.
inline std::vector<Domain_edge_2> cut_edges(const Domain_2& domain, const Bubbles_2& b)
{
  const std::vector<std::vector<Index>> on_edge = bubbles_on_edges(domain, b);
  const std::vector<Index> on_corner = bubbles_on_corners(domain, b);
  std::vector<Domain_edge_2> pieces;
  for (std::size_t e = 0; e < on_edge.size(); ++e) {
    Domain_edge_2 piece = domain.edges()[e];
    const Index target = on_corner[piece.target];
    piece.source = on_corner[piece.source];
    for (Index i : on_edge[e]) {
      piece.target = i;
      pieces.push_back(piece);
      piece.source = i;
    }
    piece.target = target;
    pieces.push_back(piece);
  }
  return pieces;
}

/// where bubbles are
inline std::vector<Point> points_of(const Bubbles_2& bubbles)
{
  std::vector<Point> points;
  points.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    tick(i);
    points.push_back(bubbles.point(i));
  }
  return points;
}

/// Makes the triangles of a mesh of bubbles anew: their constrained Delaunay triangulation with the domain marked.
/// Returns whether it can be made.
inline bool try_to_triangulate(const std::vector<Domain_edge_2>& edges, Bubble_mesh_2& mesh)
{
  mesh.triangles = Marked_triangles_2();
  return mark_triangulation(points_of(mesh.bubbles), edges, mesh.triangles) == Marking_error::NONE;
}

/// where a corner of the domain is nearest to an edge across a triangle
inline Point narrowest_place(const Domain_2& domain)
{
  const Flat_triangulation_2& tr = domain.triangulation();
  double least = (std::numeric_limits<double>::infinity)();
  Point place = domain.corners().front();
  for (std::size_t k = 0; k < tr.number_of_triangles(); ++k)
    for (int i = 0; i < 3; ++i) {
      const Index t = static_cast<Index>(k), e = domain.edge(t, i);
      if (e == no_index || CGAL::angle(tr.point(t, i), tr.point(t, ccw(i)), tr.point(t, cw(i))) == OBTUSE ||
          CGAL::angle(tr.point(t, i), tr.point(t, cw(i)), tr.point(t, ccw(i))) == OBTUSE)
        continue;
      const double height = 2 * std::abs(CGAL::area(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2))) / domain.length(e);
      if (height < least) {
        least = height;
        place = tr.point(t, i);
      }
    }
  return place;
}

struct Edges_too_near : std::runtime_error
{
  explicit Edges_too_near(const Domain_2& domain) : Edges_too_near(narrowest_place(domain)) {}

private:
  explicit Edges_too_near(const Point& place)
    : std::runtime_error("Bubble_relaxation_2: edges of the domain lie nearer to each other than the rounding of "
                         "bubbles on them; nearest to another edge is the vertex " +
                         in_words(place.x(), place.y()) + ": if it is to lie on that edge, make it an end of it")
  {}
};

/// The same with the edges of a domain.
/// \pre no two bubbles are in one place, see `remove_coincident()`
inline void triangulate(const Domain_2& domain, Bubble_mesh_2& mesh)
{
  if (!try_to_triangulate(cut_edges(domain, mesh.bubbles), mesh))
    throw Edges_too_near(domain);
}

/// Numbers the bubbles along the Hilbert curve: neighbours in space are near in memory.
inline void sort_in_space(const Domain_2& domain, Bubbles_2& bubbles, const Threads& threads = Threads())
{
  bubbles.select(hilbert_order(hilbert_curve(domain), points_of(bubbles), threads));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_OUTLINE_H
