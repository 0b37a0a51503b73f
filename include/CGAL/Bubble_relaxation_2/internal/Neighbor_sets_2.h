// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_NEIGHBOR_SETS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_NEIGHBOR_SETS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The neighbour sets of section 2.1.3 of the paper (Verlet lists): for each bubble all others nearer
/// than `radius` times the mean of the two sizes, sorted by index, in one array.
///
/// With sizes d and a force that ends at 1.5 d, a set of radius r misses no interacting pair while
/// each bubble i keeps  moved_i + 0.75 (d_i - d_i at renewal) <= (r - 1.5) / 2 * d_i at renewal:
/// a pair outside the sets was at least r (d_i + d_j) / 2 apart, and the sum of both inequalities
/// leaves 1.5 times the mean of the present sizes.
class Neighbor_sets_2
{
public:
  explicit Neighbor_sets_2(double radius) : m_radius(radius) {}

  double radius() const { return m_radius; }
  std::size_t number_of_bubbles() const { return m_first.empty() ? 0 : m_first.size() - 1; }
  std::size_t number_of_pairs() const { return m_neighbors.size() / 2; }

  const Index* begin(std::size_t i) const { return m_neighbors.data() + m_first[i]; }
  const Index* end(std::size_t i) const { return m_neighbors.data() + m_first[i + 1]; }

  /// finds all neighbours anew with buckets
  void build(const Bubbles_2& bubbles)
  {
    const std::size_t n = bubbles.size();
    start(n);
    if (n == 0) {
      remember(bubbles);
      return;
    }
    Bubble_buckets_2 buckets(m_radius, bubbles.d[0], bubbles.x[0], bubbles.y[0], n);
    for (std::size_t i = 0; i < n; ++i)
      buckets.insert(static_cast<Index>(i), bubbles.x[i], bubbles.y[i], bubbles.d[i]);
    for (std::size_t i = 0; i < n; ++i) {
      buckets.for_each_near(bubbles.x[i], bubbles.y[i], bubbles.d[i],
                            [&](Index j, double, double) {
                              if (static_cast<std::size_t>(j) != i)
                                m_neighbors.push_back(j);
                              return true;
                            });
      finish(i);
    }
    remember(bubbles);
  }

  /// the paper's renewal: neighbours and their neighbours, as far as they are within the radius
  void renew_from_neighbors(const Bubbles_2& bubbles)
  {
    const std::size_t n = bubbles.size();
    std::vector<std::size_t> old_first;
    std::vector<Index> old_neighbors;
    old_first.swap(m_first);
    old_neighbors.swap(m_neighbors);
    start(n);
    std::vector<std::size_t> seen_by(n, n);
    for (std::size_t i = 0; i < n; ++i) {
      seen_by[i] = i;
      const auto consider = [&](Index j) {
        if (seen_by[j] == i)
          return;
        seen_by[j] = i;
        const double reach = 0.5 * m_radius * (bubbles.d[i] + bubbles.d[j]);
        const double dx = bubbles.x[j] - bubbles.x[i], dy = bubbles.y[j] - bubbles.y[i];
        if (dx * dx + dy * dy < reach * reach)
          m_neighbors.push_back(j);
      };
      for (std::size_t k = old_first[i]; k < old_first[i + 1]; ++k) {
        const Index j = old_neighbors[k];
        consider(j);
        for (std::size_t l = old_first[j]; l < old_first[j + 1]; ++l)
          consider(old_neighbors[l]);
      }
      finish(i);
    }
    remember(bubbles);
  }

  /// whether bubble `i` has used up its share of the skin, see above
  bool is_outrun_by(const Bubbles_2& bubbles, std::size_t i) const
  {
    const double dx = bubbles.x[i] - m_x[i], dy = bubbles.y[i] - m_y[i];
    const double left = 0.5 * (m_radius - 1.5) * m_d[i] - 0.75 * (bubbles.d[i] - m_d[i]);
    return left < 0 || dx * dx + dy * dy > left * left;
  }

private:
  void start(std::size_t n)
  {
    m_first.assign(1, 0);
    m_first.reserve(n + 1);
    m_neighbors.clear();
    m_neighbors.reserve(9 * n);
  }

  void finish(std::size_t i)
  {
    std::sort(m_neighbors.begin() + m_first[i], m_neighbors.end());
    m_first.push_back(m_neighbors.size());
  }

  void remember(const Bubbles_2& bubbles)
  {
    m_x = bubbles.x;
    m_y = bubbles.y;
    m_d = bubbles.d;
  }

  double m_radius;
  std::vector<std::size_t> m_first; // first neighbour of each bubble, and the end
  std::vector<Index> m_neighbors;
  std::vector<double> m_x, m_y, m_d; // at the last renewal
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_NEIGHBOR_SETS_2_H
