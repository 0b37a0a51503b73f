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
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/place_on_edges.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/remove_coincident.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hole_choice_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_frontal.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_rhombic.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What becomes of the vertices of an existing mesh on edges.
enum class On_edges { PLACE_ANEW, KEEP_THE_RIGHT_NUMBER, KEEP };

/// Bubbles on all vertices that stay and on all edges.
inline Bubbles_2 place_on_outline(const Domain_2& domain, const Given_mesh_2& mesh, On_edges way, const Sizes_2& sizing)
{
  Bubbles_2 bubbles;
  const std::vector<Point>& corners = domain.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    bubbles.add(corners[i], sizing(corners[i]), Bubbles_2::CORNER, static_cast<Index>(i));
  for (std::size_t i = 0; i < mesh.pinned.size(); ++i)
    bubbles.add(mesh.pinned[i], sizing(mesh.pinned[i]), Bubbles_2::CORNER, no_index, 0, static_cast<Index>(i));
  for (std::size_t k = 0; k < domain.edges().size(); ++k) {
    const Index e = static_cast<Index>(k);
    const std::vector<Point>& splits = mesh.on_edge[k];
    const auto is_right_number = [&] { // the integral over an edge that takes none may be without end: nobody counts it
      return domain.edges()[k].takes_bubbles() &&
             static_cast<double>(splits.size()) + 1 == integrate_edge(domain, e, sizing).parts();
    };
    if (way == On_edges::KEEP || (way == On_edges::KEEP_THE_RIGHT_NUMBER && is_right_number()))
      for (const Point& p : splits)
        bubbles.add(p, sizing(p), Bubbles_2::EDGE, e, position_on_edge(domain, e, p));
    else
      place_on_edge(domain, e, sizing, bubbles);
  }
  return bubbles;
}

/// Bubbles where the free vertices of an existing mesh are. `is_kept(k, d)`: whether the `k`-th one is good for a size
template <class Is_kept>
void keep_in_faces(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& sizing, const Is_kept& is_kept,
                   Bubbles_2& bubbles)
{
  Index hint = 0;
  for (std::size_t k = 0; k < given.free.size(); ++k) {
    tick(k);
    const Point& p = given.free[k];
    const Index triangle = domain.host_of(p, hint);
    if (triangle == no_index) // rounded out of the domain
      continue;
    const double d = sizing(p);
    if (is_kept(k, d))
      bubbles.add(p, d, Bubbles_2::FACE, triangle);
  }
}

inline void keep_in_faces(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& sizing, Bubbles_2& bubbles)
{
  keep_in_faces(domain, given, sizing, [](std::size_t, double) { return true; }, bubbles);
}

/// Shares the domain out among ranks by large bubbles that fill it, the same on all: where they are many, bubbles will
/// be many.
inline void share_out(const Domain_2& domain, const Sizes_2& sizing, const Bubbles_2& on_outline, Team& team,
                      const Threads& threads)
{
  if (team.is_alone())
    return;
  const double factor = factor_of_large_bubbles(sizing.expected_number);
  Bubbles_2 large = enlarge(domain, on_outline, factor);
  Team alone;
  grow_from_all(domain, scaled(sizing, factor), {}, large, alone, threads);
  team.divide(domain, large);
}

/// Bubbles where the free vertices of an existing mesh are, as far as it is about as fine there as d
/// asks; the rest of the domain is filled by a front.
inline void adapt_in_faces(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& sizing, Bubbles_2& bubbles,
                           Team& team, const Threads& threads)
{
  constexpr double largest_misfit = 1.1; // bubbles that are a little too dense stay so
  const Bubbles_2 outline = bubbles;
  share_out(domain, sizing, bubbles, team, threads);
  std::vector<double> directions(bubbles.size(), 0);
  const auto is_kept = [&](std::size_t k, double d) {
    const double spacing = given.around[k].spacing;
    const bool is_fitting = !(spacing > largest_misfit * d || d > largest_misfit * spacing);
    if (is_fitting)
      directions.push_back(given.around[k].direction);
    return is_fitting;
  };
  keep_in_faces(domain, given, sizing, is_kept, bubbles);
  team.share_seeds(bubbles, directions);
  grow_from_all(domain, sizing, directions, bubbles, team, threads);
  if (is_sparse(sizing, bubbles, team)) {
    bubbles = outline;
    team.note_common(bubbles);
    place_frontal(domain, sizing, bubbles, team, threads);
  }
}

/// whether the user gives all bubbles, as vertices of an existing mesh
inline bool keeps_given_bubbles(const Relaxation_options& options)
{
  return options.placement_is_given && options.placement == Bubble_placement::KEEP;
}

/// Bubbles where the free vertices of an existing mesh are, but none much nearer to another one, or to the outline, than
/// d: they would push each other in all steps, and population control would need many rounds to get rid of them.
inline void keep_apart_in_faces(const Problem_2& p, Bubbles_2& bubbles, Team& team)
{
  constexpr double apart = 0.75; // in units of the mean d; in a packing for this d hardly any two are nearer
  share_out(p.domain, p.sizes, bubbles, team, p.options.threads);
  Bubbles_2 all;
  keep_in_faces(p.domain, p.given, p.sizes, all);
  std::vector<Hole_2> places;
  std::size_t number = team.number_before(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    tick(i);
    ++number; // along the curve; first come multiples of large powers of two, so that what is left is even
    const double power = static_cast<double>(number & (~number + 1));
    places.push_back(Hole_2{-power, all.x[i], all.y[i], all.d[i], all.host[i]});
  }
  fill_holes_beside(places, apart, team, p.options.threads, bubbles);
}

/// The bubbles that the user gives, whatever d asks for.
inline Bubbles_2 given_bubbles(const Problem_2& p, Team& team)
{
  Bubbles_2 bubbles = place_on_outline(p.domain, p.given, On_edges::KEEP, p.sizes);
  team.note_common(bubbles);
  keep_in_faces(p.domain, p.given, p.sizes, bubbles);
  return bubbles;
}

/// the initial bubbles (section 2.1.2 of the paper); if the user leaves the choice, an existing mesh is kept where it
/// fits
inline Bubbles_2 place_bubbles(const Problem_2& p, Team& team)
{
  const Threads& threads = p.options.threads;
  const bool adapts = !p.options.placement_is_given && team.any(!p.given.free.empty());
  const bool keeps = keeps_given_bubbles(p.options);
  Bubbles_2 bubbles = place_on_outline(
    p.domain, p.given, adapts || keeps ? On_edges::KEEP_THE_RIGHT_NUMBER : On_edges::PLACE_ANEW, p.sizes);
  team.note_common(bubbles);
  if (adapts)
    adapt_in_faces(p.domain, p.given, p.sizes, bubbles, team, threads);
  else if (keeps && p.options.population != Bubble_population::NONE && p.options.number_of_rounds != 0)
    keep_apart_in_faces(p, bubbles, team);
  else if (keeps) // without population control none goes, and without rounds they only lie there
    keep_in_faces(p.domain, p.given, p.sizes, bubbles);
  else if (p.options.placement == Bubble_placement::RHOMBIC) {
    share_out(p.domain, p.sizes, bubbles, team, threads);
    Rhombic_placement(p.domain, p.sizes, bubbles, team)();
  } else
    place_frontal(p.domain, p.sizes, bubbles, team, threads);
  return bubbles;
}

/// the same bubbles, or given ones, without coincident ones and sorted in space: on vertices, then edges, then faces,
/// in this order
inline Bubbles_2 sorted_in_space(const Problem_2& p, Bubbles_2 bubbles)
{
  remove_coincident(p.domain, bubbles);
  sort_in_space(p.domain, bubbles, p.options.threads);
  return bubbles;
}

inline Bubbles_2 given_bubbles(const Problem_2& p)
{
  Team alone;
  return sorted_in_space(p, given_bubbles(p, alone));
}

inline Bubbles_2 place_bubbles(const Problem_2& p)
{
  Team alone;
  return sorted_in_space(p, place_bubbles(p, alone));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_BUBBLES_H
