// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>

#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Bubbles that a population control wants to delete and to insert.
struct Population_change
{
  std::vector<char> is_deleted;
  Bubbles_2 inserted;

  std::size_t number_of_insertions() const { return inserted.size(); }

  std::size_t number_of_deletions() const
  {
    return std::accumulate(is_deleted.begin(), is_deleted.end(), std::size_t(0));
  }

  bool is_empty() const { return number_of_insertions() == 0 && number_of_deletions() == 0; }
};

/// Numbers the bubbles along the Hilbert curve: neighbours in space get near in memory, and a bubble's
/// index does not tell when it was inserted.
inline void sort_in_space(Bubbles_2& bubbles)
{
  std::vector<Point> points;
  points.reserve(bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    points.push_back(bubbles.point(i));
  std::vector<std::size_t> order(bubbles.size());
  std::iota(order.begin(), order.end(), 0);
  using Map = Pointer_property_map<Point>::type;
  hilbert_sort(order.begin(), order.end(),
               Spatial_sort_traits_adapter_2<Kernel, Map>(make_property_map(points)));
  bubbles.select(std::vector<Index>(order.begin(), order.end()));
}

/// Carries out a change of the population.
inline void apply(const Population_change& change, Bubbles_2& bubbles)
{
  if (change.is_empty())
    return;
  std::vector<Index> kept;
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    if (!change.is_deleted[i])
      kept.push_back(static_cast<Index>(i));
  bubbles.select(kept);
  const Bubbles_2& in = change.inserted;
  for (std::size_t i = 0; i < in.size(); ++i)
    bubbles.add(in.point(i), in.d[i], static_cast<Bubbles_2::Dimension>(in.dimension[i]),
                in.place[i], in.s[i]);
  sort_in_space(bubbles);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H
