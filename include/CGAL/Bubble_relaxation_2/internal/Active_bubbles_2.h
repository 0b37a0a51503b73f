// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ACTIVE_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ACTIVE_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/make_room_for.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The bubbles that take part in a step: those that moved in the step before, and their neighbours. The
/// others sleep. After some dozen steps most do, and what a step costs is what still moves.
class Active_bubbles_2
{
public:
  const std::vector<Index>& indices() const { return m_indices; }

  /// all bubbles that were active since the last call of `forget_touched()`
  const std::vector<Index>& touched() const { return m_touched; }

  void forget_touched()
  {
    for (Index i : m_touched)
      m_is_touched[i] = 0;
    m_touched.clear();
    if (!m_is_roused)
      for (Index i : m_indices)
        touch(i);
  }

  void wake_all(const Bubbles_2& bubbles)
  {
    start(bubbles);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      add(bubbles, static_cast<Index>(i));
  }

  /// all take part in the next step, but those that fall asleep again after it do not count as touched
  void rouse_all(const Bubbles_2& bubbles)
  {
    start(bubbles);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (bubbles.can_move(i)) {
        m_added_in[i] = m_step;
        m_indices.push_back(static_cast<Index>(i));
      }
    m_is_roused = true;
  }

  /// a bubble that is new or has lost a neighbour takes part in the next step
  void wake(const Bubbles_2& bubbles, Index i)
  {
    make_room(bubbles);
    add(bubbles, i);
  }

  void forget_gone(const Bubbles_2& bubbles)
  {
    const auto is_gone = [&bubbles](Index i) { return bubbles.is_gone(i); };
    m_indices.erase(std::remove_if(m_indices.begin(), m_indices.end(), is_gone), m_indices.end());
  }

  /// goes on to the next step; `is_moving[k]`: whether the `k`-th of `indices()` moves noticeably
  template <class Concurrency_tag>
  void advance(Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const std::vector<char>& is_moving)
  {
    m_is_roused = false;
    m_before.swap(m_indices);
    start(bubbles);
    if (many * m_before.size() > bubbles.size())
      ask_all<Concurrency_tag>(bubbles, neighbors, is_moving);
    else
      tell_neighbors(bubbles, neighbors, is_moving);
    for (Index i : m_before)
      if (m_added_in[i] != m_step)
        bubbles.stop(i);
  }

private:
  /// from one in so many on
  static constexpr std::size_t many = 8;

  /// Many are active: each bubble looks whether it or a neighbour moves. Then the active ones come in the order
  /// in which they lie in memory.
  template <class Concurrency_tag>
  void ask_all(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const std::vector<char>& is_moving)
  {
    m_moves.assign(bubbles.size(), 0);
    for (std::size_t k = 0; k < m_before.size(); ++k)
      m_moves[m_before[k]] = is_moving[k];
    m_is_called.resize(bubbles.size());
    parallel_for<Concurrency_tag>(bubbles.size(), [&](std::size_t i) {
      m_is_called[i] = m_moves[i] || std::any_of(neighbors.begin(i), neighbors.end(i),
                                                 [this](Index j) { return m_moves[j] != 0; });
    });
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      if (m_is_called[i])
        add(bubbles, static_cast<Index>(i));
  }

  /// few are active: those that move tell their neighbours
  void tell_neighbors(const Bubbles_2& bubbles, const Neighbor_sets_2& neighbors,
                      const std::vector<char>& is_moving)
  {
    for (std::size_t k = 0; k < m_before.size(); ++k) {
      if (!is_moving[k])
        continue;
      const Index i = m_before[k];
      add(bubbles, i);
      for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
        add(bubbles, *j);
    }
  }

  void start(const Bubbles_2& bubbles)
  {
    m_indices.clear();
    ++m_step;
    make_room(bubbles);
  }

  void make_room(const Bubbles_2& bubbles)
  {
    internal::make_room_for(bubbles.size() - m_added_in.size(), m_added_in);
    m_added_in.resize(bubbles.size(), 0);
    internal::make_room_for(bubbles.size() - m_is_touched.size(), m_is_touched);
    m_is_touched.resize(bubbles.size(), 0);
  }

  void add(const Bubbles_2& bubbles, Index i)
  {
    if (m_added_in[i] == m_step || !bubbles.can_move(i))
      return;
    m_added_in[i] = m_step;
    m_indices.push_back(i);
    touch(i);
  }

  void touch(Index i)
  {
    if (m_is_touched[i])
      return;
    m_is_touched[i] = 1;
    m_touched.push_back(i);
  }

  std::vector<Index> m_indices, m_before, m_touched;
  std::vector<char> m_is_touched;
  std::vector<char> m_moves, m_is_called; // in this step; or has a neighbour that does
  std::vector<std::uint32_t> m_added_in; // the step in which a bubble was added last
  std::uint32_t m_step = 1; // there are fewer than 2^32
  bool m_is_roused = false;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ACTIVE_BUBBLES_2_H
