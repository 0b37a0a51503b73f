// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Population_change.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/place_frontal.h>
#include <CGAL/Bubble_relaxation_2/internal/place_on_edges.h>
#include <CGAL/Bubble_relaxation_2/internal/place_rhombic.h>
#include <CGAL/Bubble_relaxation_2/internal/sort_in_space.h>
#include <CGAL/Bubble_relaxation_enums.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Bubbles on all vertices that stay: corners and pinned ones.
template <class Cdt, class Sizing>
void place_on_vertices(const Domain_reading_2<Cdt>& reading, const Sizing& sizing, Bubbles_2& bubbles)
{
  const std::vector<Point>& corners = reading.domain.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    bubbles.add(corners[i], sizing(corners[i]), Bubbles_2::CORNER, static_cast<Index>(i));
  for (std::size_t i = 0; i < reading.pinned.size(); ++i) {
    const Point p = Constraint_graph_2<Cdt>::to_point(reading.pinned[i]);
    bubbles.add(p, sizing(p), Bubbles_2::CORNER, no_index, 0, static_cast<Index>(i));
  }
}

/// Bubbles where the vertices of an existing mesh split an edge.
template <class Cdt, class Sizing>
void place_on_splits(const Domain_reading_2<Cdt>& reading, Index e, const Sizing& sizing,
                     Bubbles_2& bubbles)
{
  const Domain_2& domain = reading.domain;
  const Point &a = domain.source(e), &b = domain.target(e);
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  for (const auto v : reading.graph->chains()[e].splits) {
    const Point p = Constraint_graph_2<Cdt>::to_point(v);
    const double s = ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / (dx * dx + dy * dy);
    bubbles.add(p, sizing(p), Bubbles_2::EDGE, e, s);
  }
}

/// Bubbles where the vertices of an existing mesh split an edge, unless d asks for another number.
template <class Cdt, class Sizing>
void keep_on_edge(const Domain_reading_2<Cdt>& reading, Index e, const Sizing& sizing,
                  Bubbles_2& bubbles)
{
  const Domain_2& domain = reading.domain;
  const double parts =
    (std::max)(1., std::round(integrate_edge(domain, e, sizing).total()));
  if (static_cast<double>(reading.graph->chains()[e].splits.size()) + 1 != parts)
    place_on_edge(domain, e, sizing, bubbles);
  else
    place_on_splits(reading, e, sizing, bubbles);
}

/// Bubbles where the free vertices of an existing mesh are.
template <class Cdt, class Sizing>
void keep_in_faces(const Domain_reading_2<Cdt>& reading, const Sizing& sizing, Bubbles_2& bubbles)
{
  Index hint = 0;
  for (const auto v : reading.free) {
    const Point p = Constraint_graph_2<Cdt>::to_point(v);
    const Index triangle = reading.domain.locate_inside(p, hint);
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
  constexpr double largest_misfit = 1.25;
  std::vector<double> directions(bubbles.size(), 0);
  Index hint = 0;
  for (const auto v : reading.free) {
    const Point p = Constraint_graph_2<Cdt>::to_point(v);
    const Index triangle = reading.domain.locate_inside(p, hint);
    if (triangle == no_index)
      continue;
    const double d = sizing(p);
    const auto around = reading.surroundings(cdt, v);
    if (around.spacing > largest_misfit * d || d > largest_misfit * around.spacing)
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
  Bubbles_2 bubbles;
  place_on_vertices(reading, sizing, bubbles);
  for (std::size_t e = 0; e < reading.domain.edges().size(); ++e)
    place_on_splits(reading, static_cast<Index>(e), sizing, bubbles);
  keep_in_faces(reading, sizing, bubbles);
  remove_coincident<Concurrency_tag>(reading.domain, bubbles);
  sort_in_space<Concurrency_tag>(reading.domain, bubbles);
  return bubbles;
}

/// The initial bubbles (section 2.1.2 of the paper): on vertices, then edges, then faces, in this order. If the
/// user leaves the choice, an existing mesh is kept where it fits. `team`: who grows a crystal together.
template <class Concurrency_tag, class Cdt, class Sizing, class Team>
Bubbles_2 place_on_all(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                       const Relaxation_options& options, Team& team)
{
  const Domain_2& domain = reading.domain;
  const bool adapts = !options.placement_is_given && !reading.free.empty();
  const bool keeps = keeps_given_bubbles(options);
  Bubbles_2 bubbles;
  place_on_vertices(reading, sizing, bubbles);
  for (std::size_t e = 0; e < domain.edges().size(); ++e) {
    if (adapts || keeps)
      keep_on_edge(reading, static_cast<Index>(e), sizing, bubbles);
    else
      place_on_edge(domain, static_cast<Index>(e), sizing, bubbles);
  }
  if (adapts)
    adapt_in_faces<Concurrency_tag>(cdt, reading, sizing, bubbles);
  else if (keeps)
    keep_in_faces(reading, sizing, bubbles);
  else if (options.placement == Bubble_placement::RHOMBIC)
    Rhombic_placement<Sizing>(domain, sizing, bubbles)();
  else
    place_frontal<Concurrency_tag>(domain, sizing, bubbles, team);
  return bubbles;
}

/// the initial bubbles, sorted in space
template <class Concurrency_tag, class Cdt, class Sizing>
Bubbles_2 place_bubbles(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                        const Relaxation_options& options)
{
  Growth_alone alone;
  Bubbles_2 bubbles = place_on_all<Concurrency_tag>(cdt, reading, sizing, options, alone);
  remove_coincident<Concurrency_tag>(reading.domain, bubbles);
  sort_in_space<Concurrency_tag>(reading.domain, bubbles);
  return bubbles;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_BUBBLES_H
