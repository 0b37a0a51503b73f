// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Delaunay_star_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The Delaunay triangles with at least one of some bubbles, found from their neighbour sets: each bubble
/// wraps its own star, and of the stars of a triangle's corners that of the first one counts. Beside holes that
/// no neighbour set reaches across, the buckets are asked. A triangle is one of the triangulation of all
/// bubbles, unless its circle is so large that there is a hole anyway.
class Local_triangulation_2
{
public:
  using Triangle = std::array<Index, 3>; ///< bubbles, counterclockwise

  template <class Concurrency_tag>
  static Local_triangulation_2 make(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                                    const std::vector<Index>& touched)
  {
    Local_triangulation_2 result(touched);
    result.template wrap<Concurrency_tag>(bubbles, neighbors);
    return result;
  }

  /// Beside holes wider than this, in sizes, all bubbles are looked at that are nearer than the radius of neighbour
  /// sets times the mean of this times the size and their size: up to about five sizes away.
  static constexpr double widest_hole = 2.4, far = 5;

  /// whether a bubble lies beside such a hole
  static bool is_beside_wide_hole(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, Index i)
  {
    if (!bubbles.is_in_face(i) || is_surrounded(bubbles, neighbors, i))
      return false;
    Delaunay_star_2 star(bubbles, i);
    Delaunay_star_2::Indices candidates;
    return !wrap_nearby(bubbles, neighbors, i, star, candidates);
  }

  const std::vector<Index>& touched() const { return m_touched; }

  /// those with a touched bubble
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  explicit Local_triangulation_2(const std::vector<Index>& touched) : m_touched(touched) {}

  /// The forces end at 1.5 d, and pairs farther apart than that may be missing in the sets: circles up to this
  /// diameter are known to be empty. For others the neighbours' neighbours are looked at as well, which reach around
  /// a hole of up to `widest_hole`.
  static constexpr double certain_diameter = 1.5;

  static constexpr std::size_t block_size = 512;

  template <class Concurrency_tag>
  void wrap(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors)
  {
    std::vector<char> is_touched(bubbles.size(), 0);
    for (Index i : m_touched)
      is_touched[i] = 1;
    std::vector<std::vector<Triangle>> blocks((m_touched.size() + block_size - 1) / block_size);
    parallel_for<Concurrency_tag>(
      blocks.size(),
      [&](std::size_t b) {
        const std::size_t last = (std::min)((b + 1) * block_size, m_touched.size());
        for (std::size_t k = b * block_size; k < last; ++k)
          if (bubbles.is_ours(m_touched[k]))
            add_star(bubbles, neighbors, is_touched, m_touched[k], blocks[b]);
      },
      1);
    for (const std::vector<Triangle>& block : blocks)
      m_triangles.insert(m_triangles.end(), block.begin(), block.end());
  }

  static void add_star(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                       const std::vector<char>& is_touched, Index i, std::vector<Triangle>& triangles)
  {
    Delaunay_star_2::Indices candidates;
    Delaunay_star_2 star(bubbles, i);
    if (!wrap_nearby(bubbles, neighbors, i, star, candidates)) {
      candidates.clear();
      neighbors.find_around(i, far, [&](Index j) { candidates.push_back(j); });
      sort(bubbles, candidates);
      star.wrap(candidates);
    }
    const auto& ring = star.ring();
    for (std::size_t k = star.is_closed() ? 0 : 1; k < ring.size(); ++k) {
      const Index u = ring[k == 0 ? ring.size() - 1 : k - 1], v = ring[k];
      if ((!is_touched[u] || bubbles.is_before(i, u)) && (!is_touched[v] || bubbles.is_before(i, v)))
        triangles.push_back({i, u, v});
    }
  }

  /// wraps a star as far as neighbour sets tell; returns whether that is enough
  static bool wrap_nearby(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, Index i, Delaunay_star_2& star,
                          Delaunay_star_2::Indices& candidates)
  {
    const auto is_within = [&](double diameter) {
      return !bubbles.is_in_face(i) ||
             (star.is_closed() && star.largest_circle() <= 0.25 * diameter * diameter);
    };
    candidates.assign(neighbors.begin(i), neighbors.end(i));
    star.wrap(candidates);
    if (!is_within(certain_diameter)) {
      add_neighbors_of_neighbors(bubbles, neighbors, i, candidates);
      star.wrap(candidates);
    }
    return is_within(widest_hole);
  }

  /// Whether it is clear without a star that no circle is wider than `widest_hole`. One through the bubble with diameter
  /// w contains all that is nearer than w cos(a) in directions up to an angle a from its centre. If of 16 sectors no
  /// four in a row are empty of neighbours, one is in a direction up to 56.25 degrees from each other one.
  static bool is_surrounded(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, Index i)
  {
    constexpr double cosine = 0.555, tangent_of_sector = 0.41421356;
    const double far_enough = widest_hole * cosine * bubbles.d[i];
    unsigned sectors = 0;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j) {
      const double dx = bubbles.x[*j] - bubbles.x[i], dy = bubbles.y[*j] - bubbles.y[i];
      if (dx * dx + dy * dy > far_enough * far_enough)
        continue;
      // turned back into the first quarter, then below its diagonal
      const unsigned quarter = dy >= 0 ? (dx > 0 ? 0 : 1) : (dx < 0 ? 2 : 3);
      const double x = quarter % 2 == 0 ? std::abs(dx) : std::abs(dy);
      const double y = quarter % 2 == 0 ? std::abs(dy) : std::abs(dx);
      const unsigned in_quarter = y < x ? (y < tangent_of_sector * x ? 0 : 1) : (x < tangent_of_sector * y ? 3 : 2);
      sectors |= 1u << (4 * quarter + in_quarter);
    }
    const unsigned empty = (~sectors & 0xffffu) | (~sectors & 0xffffu) << 16; // twice around
    return (empty & empty >> 1 & empty >> 2 & empty >> 3) == 0;
  }

  static void add_neighbors_of_neighbors(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, Index i,
                                         Delaunay_star_2::Indices& candidates)
  {
    const std::size_t n = candidates.size();
    for (std::size_t k = 0; k < n; ++k)
      candidates.insert(candidates.end(), neighbors.begin(candidates[k]), neighbors.end(candidates[k]));
    sort(bubbles, candidates);
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    candidates.erase(std::remove(candidates.begin(), candidates.end(), i), candidates.end());
  }

  static void sort(const Bubbles_2& bubbles, Delaunay_star_2::Indices& indices)
  {
    std::sort(indices.begin(), indices.end(), [&bubbles](Index i, Index j) { return bubbles.is_before(i, j); });
  }

  std::vector<Index> m_touched;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_LOCAL_TRIANGULATION_2_H
