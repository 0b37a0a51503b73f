// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_OVERLAP_POPULATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_OVERLAP_POPULATION_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hole_choice_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The population control of section 2.1.4 of the paper, by the overlapping ratio of Shimada and
/// Gossard: with radii r = d/2,  alpha_i = 1/r_i sum_j (2 r_i + r_j - l_ij)  over the neighbours that
/// add something. Six neighbours at the wanted distance make 6. Needs no triangulation.
///
/// The sources do not give their thresholds; these were chosen by experiment with the paper's figures.
class Overlap_population
{
public:
  /// delete a bubble whose ratio is larger
  double largest_ratio = 7;
  /// insert a bubble beside one whose ratio is smaller
  double smallest_ratio = 5.3;
  /// an inserted bubble is no nearer to another than this, in units of the mean size
  double least_distance = 0.75;

  Overlap_population(const Domain_2& domain, const Sizes_2& sizing, Team& team)
    : m_domain(domain), m_sizing(sizing), m_team(team)
  {}

  Population_change operator()(const Bubbles_2& b) const
  {
    Neighbor_sets_2 neighbors(1.7);
    neighbors.build(b);
    std::vector<double> ratio(b.size(), 0);
    for (std::size_t i = 0; i < b.size(); ++i) {
      tick(i);
      if (b.is_ours(i))
        ratio[i] = overlapping_ratio(b, neighbors, static_cast<Index>(i));
    }
    m_team.share(ratio);
    const std::vector<char> is_deleted = delete_overlapping(b, neighbors, ratio);
    Population_change change;
    change.deleted = marked(is_deleted);
    insert_beside_lonely(b, neighbors, ratio, is_deleted, change.inserted);
    sort_in_space(m_domain, change.inserted);
    m_team.number(change.inserted);
    return change;
  }

private:
  static double distance(const Bubbles_2& b, Index i, Index j)
  {
    return length_of(b.x[i] - b.x[j], b.y[i] - b.y[j]);
  }

  static double overlapping_ratio(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index i)
  {
    double sum = 0;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
      sum += (std::max)(0., b.d[i] + 0.5 * b.d[*j] - distance(b, i, *j));
    return 2 * sum / b.d[i];
  }

  /// whether bubbles are deleted: the most crowded first
  std::vector<char> delete_overlapping(const Bubbles_2& b, const Neighbor_sets_2& neighbors,
                                       const std::vector<double>& ratio) const
  {
    const auto is_crowded = [&](Index i) { return b.is_in_face(i) && ratio[i] > largest_ratio; };
    const auto is_worse = [&](Index i, Index j) {
      return ratio[i] > ratio[j] || (ratio[i] == ratio[j] && b.is_before(i, j));
    };
    std::vector<Index> crowded = indices_where(b.size(), [&](Index i) { return b.is_ours(i) && is_crowded(i); });
    sort_indices(crowded, is_worse);
    Greedy_choice choice;
    choice.start(b.size());
    for (Index i : crowded) {
      tick(static_cast<std::size_t>(i));
      Greedy_choice::Rivals& worse = choice.rivals(choice.add(i)); // in the same order
      std::copy_if(neighbors.begin(i), neighbors.end(i), std::back_inserter(worse),
                   [&](Index j) { return is_crowded(j) && is_worse(j, i); });
      std::sort(worse.begin(), worse.end(), is_worse);
    }
    const auto judge = [&](Index i, const Greedy_choice::Rivals& worse) {
      double left = ratio[i]; // what a deletion takes away from its neighbours' ratios counts at once
      for (Index j : worse)
        if (choice.is_chosen(j))
          left -= (std::max)(0., 2 * b.d[i] + b.d[j] - 2 * distance(b, i, j)) / b.d[i];
      return left > largest_ratio ? Greedy_choice::CHOSEN : Greedy_choice::REFUSED;
    };
    decide_together(
      m_team, [&] { return choice.decide_by(judge); }, [&] { m_team.share(choice.states()); });
    std::vector<char> is_deleted(b.size());
    for (std::size_t i = 0; i < b.size(); ++i)
      is_deleted[i] = choice.is_chosen(static_cast<Index>(i));
    return is_deleted;
  }

  void insert_beside_lonely(const Bubbles_2& b, const Neighbor_sets_2& neighbors, const std::vector<double>& ratio,
                            const std::vector<char>& is_deleted, Bubbles_2& inserted) const
  {
    const Point origin(m_domain.bbox().xmin(), m_domain.bbox().ymin());
    Bubble_buckets_2 buckets(least_distance, b.size() == 0 ? 1. : b.d[0], origin.x(), origin.y(), b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      tick(i);
      if (!is_deleted[i] && !b.is_gone(i))
        buckets.insert(static_cast<Index>(i), b.x[i], b.y[i], b.d[i]);
    }
    std::vector<Hole_2> holes;
    for (std::size_t i = 0; i < b.size(); ++i) {
      tick(i);
      if (b.is_ours(i) && b.is_in_face(i) && !is_deleted[i] && ratio[i] < smallest_ratio)
        add_place_beside(b, neighbors, static_cast<Index>(i), buckets, holes);
    }
    fill_holes(
      holes, least_distance, m_team, Threads(), [](const Hole_2&) { return true; }, inserted);
  }

  /// a place for a bubble in the widest gap beside bubble `i` if there is room; the first of bubbles comes first
  void add_place_beside(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index i,
                        const Bubble_buckets_2& buckets, std::vector<Hole_2>& holes) const
  {
    constexpr double largest_ratio_of_sizes = 4; // where d jumps, others are looked for no farther than this allows
    const double angle = middle_of_largest_gap(b, neighbors, i);
    const Point p(b.x[i] + b.d[i] * cosine_of(angle), b.y[i] + b.d[i] * sine_of(angle));
    const Walk_end end = m_domain.walk(b.host[i], b.point(i), p);
    if (end.is_blocked())
      return;
    const double d = m_sizing(p);
    if (!buckets.is_free(p.x(), p.y(), (std::min)(d, largest_ratio_of_sizes * b.d[i])))
      return;
    const double number = static_cast<double>(b.id.empty() ? i : b.id[i]);
    holes.push_back(Hole_2{number, p.x(), p.y(), d, end.triangle});
  }

  static double middle_of_largest_gap(const Bubbles_2& b, const Neighbor_sets_2& neighbors, Index i)
  {
    constexpr double full_turn = 6.283185307179586;
    std::vector<double> angles;
    for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
      angles.push_back(angle_of(b.x[*j] - b.x[i], b.y[*j] - b.y[i]));
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
  const Sizes_2& m_sizing;
  Team& m_team;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_OVERLAP_POPULATION_H
