// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EDITABLE_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EDITABLE_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What bubbles and triangles of a mesh were before they were changed, so that all changes can be undone. In a mesh
/// that is good almost everywhere few are changed, and this takes far less than a copy.
class Undo_log_2
{
public:
  /// where a bubble was, for `note()`
  struct Vertex
  {
    Index bubble, host;
    double x, y, s;
  };

  /// where a bubble is
  static Vertex vertex(const Bubbles_2& b, Index v) { return Vertex{v, b.host[v], b.x[v], b.y[v], b.s[v]}; }

  /// puts a bubble where that says
  static void put(const Vertex& v, Bubbles_2& b)
  {
    b.host[v.bubble] = v.host;
    b.x[v.bubble] = v.x;
    b.y[v.bubble] = v.y;
    b.s[v.bubble] = v.s;
  }

  /// a bubble was moved, or is going to be
  void note(const Vertex& before) { m_vertices.push_back(before); }

  /// a triangle, or what it knows of its neighbours, is going to be changed
  void note(const Marked_triangles_2& triangles, Index t)
  {
    m_triangles.push_back(
      Triangle{t, triangles.inside[t] != 0, triangles.vertices[t], triangles.neighbors[t], triangles.edges[t]});
  }

  /// makes all what it was when the log was empty, and empties it
  void undo(Bubble_mesh_2& mesh)
  {
    Marked_triangles_2& triangles = mesh.triangles;
    for (auto v = m_vertices.rbegin(); v != m_vertices.rend(); ++v)
      put(*v, mesh.bubbles);
    for (auto t = m_triangles.rbegin(); t != m_triangles.rend(); ++t) {
      triangles.inside[t->triangle] = t->is_inside;
      triangles.vertices[t->triangle] = t->vertices;
      triangles.neighbors[t->triangle] = t->neighbors;
      triangles.edges[t->triangle] = t->edges;
    }
    m_vertices.clear();
    m_triangles.clear();
  }

private:
  struct Triangle
  {
    Index triangle;
    bool is_inside;
    std::array<Index, 3> vertices, neighbors, edges;
  };

  std::vector<Vertex> m_vertices;
  std::vector<Triangle> m_triangles;
};

/// A vertex in one of its triangles.
struct Corner_2
{
  Index triangle;
  int index; // of the vertex in the triangle
};

using Star_2 = boost::container::small_vector<Corner_2, 10>;

/// A mesh of bubbles whose edges are flipped, and into which vertices are inserted, as far as it is inside of the domain.
class Editable_triangulation_2
{
public:
  /// `log`: told of all triangles that are changed; not of vertices that are moved
  explicit Editable_triangulation_2(Bubble_mesh_2& mesh, Undo_log_2* log = nullptr)
    : m_mesh(mesh), m_triangles(mesh.triangles), m_log(log), m_triangle_of(mesh.bubbles.size(), no_index)
  {
    for (std::size_t t = 0; t < m_triangles.number_of_triangles(); ++t) {
      tick(t);
      for (Index v : m_triangles.vertices[t])
        if (m_triangles.inside[t] || m_triangle_of[v] == no_index)
          m_triangle_of[v] = static_cast<Index>(t);
    }
  }

  const Bubble_mesh_2& mesh() const { return m_mesh; }
  const std::array<Index, 3>& vertices(Index t) const { return m_triangles.vertices[t]; }
  bool is_inside(Index t) const { return m_triangles.inside[t] != 0; }

  /// all triangles around a vertex, counterclockwise; on the convex hull from one end to the other
  Star_2 star(Index v) const
  {
    Star_2 corners;
    const Corner_2 start = corner(m_triangle_of[v], v);
    Corner_2 c = start;
    do {
      corners.push_back(c);
      const Index next = m_triangles.neighbors[c.triangle][ccw(c.index)];
      if (next == no_index) { // the hull: what lies clockwise of the first comes before it
        add_clockwise(start, v, corners);
        break;
      }
      c = corner(next, v);
    } while (c.triangle != start.triangle);
    return corners;
  }

  /// whether all triangles of the domain in the star of a vertex stay counterclockwise when it moves to `p`
  bool stays_valid(const Star_2& star, const Point& p) const
  {
    for (const Corner_2& c : star) {
      const Point a = m_mesh.point(c.triangle, ccw(c.index)), b = m_mesh.point(c.triangle, cw(c.index));
      if (is_inside(c.triangle) && CGAL::orientation(p, a, b) != LEFT_TURN)
        return false;
    }
    return true;
  }

  /// flips edges until the domain has a constrained Delaunay triangulation again, after some vertices were moved
  /// so little that all its triangles are still counterclockwise
  void restore_delaunay(const std::vector<Index>& moved)
  {
    std::size_t number = 0;
    for (Index v : moved) {
      tick(number++);
      for (const Corner_2& c : star(v)) {
        m_doubtful.push_back(c);
        m_doubtful.push_back(Corner_2{c.triangle, ccw(c.index)});
      }
      flip_doubtful();
    }
  }

  /// the same around one triangle that is new or has vertices that were moved
  void restore_delaunay_around(Index t)
  {
    for (int i = 0; i < 3; ++i)
      m_doubtful.push_back(Corner_2{t, i});
    flip_doubtful();
  }

  /// Splits triangle `t` at bubble `v`, which lies in it and is not in the mesh yet, and flips edges. \pre there is no log
  void insert_in_triangle(Index v, Index t)
  {
    const std::array<Index, 3> corners = m_triangles.vertices[t], beyond = m_triangles.neighbors[t],
                               edges = m_triangles.edges[t],
                               parts = {t, append_triangle(m_triangles), append_triangle(m_triangles)};
    for (int i = 0; i < 3; ++i) {
      put(parts[i], {v, corners[ccw(i)], corners[cw(i)]}, {beyond[i], parts[ccw(i)], parts[cw(i)]},
          {edges[i], no_index, no_index});
      set_neighbor(beyond[i], corners[ccw(i)], corners[cw(i)], parts[i]);
    }
    flip_doubtful();
  }

  /// The same for a bubble on side `i` of `t`. A triangle outside of the domain is cut off: it is to be made anew.
  void insert_on_side(Index v, Index t, int i)
  {
    const Index n = m_triangles.neighbors[t][i], t2 = append_triangle(m_triangles);
    const Index source = m_triangles.vertices[t][ccw(i)], target = m_triangles.vertices[t][cw(i)];
    if (n != no_index && is_inside(n)) {
      const Index n2 = append_triangle(m_triangles);
      split_side(v, t, i, t2, {n2, n});
      split_side(v, n, m_triangles.index_of_side(n, source, target), n2, {t2, t});
    } else {
      split_side(v, t, i, t2, {no_index, no_index});
      set_neighbor(n, source, target, no_index);
    }
    flip_doubtful();
  }

  /// makes an end of the mesh beside a triangle, which is not in the domain any more
  void cut_off(Index t)
  {
    note(t);
    m_triangles.inside[t] = 0;
    for (int i = 0; i < 3; ++i) {
      const Index n = std::exchange(m_triangles.neighbors[t][i], no_index);
      note(n);
      set_neighbor(n, m_triangles.vertices[t][ccw(i)], m_triangles.vertices[t][cw(i)], no_index);
    }
  }

  /// the triangles that were flipped since this was asked last, some of them several times
  std::vector<Index> take_flipped() { return std::exchange(m_flipped, {}); }

private:
  /// puts a triangle in the place of another one; its sides may have to be flipped
  void put(Index t, const std::array<Index, 3>& vertices, const std::array<Index, 3>& neighbors,
           const std::array<Index, 3>& edges)
  {
    m_triangles.vertices[t] = vertices;
    m_triangles.neighbors[t] = neighbors;
    m_triangles.edges[t] = edges;
    m_triangle_of.resize(m_mesh.bubbles.size(), no_index);
    for (int i = 0; i < 3; ++i) {
      m_triangle_of[vertices[i]] = t;
      m_doubtful.push_back(Corner_2{t, i});
    }
  }

  /// makes two triangles of one, the second in the place of `t2`; `beyond`: what is beyond the parts of side `i`
  void split_side(Index v, Index t, int i, Index t2, const std::array<Index, 2>& beyond)
  {
    const std::array<Index, 3> corners = m_triangles.vertices[t], neighbors = m_triangles.neighbors[t],
                               edges = m_triangles.edges[t];
    const Index a = corners[i], b = corners[ccw(i)], c = corners[cw(i)];
    put(t, {a, b, v}, {beyond[0], t2, neighbors[cw(i)]}, {edges[i], no_index, edges[cw(i)]});
    put(t2, {a, v, c}, {beyond[1], neighbors[ccw(i)], t}, {edges[i], edges[ccw(i)], no_index});
    set_neighbor(neighbors[ccw(i)], c, a, t2);
  }

  void flip_doubtful()
  {
    while (!m_doubtful.empty()) {
      const Corner_2 edge = m_doubtful.back();
      m_doubtful.pop_back();
      flip_unless_delaunay(edge.triangle, edge.index);
    }
  }

  /// puts the triangles around `v` that lie clockwise of a corner, up to the hull, before those that are there
  void add_clockwise(Corner_2 c, Index v, Star_2& corners) const
  {
    Star_2 before;
    for (Index t; (t = m_triangles.neighbors[c.triangle][cw(c.index)]) != no_index; before.push_back(c))
      c = corner(t, v);
    corners.insert(corners.begin(), before.rbegin(), before.rend());
  }

  Corner_2 corner(Index t, Index v) const { return Corner_2{t, m_triangles.index_of_vertex(t, v)}; }

  void flip_unless_delaunay(Index t, int i)
  {
    const Index n = m_triangles.neighbors[t][i];
    if (n == no_index || m_triangles.edges[t][i] != no_index || !is_inside(t))
      return;
    const int j = m_triangles.index_of_neighbor(n, t);
    if (is_delaunay(t, i, n, j))
      return;
    flip(t, i, n, j);
    for (Index flipped : {t, n}) {
      m_flipped.push_back(flipped);
      for (int k = 0; k < 3; ++k)
        m_doubtful.push_back(Corner_2{flipped, k});
    }
  }

  /// Of four vertices on a circle the edge must not end at the last one in the order of coordinates, as if that
  /// were a little outside. This is how CGAL's triangulations have it: the order of flips does not matter.
  bool is_delaunay(Index t, int i, Index n, int j) const
  {
    const Point a = m_mesh.point(t, i), b = m_mesh.point(t, ccw(i)), c = m_mesh.point(t, cw(i)), d = m_mesh.point(n, j);
    const Oriented_side side = CGAL::side_of_oriented_circle(a, b, c, d);
    if (side != ON_ORIENTED_BOUNDARY)
      return side == ON_NEGATIVE_SIDE;
    const auto is_smaller = [](const Point& p, const Point& q) { return CGAL::lexicographically_xy_smaller(p, q); };
    const Point& last = (std::max)(b, c, is_smaller);
    return is_smaller(last, a) || is_smaller(last, d);
  }

  /// replaces the common edge of the triangles `t` = (a, b, c) and `n` = (d, c, b), opposite to their
  /// vertices `i` (a) and `j` (d), by the edge between a and d
  void flip(Index t, int i, Index n, int j)
  {
    auto &vt = m_triangles.vertices[t], &vn = m_triangles.vertices[n];
    auto &nt = m_triangles.neighbors[t], &nn = m_triangles.neighbors[n];
    auto &et = m_triangles.edges[t], &en = m_triangles.edges[n];
    const Index a = vt[i], b = vt[ccw(i)], c = vt[cw(i)], d = vn[j];
    const Index beyond_ab = nt[cw(i)], beyond_ca = nt[ccw(i)], beyond_bd = nn[ccw(j)], beyond_dc = nn[cw(j)];
    for (Index changed : {t, n, beyond_ab, beyond_ca, beyond_bd, beyond_dc})
      note(changed);
    const Index edge_ab = et[cw(i)], edge_ca = et[ccw(i)], edge_bd = en[ccw(j)], edge_dc = en[cw(j)];
    vt = {a, b, d};
    nt = {beyond_bd, n, beyond_ab};
    et = {edge_bd, no_index, edge_ab};
    vn = {a, d, c};
    nn = {beyond_dc, beyond_ca, t};
    en = {edge_dc, edge_ca, no_index};
    set_neighbor(beyond_bd, b, d, t);
    set_neighbor(beyond_ca, c, a, n);
    m_triangle_of[a] = m_triangle_of[b] = m_triangle_of[d] = t;
    m_triangle_of[c] = n;
  }

  void note(Index t)
  {
    if (m_log && t != no_index)
      m_log->note(m_triangles, t);
  }

  /// makes `neighbor` what lies beyond the side of `t` between the vertices `u` and `v`
  void set_neighbor(Index t, Index u, Index v, Index neighbor)
  {
    if (t != no_index)
      m_triangles.neighbors[t][m_triangles.index_of_side(t, u, v)] = neighbor;
  }

  const Bubble_mesh_2& m_mesh;
  Marked_triangles_2& m_triangles; // of it
  Undo_log_2* m_log;
  std::vector<Index> m_triangle_of; // one of each vertex
  std::vector<Corner_2> m_doubtful; // edges, each opposite to a vertex of a triangle
  std::vector<Index> m_flipped;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EDITABLE_TRIANGULATION_2_H
