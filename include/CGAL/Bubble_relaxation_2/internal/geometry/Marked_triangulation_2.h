// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARKED_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARKED_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What may become of an edge of the domain.
enum class Edge_kind : char
{
  TAKES_BUBBLES, ///< they slide on it
  PROTECTED,     ///< the user wants it to stay as it is
  RIM            ///< what lies behind it is not meshed now, and it is not to be split
};

/// A straight edge of the domain between two corners. `inside_left` and `inside_right` tell whether the domain lies on
/// these sides, seen from source to target.
struct Domain_edge_2
{
  Index source;
  Index target;
  bool inside_left;
  bool inside_right;
  Edge_kind kind = Edge_kind::TAKES_BUBBLES;

  bool takes_bubbles() const { return kind == Edge_kind::TAKES_BUBBLES; }
};

/// The triangles of a constrained Delaunay triangulation with the domain marked.
struct Marked_triangles_2 : Triangles_2
{
  /// per triangle and side: index of the edge behind it, or `no_index`; in the treatment a label, see `Edge_label`
  std::vector<std::array<Index, 3>> edges;
};

/// The same with the points.
struct Marked_triangulation_2 : Flat_triangulation_2
{
  std::vector<std::array<Index, 3>> edges; ///< per triangle and side: index of the edge behind it or `no_index`
};

/// What `mark_triangulation()` found wrong with its edges.
enum class Marking_error
{
  NONE, EDGES_CROSS, EDGE_THROUGH_POINT, EDGE_TWICE, POINTS_COINCIDE, NO_TRIANGLE, MARKS_DIFFER
};

/// Triangulates `points` with the constraints `edges` and marks the domain: a triangle beside an
/// edge gets the side's mark, and marks spread until the next edge. Points are looked for from one to the next, which
/// should be near. `sides`: per triangle, what edge is behind each
CGAL_BUBBLE_RELAXATION_2_INLINE
Marking_error mark_triangulation(const std::vector<Point>& points, const std::vector<Domain_edge_2>& edges,
                                 Triangles_2& result, std::vector<std::array<Index, 3>>& sides);

inline Marking_error mark_triangulation(const std::vector<Point>& points, const std::vector<Domain_edge_2>& edges,
                                        Marked_triangles_2& result)
{
  return mark_triangulation(points, edges, result, result.edges);
}

inline Marking_error mark_triangulation(const std::vector<Point>& points, const std::vector<Domain_edge_2>& edges,
                                        Marked_triangulation_2& result)
{
  result.points = points;
  return mark_triangulation(points, edges, result, result.edges);
}

/// What `Marked_triangles_2::edges` says of sides on edges of the domain while defects are treated: unlike an index,
/// it stays what it is when vertices on edges come and go, and all ranks understand it.
enum Edge_label : Index { OUTLINE = 0, INNER = 1 };

/// whether the domain ends or goes on beyond a side on an edge of the domain
inline Edge_label edge_label(const Marked_triangles_2& m, Index t, int i)
{
  const Index n = m.neighbors[t][i];
  return n != no_index && m.inside[n] ? INNER : OUTLINE;
}

/// makes indices of edges labels
inline void label_edges(Marked_triangles_2& m)
{
  for (std::size_t t = 0; t < m.edges.size(); ++t) {
    tick(t);
    for (int i = 0; i < 3; ++i)
      if (m.edges[t][i] != no_index)
        m.edges[t][i] = edge_label(m, static_cast<Index>(t), i);
  }
}

/// Adds a triangle of the domain after the last, which is still to be put there; returns its number.
inline Index append_triangle(Marked_triangles_2& m)
{
  for (auto* corners : {&m.vertices, &m.neighbors, &m.edges}) {
    make_room_for(1, *corners);
    corners->emplace_back();
  }
  m.inside.push_back(1);
  return static_cast<Index>(m.inside.size() - 1);
}

/// Forgets all triangles but those for which `is_kept(t)` holds; returns the new numbers, `no_index` for the others.
template <class Is_kept>
std::vector<Index> keep_triangles(Marked_triangles_2& m, const Is_kept& is_kept)
{
  std::vector<Index> number(m.number_of_triangles(), no_index);
  Index left = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    tick(t);
    if (is_kept(t))
      number[t] = left++;
  }
  for (std::size_t t = 0; t < number.size(); ++t) {
    tick(t);
    if (number[t] == no_index)
      continue;
    m.vertices[number[t]] = m.vertices[t];
    m.edges[number[t]] = m.edges[t];
    m.inside[number[t]] = m.inside[t];
    for (int i = 0; i < 3; ++i) {
      const Index n = m.neighbors[t][i];
      m.neighbors[number[t]][i] = n == no_index ? no_index : number[n];
    }
  }
  m.vertices.resize(static_cast<std::size_t>(left));
  m.neighbors.resize(static_cast<std::size_t>(left));
  m.edges.resize(static_cast<std::size_t>(left));
  m.inside.resize(static_cast<std::size_t>(left));
  return number;
}

/// of each of so many vertices whether a triangle inside of the domain, or outside, has it
inline std::vector<char> vertices_of_triangles(const Marked_triangles_2& m, bool inside, std::size_t number_of_vertices)
{
  std::vector<char> marks(number_of_vertices, 0);
  for (std::size_t t = 0; t < m.number_of_triangles(); ++t) {
    tick(t);
    for (Index v : m.vertices[t])
      marks[v] |= (m.inside[t] != 0) == inside;
  }
  return marks;
}

/// Bubbles and the triangles between them, whose vertices are indices of bubbles.
struct Bubble_mesh_2
{
  Bubbles_2 bubbles;
  Marked_triangles_2 triangles;

  Point point(Index t, int i) const { return bubbles.point(static_cast<std::size_t>(triangles.vertices[t][i])); }
};

/// The corners of a triangle from the vertex with the smallest index on: what rounds must not depend on where a
/// triangle begins.
inline std::array<int, 3> corners_in_order(const Triangles_2& tr, Index t)
{
  const std::array<Index, 3>& v = tr.vertices[t];
  const int first = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin());
  return {first, ccw(first), cw(first)};
}

/// Whether q of a triangle is surely more than `least`, seen without square roots, as it is of most: with the sides a, b, c
/// and the area A, q = 16 A^2 / (a b c (a + b + c)) >= 48 A^2 / (a^2 + b^2 + c^2)^2.
inline bool has_surely_more(const Bubble_mesh_2& mesh, Index t, double least)
{
  constexpr double margin = 1e-9; // for rounding, also of flat triangles
  const Kernel::Vector_2 u = mesh.point(t, 1) - mesh.point(t, 0), v = mesh.point(t, 2) - mesh.point(t, 0);
  const double twice_area = u.x() * v.y() - u.y() * v.x(), squares = 2 * (u * u + v * v - u * v);
  const double ratio = twice_area / squares;
  return 12 * ratio * ratio > least + margin;
}

/// of the equilateral triangle with sides of length 1
inline constexpr double area_of_unit_triangle = 0.4330127018922193;

/// q of the isosceles triangle with an angle of twice `half` at its tip, 8 sin(a) sin^2(45 - a/2): no triangle with such an
/// angle, up to 60 degrees, has more, nor has one with a smaller one
inline double quality_of_isosceles(double half)
{
  const double s = sine_of(half);
  return 4 * s * (1 - s);
}

/// The sine of the smallest angle of a triangle, and the vertex where it is.
struct Smallest_angle_2
{
  double sine;
  int vertex;

  Smallest_angle_2(const Bubble_mesh_2& mesh, Index t)
  {
    std::array<double, 3> length; // of the sides opposite to the vertices
    for (int i = 0; i < 3; ++i)
      length[i] = std::sqrt(CGAL::squared_distance(mesh.point(t, ccw(i)), mesh.point(t, cw(i))));
    const auto& v = mesh.triangles.vertices[t]; // they decide among equals, not where the triangle begins
    const auto comes_before = [&](int i, int j) { return std::tie(length[i], v[i]) < std::tie(length[j], v[j]); };
    vertex = (std::min)({0, 1, 2}, comes_before);
    const Kernel::Vector_2 u = mesh.point(t, ccw(vertex)) - mesh.point(t, vertex),
                           w = mesh.point(t, cw(vertex)) - mesh.point(t, vertex);
    sine = (u.x() * w.y() - u.y() * w.x()) / (length[ccw(vertex)] * length[cw(vertex)]);
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/geometry/mark_triangulation_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_MARKED_TRIANGULATION_2_H
