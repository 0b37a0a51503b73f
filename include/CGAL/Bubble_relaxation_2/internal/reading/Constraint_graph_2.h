// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A constrained edge of a user's triangulation, from its lexicographically smaller end to the other, and the sides on
/// which the domain lies.
struct Constrained_edge_2
{
  Index source, target;
  bool inside_left, inside_right;
  bool is_of_one_constraint; ///< as far as the triangulation knows
  Edge_kind kind = Edge_kind::TAKES_BUBBLES;

  bool is_in_domain() const { return inside_left || inside_right; }
};

/// The constrained edges of a user's triangulation that bound or cross the domain, as a graph, and the
/// straight chains that they form between corners. A vertex that only splits a straight constraint is
/// no corner, unless it is pinned.
///
/// Vertices are numbered in the lexicographic order of points. Corners, chains and their directions are in this order,
/// so they depend neither on the order in which the constraints were inserted nor on where faces lie in memory.
class Constraint_graph_2
{
public:
  /// A straight chain: its corners, as indices of `corners()`, the vertices between them from source
  /// to target, and the sides on which the domain lies.
  struct Chain
  {
    Index source, target;
    bool inside_left, inside_right;
    std::vector<Index> splits;
    Edge_kind kind = Edge_kind::TAKES_BUBBLES;
  };

  /// `is_fixed`: of each vertex whether it is a corner wherever it lies
  Constraint_graph_2(const std::vector<Point>& points, std::vector<Constrained_edge_2> edges,
                     const std::vector<char>& is_fixed)
    : m_node(points.size(), no_index), m_constraints(std::move(edges))
  {
    number_nodes(points);
    add_edges();
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      tick(v);
      m_is_corner.push_back(is_fixed[m_vertices[v]] || !only_splits(v));
    }
    find_bends();
    find_chains();
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      if (m_is_corner[v])
        m_corners.push_back(m_vertices[v]);
  }

  const std::vector<Index>& corners() const { return m_corners; } ///< vertices
  const std::vector<Chain>& chains() const { return m_chains; }

  /// whether the vertex is an end of one of the graph's edges
  bool contains(Index v) const { return m_node[v] != no_index; }

  /// whether a constraint without a part in the domain ends at a vertex of the graph
  bool touches_other_constraints() const
  {
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      if (m_degrees[v] != m_edges[v].size())
        return true;
    return false;
  }

private:
  void number_nodes(const std::vector<Point>& points)
  {
    for (const Constrained_edge_2& e : m_constraints)
      if (e.is_in_domain())
        m_node[e.source] = m_node[e.target] = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (m_node[v] != no_index) {
        m_node[v] = static_cast<Index>(m_vertices.size());
        m_vertices.push_back(static_cast<Index>(v));
        m_points.push_back(points[v]);
      }
  }

  /// enters the edges at their ends; there they are in the order of the other ends, since they are sorted here
  void add_edges()
  {
    parallel_sort(Threads(), m_constraints, [](const Constrained_edge_2& e, const Constrained_edge_2& f) {
      return e.source != f.source ? e.source < f.source : e.target < f.target;
    });
    resize_in_turn(m_edges, m_vertices.size());
    resize_in_turn(m_degrees, m_vertices.size());
    for (std::size_t k = 0; k < m_constraints.size(); ++k) {
      tick(k);
      for (Index end : {m_constraints[k].source, m_constraints[k].target}) {
        const Index v = m_node[end];
        if (v == no_index)
          continue;
        ++m_degrees[v];
        if (m_constraints[k].is_in_domain())
          m_edges[v].push_back(static_cast<Index>(k));
      }
    }
  }

  /// the other end of an edge at a node
  Index other_end(Index edge, Index v) const
  {
    const Constrained_edge_2& e = m_constraints[edge];
    return m_node[e.source] == v ? m_node[e.target] : m_node[e.source];
  }

  /// whether the domain lies left of an edge, seen from one of its ends, and whether right of it
  std::array<bool, 2> sides(Index edge, Index v) const
  {
    const Constrained_edge_2& e = m_constraints[edge];
    if (m_node[e.source] == v)
      return {e.inside_left, e.inside_right};
    return {e.inside_right, e.inside_left};
  }

  bool only_splits(std::size_t node) const
  {
    const Index v = static_cast<Index>(node);
    if (m_degrees[v] != 2 || m_edges[v].size() != 2)
      return false;
    const Index a = m_edges[v][0], b = m_edges[v][1];
    const std::array<bool, 2> of_a = sides(a, v), of_b = sides(b, v);
    return of_a[0] == of_b[1] && of_a[1] == of_b[0] && m_constraints[a].is_of_one_constraint &&
           m_constraints[b].is_of_one_constraint &&
           lies_between(m_points[other_end(a, v)], m_points[v], m_points[other_end(b, v)]);
  }

  /// whether `p` is on the segment from `a` to `b` up to the rounding of its coordinates
  static bool lies_between(const Point& a, const Point& p, const Point& b)
  {
    const double ux = p.x() - a.x(), uy = p.y() - a.y(), vx = b.x() - p.x(), vy = b.y() - p.y();
    if (!(ux * vx + uy * vy > 0))
      return false;
    // u x v, not u x w: where p is a few roundings from b, products of two long vectors tell nothing
    const double off = std::abs(ux * vy - uy * vx) / length_of(b.x() - a.x(), b.y() - a.y());
    const double largest = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(a.x()),
                                       std::abs(a.y()), std::abs(b.x()), std::abs(b.y())});
    // a few roundings of the coordinates, but never a bend that could be meant
    return off <= rounding_of(largest) &&
           off <= 1e-3 * (std::min)(length_of(ux, uy), length_of(vx, vy));
  }

  /// Makes corners where paths from corner to corner are not straight, and of one vertex of each cycle without a corner.
  void find_bends()
  {
    std::vector<char> is_seen(m_vertices.size(), 0);
    const auto look_from = [&](Index v) {
      for (Index first : m_edges[v]) {
        const std::vector<Index> path = follow(v, first);
        for (Index u : path)
          is_seen[u] = 1;
        if (path.back() >= v) // else it is found from its other end
          bend(path);
      }
    };
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      if (m_is_corner[v])
        look_from(static_cast<Index>(v));
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      if (!is_seen[v]) {
        m_is_corner[v] = 1;
        look_from(static_cast<Index>(v));
      }
  }

  /// makes corners of vertices of a path until all parts between two of them are straight
  void bend(const std::vector<Index>& path)
  {
    std::vector<std::vector<Index>> parts{path};
    while (!parts.empty()) {
      tick();
      std::vector<Index> part = std::move(parts.back());
      parts.pop_back();
      if (part.back() < part.front()) // so that ties are the same from whichever end it was followed
        std::reverse(part.begin(), part.end());
      const std::size_t k = farthest_off(part);
      if (k == 0)
        continue;
      m_is_corner[part[k]] = 1;
      const auto middle = part.begin() + static_cast<std::ptrdiff_t>(k);
      parts.emplace_back(part.begin(), middle + 1);
      parts.emplace_back(middle, part.end());
    }
  }

  /// follows the edges from corner to corner
  void find_chains()
  {
    std::vector<Index> corner_number(m_vertices.size(), no_index);
    Index n = 0;
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      if (m_is_corner[v])
        corner_number[v] = n++;
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      tick(v);
      if (!m_is_corner[v])
        continue;
      for (Index first : m_edges[v]) {
        const std::vector<Index> path = follow(static_cast<Index>(v), first);
        if (path.back() < static_cast<Index>(v))
          continue; // found from its other end
        const std::array<bool, 2> inside = sides(first, static_cast<Index>(v));
        Chain chain{corner_number[v], corner_number[path.back()], inside[0], inside[1], {},
                    m_constraints[first].kind};
        for (std::size_t k = 1; k + 1 < path.size(); ++k)
          chain.splits.push_back(m_vertices[path[k]]);
        m_chains.push_back(std::move(chain));
      }
    }
  }

  std::vector<Index> follow(Index v, Index first) const
  {
    std::vector<Index> path{v, other_end(first, v)};
    while (!m_is_corner[path.back()]) {
      const Index last = path.back(), before = path[path.size() - 2], next = other_end(m_edges[last][0], last);
      path.push_back(next == before ? other_end(m_edges[last][1], last) : next);
    }
    return path;
  }

  /// the place in a path of a vertex that is not on the segment between its ends, although each piece is straight; 0 if
  /// all are
  std::size_t farthest_off(const std::vector<Index>& path) const
  {
    const Point &a = m_points[path.front()], &b = m_points[path.back()];
    std::size_t worst = 0;
    double largest = 0;
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Point& p = m_points[path[k]];
      if (lies_between(a, p, b))
        continue;
      const double off =
        std::abs((p.x() - a.x()) * (b.y() - a.y()) - (p.y() - a.y()) * (b.x() - a.x()));
      if (worst == 0 || off > largest) {
        worst = k;
        largest = off;
      }
    }
    return worst;
  }

  std::vector<Index> m_node; // of each vertex
  std::vector<Constrained_edge_2> m_constraints;
  std::vector<Index> m_vertices; // of each node
  std::vector<Point> m_points;
  std::vector<std::vector<Index>> m_edges; // in the domain, in the order of their other ends
  std::vector<std::size_t> m_degrees;      // with constraints that have no part in the domain
  std::vector<char> m_is_corner;
  std::vector<Index> m_corners;
  std::vector<Chain> m_chains;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
