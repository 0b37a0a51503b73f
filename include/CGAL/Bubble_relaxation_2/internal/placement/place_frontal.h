// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Crystal_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_limits_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The ways to fill the faces.
enum class Growth { FROM_ALL, SINGLE_STRAIGHT, SINGLE_BENT };

/// Initial bubbles of the faces by fronts that grow from all bubbles that are there: those of the edges
/// aligned with their edge, those of the faces, if there are any, in given directions.
/// `directions`: angles for the bubbles that are there; read for those in faces only
inline void grow_from_all(const Domain_2& domain, const Sizes_2& sizing, const std::vector<double>& directions,
                          Bubbles_2& bubbles, Team& team, const Threads& threads)
{
  Crystal_growth_2 grow(domain, sizing, bubbles, directions, Lattice_direction::BENDS, team, threads);
  for (std::size_t i = 0, n = bubbles.size(); i < n; ++i)
    grow.add_to_front(i);
  grow();
}

/// Whether bubbles belong to an edge, as its ends or between.
inline bool touches_edge(const Domain_2& domain, const Bubbles_2& b, std::size_t i, Index e)
{
  if (b.is_on_edge(i))
    return b.host[i] == e;
  const Domain_edge_2& edge = domain.edges()[e];
  return b.is_corner(i) && b.host[i] != no_index &&
         (b.host[i] == edge.source || b.host[i] == edge.target);
}

/// Initial bubbles of the faces as a single crystal as far as possible: it grows from the longest edge
/// and meets the others where they are; what it does not reach is filled from the others then.
inline void grow_single_crystal(const Domain_2& domain, const Sizes_2& sizing, Growth way, Bubbles_2& bubbles, Team& team,
                                const Threads& threads)
{
  const Lattice_direction lattice =
    way == Growth::SINGLE_STRAIGHT ? Lattice_direction::KEEPS : Lattice_direction::BENDS;
  const std::size_t n = bubbles.size();
  const Index longest = longest_edge(domain);
  Crystal_growth_2 grow(domain, sizing, bubbles, {}, lattice, team, threads);
  for (const bool is_first : {true, false}) {
    for (std::size_t i = 0; i < n; ++i)
      if (touches_edge(domain, bubbles, i, longest) == is_first)
        grow.add_to_front(i);
    grow();
  }
}

/// How far bubbles are from a crystal: the share of those in faces that have not six neighbours, times
/// the energy of the springs to them.
inline double disorder(const Domain_2& domain, const Bubbles_2& b)
{
  constexpr double reach = 1.35;
  Bubble_buckets_2 buckets(reach, b.d[0], domain.bbox().xmin(), domain.bbox().ymin(), b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
    buckets.insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
  double defects = 0, energy = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!b.is_in_face(i))
      continue;
    int number = 0;
    buckets.for_each_near(b.x[i], b.y[i], b.d[i], [&](Index j, double squared, double d) {
      if (j == static_cast<Index>(i))
        return true;
      ++number;
      const double w = 2 * std::sqrt(squared) / (b.d[i] + d);
      energy += (w - 1) * (w - 1);
      return true;
    });
    defects += number != 6;
  }
  return defects * energy;
}

/// The bubbles that have room when all are `factor` times as large, the first of several.
inline Bubbles_2 enlarge(const Domain_2& domain, const Bubbles_2& b, double factor)
{
  Bubble_buckets_2 buckets(Surroundings_2::least_distance, factor * b.d[0], domain.bbox().xmin(),
                           domain.bbox().ymin(), b.size());
  Bubbles_2 large;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const double d = factor * b.d[i];
    if (!buckets.is_free(b.x[i], b.y[i], d))
      continue;
    buckets.insert(static_cast<Index>(large.size()), b.x[i], b.y[i], d);
    large.add(b.point(i), d, static_cast<Bubbles_2::Dimension>(b.dimension[i]), b.host[i], b.s[i],
              b.pin[i]);
  }
  return large;
}

/// Fills the faces in the way that suits the domain and d, and returns which it is. Fronts from all edges
/// are right where d follows the boundary; where d is constant, or smallest inside, they may meet badly,
/// and a single crystal is tried as well.
inline Growth fill_in_better_way(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles,
                                 const Threads& threads)
{
  constexpr double nearly_constant = 1.25, clearly_less = 0.75, better = 0.8;
  Bubbles_2 single = bubbles;
  Team alone;
  grow_from_all(domain, sizing, {}, bubbles, alone, threads);
  const double least_at_start = *std::min_element(single.d.begin(), single.d.end());
  const auto sizes = std::minmax_element(bubbles.d.begin(), bubbles.d.end());
  const bool is_constant = *sizes.second < nearly_constant * *sizes.first;
  if (!is_constant && !(*sizes.first < clearly_less * least_at_start))
    return Growth::FROM_ALL;
  const Growth way = is_constant ? Growth::SINGLE_STRAIGHT : Growth::SINGLE_BENT;
  grow_single_crystal(domain, sizing, way, single, alone, threads);
  if (!(disorder(domain, single) < better * disorder(domain, bubbles)))
    return Growth::FROM_ALL;
  bubbles = std::move(single);
  return way;
}

/// How many times as large bubbles are that tell enough of a domain: 1 if there will be few anyway.
inline double factor_of_large_bubbles(double expected_number)
{
  constexpr double enough = 400;
  double factor = 1;
  while (expected_number >= 4 * factor * factor * enough)
    factor *= 2;
  return factor;
}

/// Initial bubbles of the faces. What suits a domain is found with large bubbles if there will be many.
/// `sizing`: has `expected_number`
inline void place_frontal(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles, Team& team,
                          const Threads& threads)
{
  const double factor = factor_of_large_bubbles(sizing.expected_number);
  if (factor == 1) {
    fill_in_better_way(domain, sizing, bubbles, threads);
    return;
  }
  Bubbles_2 large = enlarge(domain, bubbles, factor);
  const Growth way = fill_in_better_way(domain, scaled(sizing, factor), large, threads);
  team.divide(domain, large);
  if (way == Growth::FROM_ALL)
    grow_from_all(domain, sizing, {}, bubbles, team, threads);
  else
    grow_single_crystal(domain, sizing, way, bubbles, team, threads);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_FRONTAL_H
