// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Crystal_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Initial bubbles of the faces by fronts that grow from all bubbles that are there: those of the edges
/// aligned with their edge, those of the faces, if there are any, in given directions.
/// `directions`: angles for the bubbles that are there; read for those in faces only
template <class Concurrency_tag, class Sizing>
void grow_from_all(const Domain_2& domain, const Sizing& sizing,
                   const std::vector<double>& directions, Bubbles_2& bubbles)
{
  Crystal_growth_2<Concurrency_tag, Sizing> grow(domain, sizing, bubbles, Lattice_direction::BENDS);
  for (std::size_t i = 0; i < directions.size(); ++i)
    grow.set_direction(i, Direction{std::cos(directions[i]), std::sin(directions[i])});
  for (std::size_t i = 0, n = bubbles.size(); i < n; ++i)
    grow.add_to_front(i);
  grow();
}

/// Whether bubbles belong to an edge, as its ends or between.
inline bool touches_edge(const Domain_2& domain, const Bubbles_2& b, std::size_t i, Index e)
{
  if (b.is_on_edge(i))
    return b.place[i] == e;
  const Domain_edge_2& edge = domain.edges()[e];
  return b.is_corner(i) && b.place[i] != no_index &&
         (b.place[i] == edge.source || b.place[i] == edge.target);
}

/// The longest of the domain's edges; of several that only rounding tells apart, the first.
inline Index longest_edge(const Domain_2& domain)
{
  constexpr double rounding = 1e-9;
  Index longest = 0;
  for (std::size_t e = 1; e < domain.edges().size(); ++e)
    if (domain.length(static_cast<Index>(e)) > (1 + rounding) * domain.length(longest))
      longest = static_cast<Index>(e);
  return longest;
}

/// Initial bubbles of the faces as a single crystal as far as possible: it grows from the longest edge
/// and meets the others where they are; what it does not reach is filled from the others then.
template <class Concurrency_tag, class Sizing>
void grow_single_crystal(const Domain_2& domain, const Sizing& sizing, Lattice_direction lattice,
                         Bubbles_2& bubbles)
{
  const std::size_t n = bubbles.size();
  const Index longest = longest_edge(domain);
  Crystal_growth_2<Concurrency_tag, Sizing> grow(domain, sizing, bubbles, lattice);
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

/// Initial bubbles of the faces. Fronts from all edges are right where d follows the boundary; where d is
/// constant, or smallest inside, they may meet badly, and a single crystal is tried as well.
template <class Concurrency_tag, class Sizing>
void place_frontal(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles)
{
  constexpr double nearly_constant = 1.25, clearly_less = 0.75, better = 0.92;
  const Bubbles_2 start = bubbles;
  grow_from_all<Concurrency_tag>(domain, sizing, {}, bubbles);
  const auto at_start = std::minmax_element(start.d.begin(), start.d.end());
  const auto sizes = std::minmax_element(bubbles.d.begin(), bubbles.d.end());
  const bool is_constant = *sizes.second < nearly_constant * *sizes.first;
  if (!is_constant && !(*sizes.first < clearly_less * *at_start.first))
    return;
  Bubbles_2 single = start;
  grow_single_crystal<Concurrency_tag>(
    domain, sizing, is_constant ? Lattice_direction::KEEPS : Lattice_direction::BENDS, single);
  if (disorder(domain, single) < better * disorder(domain, bubbles))
    bubbles = single;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H
