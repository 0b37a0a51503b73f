// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_REPLACE_TRIANGLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_REPLACE_TRIANGLES_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Mesh_stitching_2.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What takes the place of some triangles where a vertex comes or goes.
struct Replacement_2
{
  std::vector<Index> old;
  std::vector<New_triangle_2> made;
};

inline bool is_counterclockwise(const Bubbles_2& b, const std::array<Index, 3>& v)
{
  return CGAL::orientation(b.point(v[0]), b.point(v[1]), b.point(v[2])) == LEFT_TURN;
}

/// whether none is flat or turned over, as rounding can have it
inline bool are_counterclockwise(const Bubbles_2& b, const std::vector<New_triangle_2>& triangles)
{
  return std::all_of(triangles.begin(), triangles.end(),
                     [&b](const New_triangle_2& t) { return is_counterclockwise(b, t.vertices); });
}

/// Splits triangle `t` at bubble `v` in it.
inline Replacement_2 split_triangle(const Marked_triangles_2& m, Index t, Index v)
{
  Replacement_2 result{{t}, {}};
  for (int i = 0; i < 3; ++i)
    result.made.push_back({{v, m.vertices[t][ccw(i)], m.vertices[t][cw(i)]}, {m.edges[t][i], no_index, no_index}});
  return result;
}

/// Splits side `i` of triangle `t` at bubble `v` on it, on both sides if the mesh goes on there.
inline Replacement_2 split_side(const Marked_triangles_2& m, Index t, int i, Index v)
{
  Replacement_2 result;
  const auto split = [&](Index k, int j) {
    const std::array<Index, 3>&corners = m.vertices[k], &edges = m.edges[k];
    const Index a = corners[j], b = corners[ccw(j)], c = corners[cw(j)];
    result.old.push_back(k);
    result.made.push_back({{a, b, v}, {edges[j], no_index, edges[cw(j)]}});
    result.made.push_back({{a, v, c}, {edges[j], edges[ccw(j)], no_index}});
  };
  split(t, i);
  if (const Index n = m.neighbors[t][i]; n != no_index)
    split(n, m.index_of_neighbor(n, t));
  return result;
}

/// Takes a vertex away: the polygons around it are triangulated by cutting ears off.
class Vertex_removal_2
{
public:
  /// \pre nothing but the domain is in the mesh, and all triangles around `v`, which is no corner, are
  Vertex_removal_2(const Bubble_mesh_2& mesh, Index v) : m_bubbles(mesh.bubbles), m_triangles(mesh.triangles)
  {
    for (std::size_t t = 0; t < m_triangles.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i)
        if (m_triangles.vertices[t][i] == v)
          m_corners.push_back(Corner_2{static_cast<Index>(t), i});
  }

  std::size_t number_of_triangles() const { return m_corners.size(); }

  /// whether the domain ends beside the vertex
  bool is_on_outline() const
  {
    return std::any_of(m_corners.begin(), m_corners.end(), [this](const Corner_2& c) {
      return edge(c, ccw(c.index)) == OUTLINE || edge(c, cw(c.index)) == OUTLINE;
    });
  }

  /// returns whether it can be done
  bool operator()(Replacement_2& result) const
  {
    for (const Corner_2& c : m_corners)
      result.old.push_back(c.triangle);
    bool has_begun = false;
    for (const Corner_2& c : m_corners)
      if (edge(c, cw(c.index)) != no_index) {
        has_begun = true;
        if (!cut_ears(polygon_from(c), result.made))
          return false;
      }
    return has_begun || cut_ears(polygon_from(m_corners.front()), result.made);
  }

private:
  /// of a polygon, which is on its left
  struct Side
  {
    Index source, target, edge;
  };

  Index edge(const Corner_2& c, int i) const { return m_triangles.edges[c.triangle][i]; }
  Index source(const Corner_2& c) const { return m_triangles.vertices[c.triangle][ccw(c.index)]; }
  Index target(const Corner_2& c) const { return m_triangles.vertices[c.triangle][cw(c.index)]; }

  /// From one corner on counterclockwise: all around, or to the edge of the domain that the vertex is on, which closes the
  /// polygon in one piece.
  std::vector<Side> polygon_from(const Corner_2& first) const
  {
    std::vector<Side> polygon;
    for (const Corner_2* c = &first;;) {
      polygon.push_back(Side{source(*c), target(*c), edge(*c, c->index)});
      if (const Index piece = edge(*c, ccw(c->index)); piece != no_index) {
        polygon.push_back(Side{target(*c), source(first), piece});
        return polygon;
      }
      c = &*std::find_if(m_corners.begin(), m_corners.end(),
                         [this, c](const Corner_2& next) { return source(next) == target(*c); });
      if (c == &first)
        return polygon;
    }
  }

  bool cut_ears(std::vector<Side> polygon, std::vector<New_triangle_2>& made) const
  {
    while (polygon.size() > 3) {
      std::size_t k = 0;
      while (k < polygon.size() && !is_ear(polygon, k))
        ++k;
      if (k == polygon.size())
        return false;
      const std::size_t next = (k + 1) % polygon.size();
      const Side first = polygon[k], second = polygon[next];
      made.push_back({{first.source, first.target, second.target}, {second.edge, no_index, first.edge}});
      polygon[k] = Side{first.source, second.target, no_index};
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(next));
    }
    if (polygon.size() < 3 || !is_ear(polygon, 0))
      return false;
    made.push_back({{polygon[0].source, polygon[1].source, polygon[2].source},
                    {polygon[1].edge, polygon[2].edge, polygon[0].edge}});
    return true;
  }

  /// whether a side and the next one make a triangle in the polygon
  bool is_ear(const std::vector<Side>& polygon, std::size_t k) const
  {
    const Index u = polygon[k].source, v = polygon[k].target, w = polygon[(k + 1) % polygon.size()].target;
    if (!is_counterclockwise(m_bubbles, {u, v, w}))
      return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](const Side& s) {
      const Point p = m_bubbles.point(s.source);
      const auto is_right_of = [&](Index from, Index to) {
        return CGAL::orientation(m_bubbles.point(from), m_bubbles.point(to), p) == RIGHT_TURN;
      };
      return s.source != u && s.source != v && s.source != w && !is_right_of(u, v) && !is_right_of(v, w) &&
             !is_right_of(w, u);
    });
  }

  const Bubbles_2& m_bubbles;
  const Marked_triangles_2& m_triangles;
  std::vector<Corner_2> m_corners; // of the vertex
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_REPLACE_TRIANGLES_H
