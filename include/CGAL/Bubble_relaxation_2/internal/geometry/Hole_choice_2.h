// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HOLE_CHOICE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HOLE_CHOICE_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Greedy_choice.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Chooses holes that get a bubble, the best first, as long as they do not come too near to a better one that was
/// chosen. Of equal ones, which are of the same rank, the first counts.
class Hole_choice_2
{
public:
  /// `number_of_ours`: as many are decided on here, the first ones, the others by other ranks. Two holes nearer than
  /// `reach` times their mean size stand in each other's way; those for which `is_possible(hole)` does not hold are not
  /// chosen.
  template <class Is_possible>
  void operator()(const std::vector<Hole_2>& holes, std::size_t number_of_ours, double reach, Team& team,
                  const Threads& threads, const Is_possible& is_possible)
  {
    const std::size_t n = holes.size();
    m_order = indices_below(n);
    sort_indices(m_order, [&holes](Index a, Index b) { return holes[a] < holes[b]; });
    m_is_possible.resize(n);
    parallel_for(
      threads, n, [&](std::size_t k) { m_is_possible[k] = is_possible(holes[k]); }, grain);
    m_choice.start(n);
    for (Index k : m_order)
      if (m_is_possible[k] && static_cast<std::size_t>(k) < number_of_ours)
        m_choice.add(k);
    find_rivals(holes, reach, threads);
    decide_together(
      team, [this] { return m_choice.decide([](Index) { return true; }); },
      [&] { team.share_choice(m_choice.states()); });
  }

  /// calls `visit(hole)` for all that were chosen, those of other ranks too, the best first
  template <class Visitor>
  void for_each_chosen(const Visitor& visit) const
  {
    for (Index k : m_order)
      if (m_choice.is_chosen(k))
        visit(k);
  }

private:
  static constexpr std::size_t grain = 64;

  void find_rivals(const std::vector<Hole_2>& holes, double reach, const Threads& threads)
  {
    if (holes.empty())
      return;
    Bubble_buckets_2 near(reach, holes[0].d, holes[0].x, holes[0].y, holes.size());
    for (std::size_t k = 0; k < holes.size(); ++k)
      if (m_is_possible[k])
        near.insert(static_cast<Index>(k), holes[k].x, holes[k].y, holes[k].d);
    const std::vector<Index>& ours = m_choice.candidates();
    parallel_for(
      threads, ours.size(),
      [&](std::size_t k) {
        const Hole_2& hole = holes[ours[k]];
        near.for_each_near(hole.x, hole.y, hole.d, [&](Index r, double, double) {
          if (holes[r] < hole || (r < ours[k] && !(hole < holes[r])))
            m_choice.rivals(k).push_back(r);
          return true;
        });
      },
      grain);
  }

  std::vector<Index> m_order; // the best first
  std::vector<char> m_is_possible;
  Greedy_choice m_choice;
};

/// Adds bubbles in holes, the best first, none nearer to another than `reach` times the mean size, where
/// `is_possible(hole)` holds. Each rank tells of its holes and gets bubbles in its own part.
template <class Is_possible>
void fill_holes(std::vector<Hole_2>& holes, double reach, Team& team, const Threads& threads,
                const Is_possible& is_possible, Bubbles_2& bubbles)
{
  const std::size_t number_of_ours = team.share_holes(holes, reach);
  Hole_choice_2 choose;
  choose(holes, number_of_ours, reach, team, threads, is_possible);
  choose.for_each_chosen([&](Index k) {
    const Hole_2& h = holes[k];
    if (static_cast<std::size_t>(k) < number_of_ours)
      bubbles.add(Point(h.x, h.y), h.d, Bubbles_2::FACE, h.triangle);
  });
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HOLE_CHOICE_2_H
