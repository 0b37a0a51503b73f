// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H

#include <CGAL/Bubble_relaxation_2/internal/domain/constraint_hierarchy.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The constrained edges of a user's triangulation that bound or cross the domain, as a graph, and the
/// straight chains that they form between corners. A vertex that only splits a straight constraint is
/// no corner, unless it is pinned.
///
/// Corners, chains and their directions are in the lexicographic order of points, so they depend neither
/// on the order in which the constraints were inserted nor on where faces lie in memory.
template <class Cdt>
class Constraint_graph_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// A straight chain: its corners, as indices of `corners()`, the vertices between them from source
  /// to target, and the sides on which the domain lies.
  struct Chain
  {
    Index source, target;
    bool inside_left, inside_right;
    std::vector<Vertex_handle> splits;
  };

  /// `is_inside(face)` tells the domain, `is_pinned(vertex)` what the user pinned. If `merge` is false
  /// every vertex is a corner.
  template <class Is_inside, class Is_pinned>
  Constraint_graph_2(const Cdt& cdt, const Is_inside& is_inside, const Is_pinned& is_pinned,
                     bool merge)
    : m_cdt(cdt), m_index(no_index)
  {
    collect_edges(is_inside);
    m_is_corner.assign(m_nodes.size(), 1);
    if (merge) {
      const Splitting_vertices<Cdt> splitting(cdt);
      for (std::size_t v = 0; v < m_nodes.size(); ++v)
        m_is_corner[v] = is_pinned(m_nodes[v].handle) || !only_splits(v, splitting);
    }
    while (!find_chains())
      ;
    for (std::size_t v = 0; v < m_nodes.size(); ++v)
      if (m_is_corner[v])
        m_corners.push_back(m_nodes[v].handle);
  }

  const std::vector<Vertex_handle>& corners() const { return m_corners; }
  const std::vector<Chain>& chains() const { return m_chains; }

  /// whether the vertex is an end of one of the graph's edges
  bool contains(Vertex_handle v) const { return m_index.is_defined(v); }

  /// whether a constraint without a part in the domain ends at a vertex of the graph
  bool touches_other_constraints() const
  {
    return std::any_of(m_nodes.begin(), m_nodes.end(), [](const Node& node) {
      return static_cast<std::size_t>(node.degree) != node.edges.size();
    });
  }

  /// the lexicographic order of points
  static bool is_before(Vertex_handle u, Vertex_handle v)
  {
    return CGAL::lexicographically_xy_smaller(u->point(), v->point());
  }

  static Point to_point(Vertex_handle v)
  {
    return Point(CGAL::to_double(v->point().x()), CGAL::to_double(v->point().y()));
  }

private:
  struct Half_edge
  {
    Index to;
    bool inside_left, inside_right;
  };

  struct Node
  {
    Vertex_handle handle;
    std::vector<Half_edge> edges; // in the order of their targets
    int degree = 0; // with constraints that have no part in the domain
  };

  struct Constrained_edge
  {
    Vertex_handle source, target;
    bool inside_left, inside_right;

    bool is_in_domain() const { return inside_left || inside_right; }
  };

  template <class Is_inside>
  void collect_edges(const Is_inside& is_inside)
  {
    const std::vector<Constrained_edge> edges = constrained_edges(is_inside);
    number_nodes(edges);
    for (const Constrained_edge& e : edges) {
      if (e.is_in_domain()) {
        const Index a = m_index[e.source], b = m_index[e.target];
        m_nodes[a].edges.push_back(Half_edge{b, e.inside_left, e.inside_right});
        m_nodes[b].edges.push_back(Half_edge{a, e.inside_right, e.inside_left});
      }
      for (Vertex_handle v : {e.source, e.target})
        if (contains(v))
          ++m_nodes[m_index[v]].degree;
    }
    for (Node& node : m_nodes)
      std::sort(node.edges.begin(), node.edges.end(),
                [](const Half_edge& e, const Half_edge& f) { return e.to < f.to; });
  }

  /// Every constrained edge once, from its lexicographically smaller end to the other. CGAL's iterator of
  /// edges is of no use here: which side of an edge it gives depends on the addresses of the faces.
  template <class Is_inside>
  std::vector<Constrained_edge> constrained_edges(const Is_inside& is_inside) const
  {
    std::vector<Constrained_edge> edges;
    for (auto f : m_cdt.all_face_handles())
      for (int i = 0; i < 3; ++i) {
        if (!f->is_constrained(i))
          continue;
        const Vertex_handle u = f->vertex(m_cdt.ccw(i)), v = f->vertex(m_cdt.cw(i));
        if (is_before(u, v))
          edges.push_back(Constrained_edge{u, v, is_inside(f), is_inside(f->neighbor(i))});
      }
    return edges;
  }

  void number_nodes(const std::vector<Constrained_edge>& edges)
  {
    std::vector<Vertex_handle> ends;
    for (const Constrained_edge& e : edges)
      if (e.is_in_domain())
        ends.insert(ends.end(), {e.source, e.target});
    std::sort(ends.begin(), ends.end(), is_before);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    for (Vertex_handle v : ends) {
      m_index[v] = static_cast<Index>(m_nodes.size());
      m_nodes.push_back(Node{v, {}, 0});
    }
  }

  Point point(std::size_t v) const { return to_point(m_nodes[v].handle); }

  bool only_splits(std::size_t v, const Splitting_vertices<Cdt>& splitting) const
  {
    const Node& node = m_nodes[v];
    if (node.degree != 2 || node.edges.size() != 2)
      return false;
    const Half_edge &a = node.edges[0], &b = node.edges[1];
    if (a.inside_left != b.inside_right || a.inside_right != b.inside_left)
      return false;
    return splitting(m_nodes[a.to].handle, node.handle, m_nodes[b.to].handle) &&
           lies_between(point(a.to), point(v), point(b.to));
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
          chain.splits.push_back(m_nodes[path[k]].handle);
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
    const Point a = point(path.front()), b = point(path.back());
    Index worst = no_index;
    double largest = 0;
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      const Point p = point(path[k]);
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

  const Cdt& m_cdt;
  Unique_hash_map<Vertex_handle, Index> m_index;
  std::vector<Node> m_nodes;
  std::vector<char> m_is_corner;
  std::vector<Vertex_handle> m_corners;
  std::vector<Chain> m_chains;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_CONSTRAINT_GRAPH_2_H
