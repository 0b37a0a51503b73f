// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Given_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/constraint_hierarchy.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Constraint_graph_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// \throws std::invalid_argument if a point of the user's triangulation is not finite
inline void check_coordinates(const std::vector<Point>& points)
{
  for (const Point& p : points)
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
      throw std::invalid_argument("Bubble_relaxation_2: a vertex of the triangulation has the coordinates " +
                                  in_words(p.x(), p.y()) + ", which must be finite");
}

/// The vertices of a user's triangulation in the lexicographic order of their points. In what is read they have the
/// numbers of this order, since the order in which they were inserted must not matter.
struct Sorted_vertices_2
{
  std::vector<Point> points;
  std::vector<void*> addresses;
  std::vector<Index> number; ///< of each vertex of the copy

  /// \param is_before `nullptr` if coordinates are the user's to the last bit. Else some points may be rounded to one
  Sorted_vertices_2(const Triangulation_copy_2& copy, Is_before is_before)
  {
    check_coordinates(copy.tr.points);
    const std::vector<Index> order = lexicographic_order(copy, is_before);
    number = inverse(order);
    points.reserve(order.size());
    addresses.reserve(order.size());
    for (Index v : order) {
      points.push_back(copy.tr.points[v]);
      addresses.push_back(copy.vertices.addresses()[v]);
    }
  }
};

/// What the entry points read from a user's triangulation, in arrays: the domain, and which vertex is what.
class Read_domain_2
{
public:
  Domain_2 domain;
  std::unique_ptr<Constraint_graph_2> graph; ///< corners and chains, numbered as in `domain`

  /// vertices inside the domain that no constraint touches: the pinned ones and all others. Only their
  /// points decide their order, whatever the order in which they were inserted.
  std::vector<Index> pinned, free;
  Given_mesh_2 given; ///< where vertices inside and on edges are

  /// Finds out how the mesh looks around the free vertices.
  void look_around(const Marked_copy_2& copy)
  {
    const Flat_triangulation_2& tr = copy.tr;
    std::vector<Index> triangle(m_vertices.number.size(), no_index); // one around each vertex
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t)
      for (Index v : tr.vertices[t])
        triangle[m_vertices.number[v]] = static_cast<Index>(t);
    std::vector<Index> ring;
    std::vector<Point> points;
    for (Index v : free) {
      find_ring(tr, triangle[v], v, ring);
      points.clear();
      for (Index u : ring)
        points.push_back(m_vertices.points[u]);
      given.around.push_back(mesh_surroundings(m_vertices.points[v], points));
    }
  }

protected:
  Read_domain_2(const Marked_copy_2& copy, Is_before is_before)
    : m_vertices(copy, is_before), m_is_of_domain(copy.tr.points.size(), 0), m_is_pinned(m_is_of_domain),
      m_is_given(m_is_of_domain)
  {
    for (std::size_t t = 0; t < copy.tr.number_of_triangles(); ++t) {
      const Index f = static_cast<Index>(t);
      for (int i = 0; i < 3; ++i) {
        const Index v = m_vertices.number[copy.tr.vertices[t][i]];
        if (copy.is_inside(f))
          m_is_of_domain[v] = 1;
        if (copy.is_constrained(f, i))
          add_edge(copy, f, i);
      }
    }
  }

  /// once it is known which vertices are pinned or given, and which edges are of one constraint only
  void build()
  {
    std::vector<char> is_fixed(m_is_pinned);
    for (std::size_t v = 0; v < is_fixed.size(); ++v)
      is_fixed[v] |= m_is_given[v];
    if (build(is_fixed) != Marking_error::NONE) {
      // straightening a chain may touch what lies a rounding away from it: take all vertices as corners
      const Marking_error error = build(std::vector<char>(is_fixed.size(), 1));
      if (error != Marking_error::NONE)
        throw std::invalid_argument(
          error == Marking_error::POINTS_COINCIDE
            ? "Bubble_relaxation_2: two vertices of the triangulation coincide when rounded to double"
            : "Bubble_relaxation_2: constraints of the triangulation cross when rounded to double");
    }
    for (std::size_t v = 0; v < is_fixed.size(); ++v)
      if (m_is_of_domain[v] && !graph->contains(static_cast<Index>(v)))
        (m_is_pinned[v] ? pinned : free).push_back(static_cast<Index>(v));
    given.pinned = sort_by_place(pinned);
    given.free = sort_by_place(free);
    for (const Constraint_graph_2::Chain& c : graph->chains())
      given.on_edge.push_back(points(c.splits));
  }

  Sorted_vertices_2 m_vertices;
  std::vector<char> m_is_of_domain, m_is_pinned, m_is_given; // vertices; given as points of a constraint
  std::vector<Constrained_edge_2> m_edges;

private:
  void add_edge(const Marked_copy_2& copy, Index t, int i)
  {
    const Index u = m_vertices.number[copy.tr.vertices[t][ccw(i)]], v = m_vertices.number[copy.tr.vertices[t][cw(i)]],
                n = copy.tr.neighbors[t][i];
    if (u < v)
      m_edges.push_back(Constrained_edge_2{u, v, copy.is_inside(t), copy.is_inside(n), true});
    else if (n == no_index) // else it is seen from the other side
      m_edges.push_back(Constrained_edge_2{v, u, false, copy.is_inside(t), true});
  }

  Marking_error build(const std::vector<char>& is_fixed)
  {
    graph = std::make_unique<Constraint_graph_2>(m_vertices.points, m_edges, is_fixed);
    std::vector<Domain_edge_2> edges;
    for (const Constraint_graph_2::Chain& c : graph->chains())
      edges.push_back(Domain_edge_2{c.source, c.target, c.inside_left, c.inside_right});
    return domain.build(points(graph->corners()), std::move(edges));
  }

  std::vector<Point> points(const std::vector<Index>& vertices) const
  {
    std::vector<Point> result;
    for (Index v : vertices)
      result.push_back(m_vertices.points[v]);
    return result;
  }

  /// sorts along a Hilbert curve, so that a search from one vertex to the next is short; returns the points
  std::vector<Point> sort_by_place(std::vector<Index>& vertices) const
  {
    std::vector<Index> order = hilbert_order(hilbert_curve(domain), points(vertices));
    for (Index& i : order)
      i = vertices[i];
    vertices.swap(order);
    return points(vertices);
  }

  /// The neighbours of `v`, counterclockwise from the first one on: a sum depends on the order of its terms.
  void find_ring(const Flat_triangulation_2& tr, Index triangle, Index v, std::vector<Index>& ring) const
  {
    ring.clear();
    Index t = triangle;
    do {
      const auto& u = tr.vertices[t];
      const int i = m_vertices.number[u[0]] == v ? 0 : m_vertices.number[u[1]] == v ? 1 : 2;
      ring.push_back(m_vertices.number[u[ccw(i)]]);
      t = tr.neighbors[t][ccw(i)];
    } while (t != triangle);
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  }
};

/// What is read from a triangulation of a certain type. It knows the handles of vertices.
template <class Cdt>
class Domain_reading_2 : public Read_domain_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// `is_pinned(vertex)`: what the user pinned
  template <class Is_pinned>
  Domain_reading_2(const Cdt& cdt, const Domain_marks_2<Cdt>& marks, const Is_pinned& is_pinned)
    : Read_domain_2(marks, is_before())
  {
    for (std::size_t v = 0; v < m_is_pinned.size(); ++v)
      if (m_is_of_domain[v])
        m_is_pinned[v] = is_pinned(vertex(static_cast<Index>(v)));
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      read_hierarchy(cdt, marks);
    build();
  }

  Vertex_handle vertex(Index v) const { return Handles<Cdt>::vertex(m_vertices.addresses[v]); }

private:
  static constexpr Is_before is_before()
  {
    if constexpr (std::is_same<typename Cdt::Geom_traits::FT, double>::value)
      return nullptr;
    else
      return [](const void* u, const void* v) {
        using Vertex = typename Cdt::Vertex;
        return CGAL::lexicographically_xy_smaller(static_cast<const Vertex*>(u)->point(),
                                                  static_cast<const Vertex*>(v)->point()) == true;
      };
  }

  /// Only vertices that were not given as points of a constraint, on pieces that belong to one constraint only, may
  /// merely split it. Without a hierarchy nothing is known of that.
  void read_hierarchy(const Cdt& cdt, const Domain_marks_2<Cdt>& marks)
  {
    for (auto c = cdt.constraints_begin(); c != cdt.constraints_end(); ++c) {
      const auto first = cdt.vertices_in_constraint_begin(*c), end = cdt.vertices_in_constraint_end(*c);
      Index last = no_index;
      for (auto v = first; v != end; ++v) {
        last = m_vertices.number[marks.vertices(&**v)];
        if (v == first || v.input())
          m_is_given[last] = 1;
      }
      m_is_given[last] = 1;
    }
    for (Constrained_edge_2& e : m_edges)
      if (e.is_in_domain())
        e.is_of_one_constraint = cdt.number_of_enclosing_constraints(vertex(e.source), vertex(e.target)) == 1;
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
