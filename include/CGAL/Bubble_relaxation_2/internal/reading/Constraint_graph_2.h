// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A constrained edge of a user's triangulation, from its lexicographically smaller end to the other, and the sides on
/// which the domain lies.
struct Constrained_edge_2
{
  Index source, target;
  bool inside_left, inside_right;
  bool is_of_one_constraint; ///< as far as the triangulation knows

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
  };

  /// `is_fixed`: of each vertex whether it is a corner wherever it lies
  Constraint_graph_2(const std::vector<Point>& points, const std::vector<Constrained_edge_2>& edges,
                     const std::vector<char>& is_fixed)
    : m_node(points.size(), no_index)
  {
    number_nodes(points, edges);
    for (const Constrained_edge_2& e : edges) {
      const Index a = m_node[e.source], b = m_node[e.target];
      if (e.is_in_domain()) {
        m_nodes[a].edges.push_back(Half_edge{b, e.inside_left, e.inside_right, e.is_of_one_constraint});
        m_nodes[b].edges.push_back(Half_edge{a, e.inside_right, e.inside_left, e.is_of_one_constraint});
      }
      for (Index v : {a, b})
        if (v != no_index)
          ++m_nodes[v].degree;
    }
    for (Node& node : m_nodes)
      std::sort(node.edges.begin(), node.edges.end(),
                [](const Half_edge& e, const Half_edge& f) { return e.to < f.to; });
    for (const Node& node : m_nodes)
      m_is_corner.push_back(is_fixed[node.vertex] || !only_splits(node));
    while (!find_chains())
      ;
    for (std::size_t v = 0; v < m_nodes.size(); ++v)
      if (m_is_corner[v])
        m_corners.push_back(m_nodes[v].vertex);
  }

  const std::vector<Index>& corners() const { return m_corners; } ///< vertices
  const std::vector<Chain>& chains() const { return m_chains; }

  /// whether the vertex is an end of one of the graph's edges
  bool contains(Index v) const { return m_node[v] != no_index; }

  /// whether a constraint without a part in the domain ends at a vertex of the graph
  bool touches_other_constraints() const
  {
    return std::any_of(m_nodes.begin(), m_nodes.end(),
                       [](const Node& node) { return node.degree != node.edges.size(); });
  }

private:
  struct Half_edge
  {
    Index to;
    bool inside_left, inside_right, is_of_one_constraint;
  };

  struct Node
  {
    Index vertex;
    Point point;
    std::vector<Half_edge> edges; // in the order of their targets
    std::size_t degree = 0;       // with constraints that have no part in the domain
  };

  void number_nodes(const std::vector<Point>& points, const std::vector<Constrained_edge_2>& edges)
  {
    for (const Constrained_edge_2& e : edges)
      if (e.is_in_domain())
        m_node[e.source] = m_node[e.target] = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
      if (m_node[v] != no_index) {
        m_node[v] = static_cast<Index>(m_nodes.size());
        m_nodes.push_back(Node{static_cast<Index>(v), points[v], {}, 0});
      }
  }

  bool only_splits(const Node& node) const
  {
    if (node.degree != 2 || node.edges.size() != 2)
      return false;
    const Half_edge &a = node.edges[0], &b = node.edges[1];
    return a.inside_left == b.inside_right && a.inside_right == b.inside_left && a.is_of_one_constraint &&
           b.is_of_one_constraint && lies_between(m_nodes[a.to].point, node.point, m_nodes[b.to].point);
  }

  /// whether `p` is on the segment from `a` to `b` up to the rounding of its coordinates
  static bool lies_between(const Point& a, const Point& p, const Point& b)
  {
    const double ux = p.x() - a.x(), uy = p.y() - a.y(), vx = b.x() - p.x(), vy = b.y() - p.y();
    if (!(ux * vx + uy * vy > 0))
      return false;
    const double wx = b.x() - a.x(), wy = b.y() - a.y();
    const double off = std::abs(ux * wy - uy * wx) / std::hypot(wx, wy);
    const double largest = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(a.x()),
                                       std::abs(a.y()), std::abs(b.x()), std::abs(b.y())});
    // a few roundings of the coordinates, but never a bend that could be meant
    return off <= 16 * std::numeric_limits<double>::epsilon() * largest &&
           off <= 1e-3 * (std::min)(std::hypot(ux, uy), std::hypot(vx, vy));
  }

  /// follows the edges from corner to corner; returns false when a vertex had to become a corner
  bool find_chains()
  {
    m_chains.clear();
    std::vector<Index> corner_number(m_nodes.size(), no_index);
    Index n = 0;
    for (std::size_t v = 0; v < m_nodes.size(); ++v)
      if (m_is_corner[v])
        corner_number[v] = n++;
    std::vector<char> seen(m_nodes.size(), 0);
    for (std::size_t v = 0; v < m_nodes.size(); ++v) {
      if (!m_is_corner[v])
        continue;
      for (const Half_edge& first : m_nodes[v].edges) {
        std::vector<Index> path = follow(static_cast<Index>(v), first);
        for (std::size_t k = 1; k + 1 < path.size(); ++k)
          seen[path[k]] = 1;
        if (path.back() < static_cast<Index>(v))
          continue; // found from its other end
        const Index bend = farthest_off(path);
        if (bend != no_index) {
          m_is_corner[bend] = 1;
          return false;
        }
        Chain chain{corner_number[v], corner_number[path.back()], first.inside_left,
                    first.inside_right, {}};
        for (std::size_t k = 1; k + 1 < path.size(); ++k)
          chain.splits.push_back(m_nodes[path[k]].vertex);
        m_chains.push_back(std::move(chain));
      }
    }
    for (std::size_t v = 0; v < m_nodes.size(); ++v)
      if (!m_is_corner[v] && !seen[v]) { // a cycle without a corner
        m_is_corner[v] = 1;
        return false;
      }
    return true;
  }

  std::vector<Index> follow(Index v, const Half_edge& first) const
  {
    std::vector<Index> path{v, first.to};
    while (!m_is_corner[path.back()]) {
      const Node& node = m_nodes[path.back()];
      const Index before = path[path.size() - 2];
      path.push_back(node.edges[0].to == before ? node.edges[1].to : node.edges[0].to);
    }
    return path;
  }

  /// a vertex of the path that is not on the segment between its ends, although each piece is straight
  Index farthest_off(const std::vector<Index>& path) const
  {
    const Point &a = m_nodes[path.front()].point, &b = m_nodes[path.back()].point;
    Index worst = no_index;
    double largest = 0;
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Point& p = m_nodes[path[k]].point;
      if (lies_between(a, p, b))
        continue;
      const double off =
        std::abs((p.x() - a.x()) * (b.y() - a.y()) - (p.y() - a.y()) * (b.x() - a.x()));
      if (worst == no_index || off > largest) {
        worst = path[k];
        largest = off;
      }
    }
    return worst;
  }

  std::vector<Index> m_node; // of each vertex
  std::vector<Node> m_nodes;
  std::vector<char> m_is_corner;
  std::vector<Index> m_corners;
  std::vector<Chain> m_chains;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
