// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Given_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hilbert_curve_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Constraint_graph_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the entry points read from a user's triangulation: the domain, and which vertex is what.
template <class Cdt>
struct Domain_reading_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Graph = Constraint_graph_2<Cdt>;

  Domain_2 domain;
  std::unique_ptr<Graph> graph;      ///< corners and chains, numbered as in `domain`

  /// vertices inside the domain that no constraint touches: the pinned ones and all others. Only their
  /// points decide their order, whatever the order in which they were inserted.
  std::vector<Vertex_handle> pinned, free;
  Given_mesh_2 given; ///< where vertices inside and on edges are

  /// `is_inside(face)`, `is_pinned(vertex)`: the domain and what the user pinned
  template <class Is_inside, class Is_pinned>
  Domain_reading_2(const Cdt& cdt, const Is_inside& is_inside, const Is_pinned& is_pinned)
  {
    check_coordinates(cdt);
    if (build(cdt, is_inside, is_pinned, true) != Marking_error::NONE) {
      // straightening a chain may touch what lies a rounding away from it: take all vertices as corners
      const Marking_error error = build(cdt, is_inside, is_pinned, false);
      if (error != Marking_error::NONE)
        throw std::invalid_argument(
          error == Marking_error::POINTS_COINCIDE
            ? "Bubble_relaxation_2: two vertices of the triangulation coincide when rounded to double"
            : "Bubble_relaxation_2: constraints of the triangulation cross when rounded to double");
    }
    for (Vertex_handle v : cdt.finite_vertex_handles())
      if (!graph->contains(v) && is_inside(v->face()) && !cdt.are_there_incident_constraints(v))
        (is_pinned(v) ? pinned : free).push_back(v);
    given.pinned = sort_by_place(pinned);
    given.free = sort_by_place(free);
    for (const typename Graph::Chain& c : graph->chains()) {
      given.on_edge.emplace_back();
      for (Vertex_handle v : c.splits)
        given.on_edge.back().push_back(Graph::to_point(v));
    }
  }

  /// finds out how the mesh looks around the free vertices from `first` to `last`, without
  void look_around(const Cdt& cdt, std::size_t first, std::size_t last)
  {
    given.around.resize(free.size());
    for (std::size_t k = first; k < last; ++k)
      given.around[k] = surroundings(cdt, free[k]);
  }

private:
  static Mesh_surroundings_2 surroundings(const Cdt& cdt, Vertex_handle v)
  {
    std::vector<Point> ring;
    auto u = first_neighbor(cdt, v), start = u;
    do {
      if (!cdt.is_infinite(u))
        ring.push_back(Graph::to_point(u));
    } while (++u != start);
    return mesh_surroundings(Graph::to_point(v), ring);
  }

  /// Starts at the neighbour with the lexicographically smallest point: where CGAL starts depends on the
  /// history of the triangulation, and a sum depends on the order of its terms.
  static typename Cdt::Vertex_circulator first_neighbor(const Cdt& cdt, Vertex_handle v)
  {
    auto u = cdt.incident_vertices(v), start = u, first = u;
    do {
      if (!cdt.is_infinite(u) && (cdt.is_infinite(first) || Graph::is_before(u, first)))
        first = u;
    } while (++u != start);
    return first;
  }

  /// sorts along a Hilbert curve, so that a search from one vertex to the next is short; returns the points
  std::vector<Point> sort_by_place(std::vector<Vertex_handle>& vertices) const
  {
    std::sort(vertices.begin(), vertices.end(), Graph::is_before); // some may be rounded to one place
    std::vector<Point> points;
    for (Vertex_handle v : vertices)
      points.push_back(Graph::to_point(v));
    std::vector<Vertex_handle> sorted;
    std::vector<Point> sorted_points;
    for (Index i : hilbert_order(hilbert_curve(domain), points)) {
      sorted.push_back(vertices[i]);
      sorted_points.push_back(points[i]);
    }
    vertices.swap(sorted);
    return sorted_points;
  }

  template <class Is_inside, class Is_pinned>
  Marking_error build(const Cdt& cdt, const Is_inside& is_inside, const Is_pinned& is_pinned,
                      bool merge)
  {
    graph = std::make_unique<Graph>(cdt, is_inside, is_pinned, merge);
    std::vector<Point> corners;
    for (Vertex_handle v : graph->corners())
      corners.push_back(Graph::to_point(v));
    std::vector<Domain_edge_2> edges;
    for (const typename Graph::Chain& c : graph->chains())
      edges.push_back(Domain_edge_2{c.source, c.target, c.inside_left, c.inside_right});
    return domain.build(std::move(corners), std::move(edges));
  }

  static void check_coordinates(const Cdt& cdt)
  {
    for (Vertex_handle v : cdt.finite_vertex_handles()) {
      const double x = CGAL::to_double(v->point().x()), y = CGAL::to_double(v->point().y());
      if (std::isfinite(x) && std::isfinite(y))
        continue;
      std::ostringstream message;
      message << "Bubble_relaxation_2: a vertex of the triangulation has the coordinates (" << x << ", " << y
              << "), which must be finite";
      throw std::invalid_argument(message.str());
    }
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_DOMAIN_H
