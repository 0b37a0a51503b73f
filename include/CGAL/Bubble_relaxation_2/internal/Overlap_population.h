// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OVERLAP_POPULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OVERLAP_POPULATION_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Population_change.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The population control of section 2.1.4 of the paper, by the overlapping ratio of Shimada and
/// Gossard: with radii r = d/2,  alpha_i = 1/r_i sum_j (2 r_i + r_j - l_ij)  over the neighbours that
/// add something. Six neighbours at the wanted distance make 6. Needs no triangulation.
///
/// The sources do not give their thresholds; these were chosen by experiment with the paper's figures.
template <class Sizing>
class Overlap_population
{
public:
  /// delete a bubble whose ratio is larger
  double largest_ratio = 7;
  /// insert a bubble beside one whose ratio is smaller
  double smallest_ratio = 5.3;
  /// an inserted bubble is no nearer to another than this, in units of the mean size
  double least_distance = 0.75;

  Overlap_population(const Domain_2& domain, const Sizing& sizing)
    : m_domain(domain), m_sizing(sizing)
  {}

  Population_change operator()(const Bubbles_2& b) const
  {
    Neighbor_sets_2 neighbors(1.7);
    neighbors.build(b);
    std::vector<double> ratio(b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      ratio[i] = overlapping_ratio(b, neighbors, i);
    Population_change change;
    delete_overlapping(b, neighbors, ratio, change);
    insert_beside_lonely(b, neighbors, ratio, change);
    return change;
  }

private:
  static double distance(const Bubbles_2& b, Index i, Index j)
  {
    return std::hypot(b.x[i] - b.x[j], b.y[i] - b.y[j]);
  }

  static double overlapping_ratio(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index i)
  {
    double sum = 0;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
      sum += (std::max)(0., b.d[i] + 0.5 * b.d[*j] - distance(b, i, *j));
    return 2 * sum / b.d[i];
  }

  void delete_overlapping(const Bubbles_2& b, const Neighbor_sets_2& neighbors,
                          const std::vector<double>& ratio, Population_change& change) const
  {
    std::vector<Index> crowded;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (b.is_in_face(i) && ratio[i] > largest_ratio)
        crowded.push_back(static_cast<Index>(i));
    std::sort(crowded.begin(), crowded.end(), [&](Index i, Index j) {
      return ratio[i] > ratio[j] || (ratio[i] == ratio[j] && i < j);
    });
    // what a deletion takes away from its neighbours' ratios counts at once
    std::vector<double> left = ratio;
    for (Index i : crowded) {
      if (left[i] <= largest_ratio)
        continue;
      change.deleted.push_back(i);
      for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
        left[*j] -= (std::max)(0., 2 * b.d[*j] + b.d[i] - 2 * distance(b, i, *j)) / b.d[*j];
    }
  }

  void insert_beside_lonely(const Bubbles_2& b, const Neighbor_sets_2& neighbors,
                            const std::vector<double>& ratio, Population_change& change) const
  {
    std::vector<char> is_left(b.size(), 1);
    for (Index i : change.deleted)
      is_left[i] = 0;
    Bubble_buckets_2 buckets(least_distance, b.d[0], b.x[0], b.y[0], b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      if (is_left[i] && !b.is_gone(i))
        buckets.insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (!b.is_in_face(i) || !is_left[i] || ratio[i] >= smallest_ratio)
        continue;
      const double angle = middle_of_largest_gap(b, neighbors, i);
      const Point p(b.x[i] + b.d[i] * std::cos(angle), b.y[i] + b.d[i] * std::sin(angle));
      const Walk_end end = m_domain.walk(b.place[i], b.point(i), p);
      if (end.is_blocked())
        continue;
      const double d = m_sizing(p);
      if (!buckets.is_free(p.x(), p.y(), d))
        continue;
      buckets.insert(static_cast<Index>(b.size()), p.x(), p.y(), d);
      change.inserted.add(p, d, Bubbles_2::FACE, end.triangle);
    }
  }

  static double middle_of_largest_gap(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index i)
  {
    constexpr double full_turn = 6.283185307179586;
    std::vector<double> angles;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
      angles.push_back(std::atan2(b.y[*j] - b.y[i], b.x[*j] - b.x[i]));
    if (angles.empty())
      return 0;
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + full_turn - angles.back();
    double middle = angles.back() + 0.5 * widest;
    for (std::size_t k = 1; k < angles.size(); ++k)
      if (angles[k] - angles[k - 1] > widest) {
        widest = angles[k] - angles[k - 1];
        middle = angles[k - 1] + 0.5 * widest;
      }
    return middle;
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OVERLAP_POPULATION_H
