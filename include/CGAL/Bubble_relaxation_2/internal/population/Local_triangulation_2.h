// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_LOCAL_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_LOCAL_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The neighbours of a bubble in the Delaunay triangulation of some bubbles around it, by wrapping: from the
/// nearest one, which is a neighbour, to the one whose triangle has an empty circle, and so on. Computed with
/// doubles, up to roundings; of bubbles on one circle their numbers decide which are neighbours.
class Delaunay_star_2
{
public:
  using Indices = boost::container::small_vector<Index, 24>;

  Delaunay_star_2(const Bubbles_2& bubbles, Index center) : m_bubbles(bubbles), m_center(center) {}

  /// `candidates`: the bubbles around. The neighbours come counterclockwise; if the star is open, which it is
  /// where the candidates leave an angle of 180 degrees, from one end to the other.
  void wrap(const Indices& candidates)
  {
    m_ring.clear();
    m_is_closed = false;
    m_largest_circle = 0;
    take(candidates);
    const std::size_t first = nearest();
    if (first == none)
      return;
    Positions ring(1, first);
    m_is_closed = wrap_left(first, ring);
    if (!m_is_closed && ring.size() <= m_others.size())
      wrap_right(first, ring);
    for (std::size_t k : ring)
      m_ring.push_back(m_others[k].index);
  }

  const Indices& ring() const { return m_ring; }
  bool is_closed() const { return m_is_closed; }
  /// the largest square radius of its triangles' circles over the square size of the bubble
  double largest_circle() const { return m_largest_circle; }

private:
  using Positions = boost::container::small_vector<std::size_t, 24>;

  /// another bubble, in coordinates relative to the center and in units of its size
  struct Other
  {
    double x, y;
    Index index;
  };

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void take(const Indices& candidates)
  {
    const double x = m_bubbles.x[m_center], y = m_bubbles.y[m_center], unit = 1 / m_bubbles.d[m_center];
    m_others.clear();
    for (Index j : candidates)
      m_others.push_back(Other{(m_bubbles.x[j] - x) * unit, (m_bubbles.y[j] - y) * unit, j});
    m_cotangents.resize(m_others.size());
  }

  std::size_t nearest() const
  {
    std::size_t best = none;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < m_others.size(); ++k) {
      const double squared = m_others[k].x * m_others[k].x + m_others[k].y * m_others[k].y;
      if (squared > 0 && squared < least) {
        least = squared;
        best = k;
      }
    }
    return best;
  }

  /// goes around to the left; returns whether it comes back to the first
  bool wrap_left(std::size_t first, Positions& ring)
  {
    while (ring.size() <= m_others.size()) {
      const std::size_t next = beside(ring.back(), 1);
      if (next == none || next == first)
        return next == first;
      ring.push_back(next);
    }
    return false;
  }

  void wrap_right(std::size_t first, Positions& ring)
  {
    Positions right;
    for (std::size_t next = beside(first, -1); next != none && ring.size() + right.size() <= m_others.size();
         next = beside(next, -1))
      right.push_back(next);
    ring.insert(ring.begin(), right.rbegin(), right.rend());
  }

  /// The other bubble on the left (`side` 1) or right of the ray to the one at `j` that sees the center and `j`
  /// in the largest angle: no other lies in its circle on this side.
  std::size_t beside(std::size_t j, int side)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double ux = m_others[j].x, uy = m_others[j].y;
    double least = infinity;
    std::size_t best = none;
    for (std::size_t k = 0; k < m_others.size(); ++k) {
      const double vx = m_others[k].x, vy = m_others[k].y, area = side * (ux * vy - uy * vx);
      m_cotangents[k] = area > flat ? (vx * (vx - ux) + vy * (vy - uy)) / area : infinity;
      if (m_cotangents[k] < least) {
        least = m_cotangents[k];
        best = k;
      }
    }
    if (best == none)
      return none;
    // (side / (2 sin))^2
    m_largest_circle = (std::max)(m_largest_circle, 0.25 * (ux * ux + uy * uy) * (1 + least * least));
    m_equal.clear();
    const double limit = least + equal * (1 + std::abs(least));
    for (std::size_t k = 0; k < m_others.size(); ++k)
      if (m_cotangents[k] <= limit)
        m_equal.push_back(k);
    return m_equal.size() == 1 ? best : choice_on_circle(j, side);
  }

  /// Of several on one circle all are connected to the one with the smallest number. All stars agree on that.
  std::size_t choice_on_circle(std::size_t j, int side) const
  {
    const std::size_t smallest = *std::min_element(m_equal.begin(), m_equal.end(), [this](auto k, auto l) {
      return m_bubbles.is_before(m_others[k].index, m_others[l].index);
    });
    if (m_bubbles.is_before(m_others[smallest].index, m_center) &&
        m_bubbles.is_before(m_others[smallest].index, m_others[j].index))
      return smallest;
    // the next on the circle after j, or the last before the center
    const bool wants_next = m_bubbles.is_before(m_center, m_others[j].index);
    std::size_t best = m_equal.front();
    for (std::size_t k : m_equal) {
      const double turn = side * (m_others[best].x * m_others[k].y - m_others[best].y * m_others[k].x);
      if (wants_next ? turn < 0 : turn > 0)
        best = k;
    }
    return best;
  }

  /// twice the area, in square sizes, of triangles that count as none
  static constexpr double flat = 1e-9;
  /// differences of cotangents that count as none
  static constexpr double equal = 1e-7;

  const Bubbles_2& m_bubbles;
  Index m_center;
  Indices m_ring;
  boost::container::small_vector<Other, 24> m_others;
  boost::container::small_vector<double, 24> m_cotangents;
  Positions m_equal; // on one circle
  bool m_is_closed = false;
  double m_largest_circle = 0;
};

/// The Delaunay triangles with at least one of some bubbles, found from their neighbour sets: each bubble
/// wraps its own star, and of the stars of a triangle's corners that of the first one counts. Beside holes that
/// no neighbour set reaches across, the buckets are asked. A triangle is one of the triangulation of all
/// bubbles, unless its circle is so large that there is a hole anyway.
class Local_triangulation_2
{
public:
  using Triangle = std::array<Index, 3>; ///< bubbles, counterclockwise

  Local_triangulation_2(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, std::vector<Index> touched,
                        const Threads& threads)
    : m_touched(std::move(touched))
  {
    wrap(bubbles, neighbors, threads);
  }

  /// Beside holes wider than this, in sizes, all bubbles are looked at that are nearer than the radius of neighbour
  /// sets times the mean of this times the size and their size: up to about five sizes away.
  static constexpr double widest_hole = 2.4, far = 5;

  /// whether a bubble lies beside such a hole, or neighbour sets do not tell
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
  /// The forces end at 1.5 d, and pairs farther apart than that may be missing in the sets: circles up to this
  /// diameter are known to be empty. For others the neighbours' neighbours are looked at as well, which reach around
  /// a hole of up to `widest_hole`.
  static constexpr double certain_diameter = 1.5;

  /// With more neighbours, or more than the square of that of theirs, with a large radius, or where bubbles are piled up or
  /// lie among much larger ones, it is faster to look around.
  static constexpr std::size_t most_neighbors = 48;

  static constexpr std::size_t block_size = 512;

  void wrap(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const Threads& threads)
  {
    std::vector<char> is_touched(bubbles.size(), 0);
    for (Index i : m_touched)
      is_touched[i] = 1;
    std::vector<std::vector<Triangle>> blocks((m_touched.size() + block_size - 1) / block_size);
    parallel_for(
      threads, blocks.size(),
      [&](std::size_t b) {
        const std::size_t last = (std::min)((b + 1) * block_size, m_touched.size());
        for (std::size_t k = b * block_size; k < last; ++k)
          if (bubbles.is_ours(m_touched[k]))
            add_star(bubbles, neighbors, is_touched, m_touched[k], blocks[b]);
      },
      1);
    std::size_t number = 0;
    for (const std::vector<Triangle>& block : blocks)
      number += block.size();
    m_triangles.reserve(number);
    for (const std::vector<Triangle>& block : blocks) {
      m_triangles.insert(m_triangles.end(), block.begin(), block.end());
      tick();
    }
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
      if (candidates.size() > most_neighbors ||
          number_of_neighbors(neighbors, candidates) > most_neighbors * most_neighbors)
        return false;
      add_neighbors_of_neighbors(bubbles, neighbors, i, candidates);
      star.wrap(candidates);
    }
    return is_within(widest_hole);
  }

  /// Whether it is clear without a star that no circle is wider than `widest_hole`. One through the bubble with
  /// diameter w contains all that is nearer than w cos(a) in directions up to an angle a from its centre. If of 16
  /// sectors no four in a row are empty of neighbours, one is in a direction up to 56.25 degrees from each other one.
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

  static std::size_t number_of_neighbors(const Neighbor_sets_2& neighbors, const Delaunay_star_2::Indices& bubbles)
  {
    std::size_t number = 0;
    for (Index i : bubbles)
      number += static_cast<std::size_t>(neighbors.end(i) - neighbors.begin(i));
    return number;
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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_LOCAL_TRIANGULATION_2_H
