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

#include <algorithm>
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
    parallel_sort(threads, m_order,
                  [&holes](Index a, Index b) { return holes[a] < holes[b] || (!(holes[b] < holes[a]) && a < b); });
    m_states.resize(n);
    parallel_for(
      threads, n, [&](std::size_t k) { m_states[k] = is_possible(holes[k]) ? State::UNDECIDED : State::REFUSED; },
      grain);
    decide_together(
      team, [&] { return decide(holes, number_of_ours, reach); }, [&] { team.share_choice(m_states); });
  }

  /// calls `visit(hole)` for all that were chosen, those of other ranks too, the best first
  template <class Visitor>
  void for_each_chosen(const Visitor& visit) const
  {
    for (Index k : m_order)
      if (m_states[k] == State::CHOSEN)
        visit(k);
  }

private:
  using State = Greedy_choice::State;

  static constexpr std::size_t grain = 64;

  /// Decides on all of ours that do not depend on what others have still to decide; returns whether any is left. Each is
  /// compared with those that were chosen or are open, so with few, also in a crowd.
  bool decide(const std::vector<Hole_2>& holes, std::size_t number_of_ours, double reach)
  {
    const auto is_open_here = [&](std::size_t k) { return m_states[k] == State::UNDECIDED && k < number_of_ours; };
    if (std::none_of(m_order.begin(), m_order.end(), is_open_here))
      return false;
    Bubble_buckets_2 better(reach, holes[0].d, holes[0].x, holes[0].y, 0);
    bool is_open = false;
    std::size_t number = 0;
    for (Index k : m_order) {
      tick(number++);
      if (is_open_here(static_cast<std::size_t>(k))) {
        m_states[k] = state_beside(better, holes[k]);
        is_open = is_open || m_states[k] == State::UNDECIDED;
      }
      if (m_states[k] != State::REFUSED)
        better.insert(k, holes[k].x, holes[k].y, holes[k].d);
    }
    return is_open;
  }

  State state_beside(const Bubble_buckets_2& better, const Hole_2& hole) const
  {
    State result = State::CHOSEN;
    better.for_each_near(hole.x, hole.y, hole.d, [&](Index r, double, double) {
      result = m_states[r] == State::CHOSEN ? State::REFUSED : State::UNDECIDED;
      return result != State::REFUSED;
    });
    return result;
  }

  std::vector<Index> m_order; // the best first
  std::vector<char> m_states; // of each hole
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

/// The same where there is room beside the bubbles that are there. \pre there are some, those of other ranks near ours too
inline void fill_holes_beside(std::vector<Hole_2>& holes, double reach, Team& team, const Threads& threads,
                              Bubbles_2& bubbles)
{
  Bubble_buckets_2 there(reach, bubbles.d[0], bubbles.x[0], bubbles.y[0], bubbles.size());
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    tick(i);
    there.insert(static_cast<Index>(i), bubbles.x[i], bubbles.y[i], bubbles.d[i]);
  }
  fill_holes(
    holes, reach, team, threads, [&](const Hole_2& h) { return there.is_free(h.x, h.y, h.d); }, bubbles);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_HOLE_CHOICE_2_H
