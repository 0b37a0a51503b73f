// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_ACTIVE_BUBBLES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_ACTIVE_BUBBLES_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bubbles that take part in a step: those that moved in the step before, and their neighbours. The
/// others sleep. After some dozen steps most do, and what a step costs is what still moves.
class Active_bubbles_2
{
public:
  const std::vector<Index>& indices() const { return m_indices; }

  /// all bubbles that were active since the last call of `forget_touched()`, by increasing indices
  std::vector<Index> touched() const { return marked(m_is_touched); }

  void forget_touched()
  {
    std::fill(m_is_touched.begin(), m_is_touched.end(), char(0));
    if (!m_is_roused)
      for (Index i : m_indices)
        m_is_touched[i] = 1;
  }

  void wake_all(const Bubbles_2& bubbles)
  {
    rouse_all(bubbles);
    m_is_roused = false;
  }

  /// all take part in the next step, but those that fall asleep again after it do not count as touched
  void rouse_all(const Bubbles_2& bubbles)
  {
    make_room(bubbles);
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      tick(i);
      m_is_active[i] = is_movable(bubbles, i);
    }
    m_indices = marked(m_is_active);
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

  /// bubbles that other ranks own take no part in the next step
  void forget_others(const Bubbles_2& bubbles)
  {
    for (Index i : m_indices)
      if (!bubbles.is_ours(i))
        m_is_active[i] = 0;
    const auto is_other = [&bubbles](Index i) { return !bubbles.is_ours(i); };
    m_indices.erase(std::remove_if(m_indices.begin(), m_indices.end(), is_other), m_indices.end());
  }

  /// bubbles that other ranks own took part in this step too, after the last of `indices()`
  void add_others(const std::vector<Index>& others)
  {
    m_indices.insert(m_indices.end(), others.begin(), others.end());
  }

  bool is_active(Index i) const { return m_is_active[i] != 0; }
  bool is_touched(Index i) const { return m_is_touched[i] != 0; }

  /// starts anew with bubbles that come from elsewhere
  void restart(const std::vector<char>& is_active, const std::vector<char>& is_touched, bool is_roused)
  {
    m_is_active = is_active;
    m_is_touched = is_touched;
    m_is_roused = is_roused;
    m_moves.assign(is_active.size(), 0);
    m_indices = marked(is_active);
  }

  bool is_roused() const { return m_is_roused; }

  /// goes on to the next step; `is_moving[k]`: whether the `k`-th of `indices()` moves noticeably
  void advance(Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const std::vector<char>& is_moving,
               const Threads& threads)
  {
    make_room(bubbles);
    m_is_roused = false;
    m_before.swap(m_indices);
    m_indices.clear();
    if (many * m_before.size() > bubbles.size())
      ask_all(bubbles, neighbors, is_moving, threads);
    else
      tell_neighbors(bubbles, neighbors, is_moving);
  }

  /// \pre bubbles were only added
  void make_room(const Bubbles_2& bubbles)
  {
    for (std::vector<char>* flags : {&m_is_active, &m_is_touched}) {
      internal::make_room_for(bubbles.size() - flags->size(), *flags);
      flags->resize(bubbles.size(), 0);
    }
  }

private:
  /// from one in so many on
  static constexpr std::size_t many = 8;
  static constexpr std::size_t block_size = 4096;

  /// Many are active: each bubble looks whether it or a neighbour moves. Then the active ones come in the order
  /// in which they lie in memory.
  void ask_all(Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const std::vector<char>& is_moving,
               const Threads& threads)
  {
    m_moves.resize(bubbles.size());
    parallel_for(threads, m_before.size(), [&](std::size_t k) { m_moves[m_before[k]] = is_moving[k]; });
    std::vector<std::size_t> positions((bubbles.size() + block_size - 1) / block_size + 1, 0);
    parallel_for(
      threads, positions.size() - 1,
      [&](std::size_t block) {
        for (std::size_t i = block * block_size; i < end_of(block); ++i)
          positions[block + 1] += ask(bubbles, neighbors, i);
      },
      1);
    std::partial_sum(positions.begin(), positions.end(), positions.begin());
    m_indices.resize(positions.back());
    parallel_for(
      threads, positions.size() - 1,
      [&](std::size_t block) {
        std::size_t k = positions[block];
        for (std::size_t i = block * block_size; i < end_of(block); ++i)
          if (m_is_active[i])
            m_indices[k++] = static_cast<Index>(i);
      },
      1);
    parallel_for(threads, m_before.size(), [&](std::size_t k) { m_moves[m_before[k]] = 0; });
  }

  std::size_t end_of(std::size_t block) const
  {
    return (std::min)((block + 1) * block_size, m_is_active.size());
  }

  /// whether a bubble is active in the next step
  bool ask(Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, std::size_t i)
  {
    const bool is_called = m_moves[i] || std::any_of(neighbors.begin(i), neighbors.end(i),
                                                     [this](Index j) { return m_moves[j] != 0; });
    const bool was_active = m_is_active[i] != 0;
    m_is_active[i] = is_called && is_movable(bubbles, i);
    if (m_is_active[i])
      m_is_touched[i] = 1;
    else if (was_active)
      bubbles.stop(i);
    return m_is_active[i] != 0;
  }

  /// few are active: those that move tell their neighbours
  void tell_neighbors(Bubbles_2& bubbles, const Neighbor_sets_2& neighbors, const std::vector<char>& is_moving)
  {
    for (Index i : m_before)
      m_is_active[i] = 0;
    for (std::size_t k = 0; k < m_before.size(); ++k) {
      if (!is_moving[k])
        continue;
      const Index i = m_before[k];
      add(bubbles, i);
      for (const Index *j = neighbors.begin(i), *end = neighbors.end(i); j != end; ++j)
        add(bubbles, *j);
    }
    for (Index i : m_before)
      if (!m_is_active[i])
        bubbles.stop(i);
  }

  static bool is_movable(const Bubbles_2& bubbles, std::size_t i)
  {
    return bubbles.can_move(i) && bubbles.is_ours(i);
  }

  void add(const Bubbles_2& bubbles, Index i)
  {
    if (m_is_active[i] || !is_movable(bubbles, i))
      return;
    m_is_active[i] = m_is_touched[i] = 1;
    m_indices.push_back(i);
  }

  std::vector<Index> m_indices, m_before;
  std::vector<char> m_is_active, m_is_touched;
  std::vector<char> m_moves; // in a step with many
  bool m_is_roused = false;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATION_ACTIVE_BUBBLES_2_H
