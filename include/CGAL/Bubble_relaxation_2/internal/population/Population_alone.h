// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_POPULATION_ALONE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_POPULATION_ALONE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a place where a bubble is missing
struct Hole_2
{
  double rank; ///< the one with the least is filled first
  double x, y, d;
  Index triangle; ///< of the domain
};

/// a bubble on a corner or on an edge of the domain
struct Outline_bubble_2
{
  double x, y, d, s;
  Index index; ///< `no_index` if this rank does not know it
};

/// all bubbles on the outline of the domain
struct Outline_bubbles_2
{
  std::vector<std::vector<Outline_bubble_2>> on_edge; ///< from source to target
  std::vector<Outline_bubble_2> on_corner;
};

/// No other ranks: what a team does at each place of the control of the population.
struct Population_alone
{
  using Triangle = std::array<Index, 3>;

  /// adds bubbles of others that may have moved
  const std::vector<Index>& share_touched(const Bubbles_2&, const std::vector<Index>& touched) { return touched; }

  /// adds triangles that others found around bubbles of ours; what we do not know of their corners is `no_index`
  void share_triangles(const Bubbles_2&, std::vector<Triangle>&) {}

  /// Puts in the values of bubbles that others own; returns whether any rank got one that it did not have.
  template <class T>
  bool share(std::vector<T>&)
  {
    return false;
  }

  /// Keeps the holes at places of ours, adds those that others found there, and after these those of others that
  /// are nearer than `reach` times the mean size; returns how many are ours.
  std::size_t share_holes(std::vector<Hole_2>& holes, double) { return holes.size(); }

  /// chooses among holes
  template <class Choice>
  void decide(Choice& choice)
  {
    choice.decide([](Index) { return true; });
  }

  /// whether a bubble that comes in there belongs to this rank
  bool owns_place(const Point&) const { return true; }

  Outline_bubbles_2 outline(const Domain_2& domain, const Bubbles_2& b) const
  {
    const auto outline_bubble = [&b](Index i) {
      return i == no_index ? Outline_bubble_2{0, 0, 1, 0, i} : Outline_bubble_2{b.x[i], b.y[i], b.d[i], b.s[i], i};
    };
    Outline_bubbles_2 result;
    for (const std::vector<Index>& bubbles : bubbles_on_edges(domain, b)) {
      result.on_edge.emplace_back();
      for (Index i : bubbles)
        result.on_edge.back().push_back(outline_bubble(i));
    }
    for (Index i : bubbles_on_corners(domain, b))
      result.on_corner.push_back(outline_bubble(i));
    return result;
  }

  /// gives new bubbles their numbers
  void number(Bubbles_2&) {}
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_POPULATION_ALONE_H
