// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_CELL_POLYGONS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_CELL_POLYGONS_2_H

#include <CGAL/Bubble_relaxation_2/internal/dual/dual_faces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The cells of a dual as polygons with common corners: circumcentres, and on the domain's boundary vertices and the
/// midpoints of edges.
class Cell_polygons_2
{
public:
  using Polygon = std::vector<std::size_t>; ///< numbers of corners, counterclockwise

  explicit Cell_polygons_2(const Flat_triangulation_2& tr)
    : m_tr(tr), m_centers(tr.number_of_triangles(), 0), m_middles(3 * tr.number_of_triangles(), no_corner),
      m_vertices(tr.points.size(), no_corner), m_is_done(3 * tr.number_of_triangles(), 0)
  {
    for (std::size_t k = 0; k < tr.number_of_triangles(); ++k) {
      const Index t = static_cast<Index>(k);
      if (tr.inside[t])
        m_centers[t] = add_corner(circumcenter_of(tr, t));
    }
    add_polygons(true);
    add_polygons(false);
    std::stable_sort(m_polygons.begin(), m_polygons.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  const std::vector<Point>& corners() const { return m_corners; }

  /// the polygons in the order of their vertices: mostly one each, more where the domain touches itself in the vertex
  const std::vector<std::pair<Index, Polygon>>& polygons() const { return m_polygons; }

  /// the halves of a boundary edge, from its first vertex to its second one
  std::array<std::array<std::size_t, 2>, 2> halves(const Dual_face_2& f) const
  {
    const std::size_t middle = m_middles[corner(f.triangle, f.side)];
    return {{{m_vertices[f.a], middle}, {middle, m_vertices[f.b]}}};
  }

private:
  static constexpr std::size_t no_corner = static_cast<std::size_t>(-1);

  static std::size_t corner(Index t, int i) { return 3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(i); }

  bool is_inside(Index t) const { return t != no_index && m_tr.inside[t]; }

  std::size_t add_corner(const Point& p)
  {
    m_corners.push_back(p);
    return m_corners.size() - 1;
  }

  /// \param are_open those that begin at the boundary, or those all around a vertex, once these are done
  void add_polygons(bool are_open)
  {
    for (std::size_t k = 0; k < m_tr.number_of_triangles(); ++k)
      for (int j = 0; j < 3 && m_tr.inside[k]; ++j) {
        const Index t = static_cast<Index>(k);
        if (!m_is_done[corner(t, j)] && (!are_open || !is_inside(m_tr.neighbors[t][cw(j)])))
          add_polygon(t, j, are_open);
      }
  }

  /// goes around the vertex `j` of a triangle, counterclockwise
  void add_polygon(Index t, int j, bool is_open)
  {
    const Index v = m_tr.vertices[t][j];
    Polygon polygon;
    if (is_open)
      polygon = {vertex(v), middle(t, cw(j))};
    while (!m_is_done[corner(t, j)]) {
      m_is_done[corner(t, j)] = 1;
      polygon.push_back(m_centers[t]);
      const Index next = m_tr.neighbors[t][ccw(j)];
      if (!is_inside(next)) {
        polygon.push_back(middle(t, ccw(j)));
        break;
      }
      t = next;
      j = m_tr.index_of_vertex(t, v);
    }
    m_polygons.emplace_back(v, std::move(polygon));
  }

  std::size_t vertex(Index v)
  {
    if (m_vertices[v] == no_corner)
      m_vertices[v] = add_corner(m_tr.points[v]);
    return m_vertices[v];
  }

  /// the midpoint of a boundary edge
  std::size_t middle(Index t, int i)
  {
    std::size_t& number = m_middles[corner(t, i)];
    if (number == no_corner)
      number = add_corner(middle_of_side(m_tr, t, i));
    return number;
  }

  const Flat_triangulation_2& m_tr;
  std::vector<std::size_t> m_centers, m_middles, m_vertices; // their numbers as corners
  std::vector<char> m_is_done;                               // the corners of triangles
  std::vector<Point> m_corners;
  std::vector<std::pair<Index, Polygon>> m_polygons;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DUAL_CELL_POLYGONS_2_H
