// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Mesh_surroundings_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_frontal.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_rhombic.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What an existing mesh has on the outline of the domain, and what is pinned inside.
struct Mesh_outline_2
{
  std::vector<Point> pinned;
  std::vector<std::vector<Point>> on_edge; ///< those that split an edge of the domain, from source to target
};

template <class Cdt>
Mesh_outline_2 outline_of_mesh(const Domain_reading_2<Cdt>& reading)
{
  using Graph = Constraint_graph_2<Cdt>;
  Mesh_outline_2 result;
  for (const auto v : reading.pinned)
    result.pinned.push_back(Graph::to_point(v));
  for (const auto& chain : reading.graph->chains()) {
    result.on_edge.emplace_back();
    for (const auto v : chain.splits)
      result.on_edge.back().push_back(Graph::to_point(v));
  }
  return result;
}

/// Bubbles on all vertices that stay: corners and pinned ones.
template <class Sizing>
void place_on_vertices(const Domain_2& domain, const std::vector<Point>& pinned, const Sizing& sizing,
                       Bubbles_2& bubbles)
{
  const std::vector<Point>& corners = domain.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    bubbles.add(corners[i], sizing(corners[i]), Bubbles_2::CORNER, static_cast<Index>(i));
  for (std::size_t i = 0; i < pinned.size(); ++i)
    bubbles.add(pinned[i], sizing(pinned[i]), Bubbles_2::CORNER, no_index, 0, static_cast<Index>(i));
}

/// where on an edge, between 0 and 1, a point of it lies
inline double position_on_edge(const Domain_2& domain, Index e, const Point& p)
{
  const Point &a = domain.source(e), &b = domain.target(e);
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  return ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / (dx * dx + dy * dy);
}

/// Bubbles where the vertices of an existing mesh split an edge.
template <class Sizing>
void place_on_splits(const Domain_2& domain, Index e, const std::vector<Point>& splits, const Sizing& sizing,
                     Bubbles_2& bubbles)
{
  for (const Point& p : splits)
    bubbles.add(p, sizing(p), Bubbles_2::EDGE, e, position_on_edge(domain, e, p));
}

/// Bubbles where the vertices of an existing mesh split an edge, unless d asks for another number.
template <class Sizing>
void keep_on_edge(const Domain_2& domain, Index e, const std::vector<Point>& splits, const Sizing& sizing,
                  Bubbles_2& bubbles)
{
  const double parts =
    (std::max)(1., std::round(integrate_edge(domain, e, sizing).total()));
  if (static_cast<double>(splits.size()) + 1 != parts)
    place_on_edge(domain, e, sizing, bubbles);
  else
    place_on_splits(domain, e, splits, sizing, bubbles);
}

/// What becomes of the vertices of an existing mesh on edges.
enum class On_edges { PLACE_ANEW, KEEP_THE_RIGHT_NUMBER, KEEP };

/// Bubbles on all vertices that stay and on all edges.
template <class Sizing>
Bubbles_2 place_on_outline(const Domain_2& domain, const Mesh_outline_2& mesh, On_edges way, const Sizing& sizing)
{
  Bubbles_2 bubbles;
  place_on_vertices(domain, mesh.pinned, sizing, bubbles);
  for (std::size_t k = 0; k < domain.edges().size(); ++k) {
    const Index e = static_cast<Index>(k);
    if (way == On_edges::PLACE_ANEW)
      place_on_edge(domain, e, sizing, bubbles);
    else if (way == On_edges::KEEP)
      place_on_splits(domain, e, mesh.on_edge[k], sizing, bubbles);
    else
      keep_on_edge(domain, e, mesh.on_edge[k], sizing, bubbles);
  }
  return bubbles;
}

/// Bubbles where the free vertices of an existing mesh are.
template <class Cdt, class Sizing>
void keep_in_faces(const Domain_reading_2<Cdt>& reading, const Sizing& sizing, Bubbles_2& bubbles)
{
  Index hint = 0;
  for (const auto v : reading.free) {
    const Point p = Constraint_graph_2<Cdt>::to_point(v);
    const Index triangle = reading.domain.place_inside(p, hint);
    if (triangle != no_index) // else rounded out of the domain
      bubbles.add(p, sizing(p), Bubbles_2::FACE, triangle);
  }
}

/// Bubbles where the free vertices of an existing mesh are, as far as it is about as fine there as d
/// asks; the rest of the domain is filled by a front.
template <class Concurrency_tag, class Cdt, class Sizing>
void adapt_in_faces(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                    Bubbles_2& bubbles)
{
  std::vector<double> directions(bubbles.size(), 0);
  Index hint = 0;
  for (const auto v : reading.free) {
    const Point p = Constraint_graph_2<Cdt>::to_point(v);
    const Index triangle = reading.domain.place_inside(p, hint);
    if (triangle == no_index)
      continue;
    const double d = sizing(p);
    const Mesh_surroundings_2 around = reading.surroundings(cdt, v);
    if (!around.fits(d))
      continue;
    bubbles.add(p, d, Bubbles_2::FACE, triangle);
    directions.push_back(around.direction);
  }
  Growth_alone alone;
  grow_from_all<Concurrency_tag>(reading.domain, sizing, directions, bubbles, alone);
}

/// whether the user gives all bubbles, as vertices of an existing mesh
inline bool keeps_given_bubbles(const Relaxation_options& options)
{
  return options.placement_is_given && options.placement == Bubble_placement::KEEP;
}

/// The bubbles that the user gives, all of them, whatever d asks for.
template <class Concurrency_tag, class Cdt, class Sizing>
Bubbles_2 given_bubbles(const Domain_reading_2<Cdt>& reading, const Sizing& sizing)
{
  Bubbles_2 bubbles = place_on_outline(reading.domain, outline_of_mesh(reading), On_edges::KEEP, sizing);
  keep_in_faces(reading, sizing, bubbles);
  remove_coincident(reading.domain, bubbles);
  sort_in_space<Concurrency_tag>(reading.domain, bubbles);
  return bubbles;
}

/// the initial bubbles (section 2.1.2 of the paper), sorted in space: on vertices, then edges, then faces, in this
/// order; if the user leaves the choice, an existing mesh is kept where it fits
template <class Concurrency_tag, class Cdt, class Sizing>
Bubbles_2 place_bubbles(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                        const Relaxation_options& options)
{
  const Domain_2& domain = reading.domain;
  const bool adapts = !options.placement_is_given && !reading.free.empty();
  const bool keeps = keeps_given_bubbles(options);
  Bubbles_2 bubbles = place_on_outline(domain, outline_of_mesh(reading),
                                       adapts || keeps ? On_edges::KEEP_THE_RIGHT_NUMBER : On_edges::PLACE_ANEW,
                                       sizing);
  if (adapts)
    adapt_in_faces<Concurrency_tag>(cdt, reading, sizing, bubbles);
  else if (keeps)
    keep_in_faces(reading, sizing, bubbles);
  else if (options.placement == Bubble_placement::RHOMBIC) {
    Placement_alone alone;
    Rhombic_placement<Sizing>(domain, sizing, bubbles, alone)();
  } else {
    Growth_alone alone;
    place_frontal<Concurrency_tag>(domain, sizing, bubbles, alone);
  }
  remove_coincident(domain, bubbles);
  sort_in_space<Concurrency_tag>(domain, bubbles);
  return bubbles;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_BUBBLES_H
