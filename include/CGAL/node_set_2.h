// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NODE_SET_2_H
#define CGAL_NODE_SET_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/write_nodes.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

Nodes for meshless methods, with their neighbour sets. All arrays but `neighbors` have an element a node;
nodes that are near to each other have near indices.

\tparam Point_2_ point type
*/
template <class Point_2_>
struct Node_set_2
{
  using Point_2 = Point_2_;

  std::vector<Point_2> points;         ///< positions
  std::vector<double> sizes;           ///< the wanted distance d at each node
  std::vector<unsigned char> dimensions; ///< 0: vertex of the domain or pinned, 1: on an edge, 2: in a face

  /// the neighbours of node i are `neighbors[neighbor_offsets[i]]` up to, without,
  /// `neighbors[neighbor_offsets[i + 1]]`
  std::vector<std::size_t> neighbor_offsets;
  /// indices of the nodes nearer than `neighbor_radius` times the mean of both sizes, in increasing order
  std::vector<std::int32_t> neighbors;

  double neighbor_radius = 0;          ///< the radius of the sets in units of the mean of both sizes
  Bubble_relaxation_report_2<double> report; ///< what was done; it has no statistics of a mesh

  /// the number of nodes
  std::size_t size() const { return points.size(); }
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief returns the vertices of a mesh that lie in its domain as nodes for meshless methods, with their neighbour
sets. The size of a node is the mean length of the edges in the domain that end there, or less, down to half of it,
where that grows by more than 0.5 per unit of length, as `npbs_relax()` has it.

So nodes of any origin become a `Node_set_2`, and the nodes of a mesh that `npbs_relax()` made can be used beside
the mesh. The vertices may be inserted in any order.

\tparam CDT as in `npbs_relax()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the triangulation
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `seeds`, `seeds_are_in_domain`,
`vertex_is_constrained_map`, `neighbor_radius` and `concurrency_tag`, all as in `npbs_relax()`

\throws std::invalid_argument if there is no domain, if a coordinate is not finite, or if `neighbor_radius` is
not greater than 1.5

\sa `npbs_place_nodes()`
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto node_set_2(const CDT& mesh, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  const double neighbor_radius = read_options(np).neighbor_radius;
  const Threads threads = threads_of<Concurrency<NamedParameters>>();
  const Domain_marks_2<CDT> is_inside(mesh, np);
  const Domain_reading_2<CDT> reading(mesh, is_inside, is_pinned<CDT>(np), [](const auto&...) {});
  const Sizes_2 sizes = sizes_of_mesh(is_inside);
  Bubbles_2 bubbles;
  const auto add = [&](const std::vector<Point>& points, Bubbles_2::Dimension dimension) {
    for (const Point& p : points)
      bubbles.add(p, sizes(p), dimension, no_index);
  };
  add(reading.domain.corners(), Bubbles_2::CORNER);
  for (const std::vector<Point>& points : reading.given.on_edge)
    add(points, Bubbles_2::EDGE);
  add(reading.given.pinned, Bubbles_2::CORNER);
  add(reading.given.free, Bubbles_2::FACE);
  sort_in_space(reading.domain, bubbles, threads);
  Node_set_2<typename CDT::Geom_traits::Point_2> nodes;
  write_nodes<CDT>(bubbles, surface_elevations(mesh, bubbles), neighbor_radius, threads, nodes);
  nodes.report.number_of_vertices = nodes.size();
  return nodes;
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_NODE_SET_2_H
