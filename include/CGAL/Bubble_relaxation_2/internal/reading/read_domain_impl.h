// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

CGAL_BUBBLE_RELAXATION_2_INLINE
Sorted_vertices_2::Sorted_vertices_2(const Triangulation_copy_2& copy, Is_before is_before)
{
  const std::vector<Index> order = lexicographic_order(copy, is_before);
  number = inverse(order);
  points.reserve(order.size());
  addresses.reserve(order.size());
  for (Index v : order) {
    points.push_back(copy.tr.points[v]);
    addresses.push_back(copy.vertices.addresses()[v]);
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Read_domain_2::look_around(const Marked_copy_2& copy)
{
  const Flat_triangulation_2& tr = copy.tr;
  std::vector<Index> triangle(m_vertices.number.size(), no_index); // one around each vertex
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
    tick(t);
    for (Index v : tr.vertices[t])
      triangle[m_vertices.number[v]] = static_cast<Index>(t);
  }
  std::vector<Index> ring;
  std::vector<Point> points;
  for (Index v : free) {
    tick(given.around.size());
    find_ring(tr, triangle[v], v, ring);
    points.clear();
    for (Index u : ring)
      points.push_back(m_vertices.points[u]);
    given.around.push_back(mesh_star(m_vertices.points[v], points));
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Read_domain_2::Read_domain_2(const Marked_copy_2& copy, Is_before is_before)
  : m_vertices(copy, is_before), m_is_of_domain(copy.tr.points.size(), 0), m_is_pinned(m_is_of_domain),
    m_is_given(m_is_of_domain)
{
  for (std::size_t t = 0; t < copy.tr.number_of_triangles(); ++t) {
    tick(t);
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

CGAL_BUBBLE_RELAXATION_2_INLINE
void Read_domain_2::build()
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
  given.pinned = sort_along_curve(pinned);
  given.free = sort_along_curve(free);
  for (const Constraint_graph_2::Chain& c : graph->chains())
    given.on_edge.push_back(points(c.splits));
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Read_domain_2::~Read_domain_2() = default;

CGAL_BUBBLE_RELAXATION_2_INLINE
void Read_domain_2::add_edge(const Marked_copy_2& copy, Index t, int i)
{
  const Index u = m_vertices.number[copy.tr.vertices[t][ccw(i)]], v = m_vertices.number[copy.tr.vertices[t][cw(i)]],
              n = copy.tr.neighbors[t][i];
  const Edge_kind kind = copy.is_rim(t, i) ? Edge_kind::RIM : Edge_kind::TAKES_BUBBLES;
  if (u < v)
    m_edges.push_back(Constrained_edge_2{u, v, copy.is_inside(t), copy.is_inside(n), true, kind});
  else if (n == no_index) // else it is seen from the other side
    m_edges.push_back(Constrained_edge_2{v, u, false, copy.is_inside(t), true, kind});
  if (kind == Edge_kind::RIM)
    m_is_given[u] = m_is_given[v] = 1;
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Marking_error Read_domain_2::build(const std::vector<char>& is_fixed)
{
  graph = std::make_unique<Constraint_graph_2>(m_vertices.points, m_edges, is_fixed);
  std::vector<Domain_edge_2> edges;
  for (const Constraint_graph_2::Chain& c : graph->chains())
    edges.push_back(Domain_edge_2{c.source, c.target, c.inside_left, c.inside_right, c.kind});
  return domain.build(points(graph->corners()), std::move(edges));
}

CGAL_BUBBLE_RELAXATION_2_INLINE
std::vector<Point> Read_domain_2::points(const std::vector<Index>& vertices) const
{
  std::vector<Point> result;
  for (Index v : vertices)
    result.push_back(m_vertices.points[v]);
  return result;
}

CGAL_BUBBLE_RELAXATION_2_INLINE
std::vector<Point> Read_domain_2::sort_along_curve(std::vector<Index>& vertices) const
{
  std::vector<Index> order = hilbert_order(hilbert_curve(domain), points(vertices));
  for (Index& i : order)
    i = vertices[i];
  vertices.swap(order);
  return points(vertices);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void Read_domain_2::find_ring(const Flat_triangulation_2& tr, Index triangle, Index v, std::vector<Index>& ring) const
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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_IMPL_H
