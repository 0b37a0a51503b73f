// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_FRONT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_FRONT_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Surroundings_2.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// a bubble of the front, and with which direction it proposes
struct Proposer
{
  double key; ///< how small it counts
  Index index;
  Direction direction;

  /// a corner proposes along each of its edges
  bool operator>(const Proposer& p) const
  {
    return std::tie(key, index, direction.x, direction.y) >
           std::tie(p.key, p.index, p.direction.x, p.direction.y);
  }
};

/// The front of a growing crystal: the bubbles that have not proposed yet, the smallest keys first.
class Growth_front_2
{
public:
  explicit Growth_front_2(const Domain_2& domain) : m_domain(domain)
  {
    m_edges_of_corner.resize(domain.corners().size());
    for (std::size_t e = 0; e < domain.edges().size(); ++e) {
      m_edges_of_corner[domain.edges()[e].source].push_back(static_cast<Index>(e));
      m_edges_of_corner[domain.edges()[e].target].push_back(static_cast<Index>(e));
    }
  }

  const std::vector<Index>& edges_of_corner(Index corner) const { return m_edges_of_corner[corner]; }

  bool empty() const { return m_queue.empty(); }

  /// Adds a bubble with the direction of its lattice: a corner has one for each of its edges, and a bubble on
  /// an edge gets that of the edge.
  void add(const Bubbles_2& bubbles, std::size_t i, double key, Direction& direction)
  {
    const Index index = static_cast<Index>(i), place = bubbles.place[i];
    if (bubbles.is_on_edge(i))
      m_queue.push(Proposer{key, index, direction = m_domain.direction(place)});
    else if (bubbles.is_in_face(i) || place == no_index)
      m_queue.push(Proposer{key, index, direction});
    else
      for (Index e : m_edges_of_corner[place])
        m_queue.push(Proposer{key, index, m_domain.direction(e)});
  }

  /// infinity if the front is empty
  double smallest_key() const
  {
    return m_queue.empty() ? std::numeric_limits<double>::infinity() : m_queue.top().key;
  }

  /// takes the next generation off the front: all that are about as small as the smallest of all
  void take_generation(double smallest, std::vector<Proposer>& generation)
  {
    generation.clear();
    for (; !m_queue.empty() && m_queue.top().key <= band * smallest; m_queue.pop())
      generation.push_back(m_queue.top());
  }

private:
  /// a generation is all bubbles of the front up to this times the smallest key
  static constexpr double band = 1.05;

  const Domain_2& m_domain;
  std::vector<std::vector<Index>> m_edges_of_corner;
  std::priority_queue<Proposer, std::vector<Proposer>, std::greater<Proposer>> m_queue;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GROWTH_FRONT_2_H
