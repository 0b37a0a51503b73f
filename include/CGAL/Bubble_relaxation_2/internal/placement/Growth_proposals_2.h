// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_PROPOSALS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_PROPOSALS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Crystal_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_limits_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// a bubble of the front, and with which direction it proposes
struct Growth_proposer
{
  double key; ///< how small it counts
  Index index;
  Direction direction;

  /// a corner proposes along each of its edges
  bool operator>(const Growth_proposer& p) const
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

  /// Adds a bubble with the direction of its lattice: a corner has one for each of its edges, and a bubble on
  /// an edge gets that of the edge.
  void add(const Bubbles_2& bubbles, std::size_t i, double key, Direction& direction)
  {
    const Index index = static_cast<Index>(i), host = bubbles.host[i];
    if (bubbles.is_on_edge(i))
      m_queue.push(Growth_proposer{key, index, direction = m_domain.direction(host)});
    else if (bubbles.is_in_face(i) || host == no_index)
      m_queue.push(Growth_proposer{key, index, direction});
    else
      for (Index e : m_edges_of_corner[host])
        m_queue.push(Growth_proposer{key, index, m_domain.direction(e)});
  }

  /// infinity if the front is empty
  double smallest_key() const
  {
    return m_queue.empty() ? std::numeric_limits<double>::infinity() : m_queue.top().key;
  }

  /// takes the next generation off the front: all that are about as small as the smallest of all
  void take_generation(double smallest, std::vector<Growth_proposer>& generation)
  {
    generation.clear();
    for (; !m_queue.empty() && m_queue.top().key <= band * smallest; m_queue.pop()) {
      tick(generation.size());
      generation.push_back(m_queue.top());
    }
  }

private:
  /// a generation is all bubbles of the front up to this times the smallest key
  static constexpr double band = 1.05;

  const Domain_2& m_domain;
  std::vector<std::vector<Index>> m_edges_of_corner;
  std::priority_queue<Growth_proposer, std::vector<Growth_proposer>, std::greater<Growth_proposer>> m_queue;
};

enum class Lattice_direction
{
  BENDS, ///< with its neighbours: rows follow the boundary, and the lines along which d grows
  KEEPS  ///< not at all
};

/// a place for a new bubble
struct Growth_proposal_2
{
  double misfit;       ///< how badly the bubble would fit
  double key;          ///< of the bubble that proposes
  double x, y, d;
  Direction direction; ///< of the lattice there
  Index triangle;      ///< of the domain
  Index from;          ///< the bubble that proposes, `no_index` for a bubble that is there already
};

/// What the bubbles of a generation propose: each of the six places around a bubble where there is room, moved
/// to where a bubble would settle.
class Growth_proposals_2
{
public:
  Growth_proposals_2(const Domain_2& domain, const Sizes_2& sizing, const Crystal_2& crystal,
                     const Growth_front_2& front, Lattice_direction lattice, const Team& team, const Threads& threads)
    : m_team(team), m_threads(threads), m_domain(domain), m_sizing(sizing), m_crystal(crystal),
      m_bubbles(crystal.bubbles()), m_front(front), m_lattice(lattice)
  {}

  /// adds the proposals of those of a generation that this rank owns
  void operator()(const std::vector<Growth_proposer>& generation, std::vector<Growth_proposal_2>& result)
  {
    m_proposes.resize(m_crystal.size(), 0);
    for (const Growth_proposer& p : generation)
      m_proposes[p.index] = !m_bubbles.is_corner(p.index);
    for (std::size_t first = 0; first < generation.size(); first += most_at_once)
      propose(generation, first, (std::min)(generation.size() - first, most_at_once), result);
    for (const Growth_proposer& p : generation)
      m_proposes[p.index] = 0;
  }

private:
  struct List
  {
    std::array<Growth_proposal_2, 6> list;
    int size;
  };

  /// All bubbles of a mesh that is given may be one generation, and each has room for six proposals here.
  static constexpr std::size_t most_at_once = 8192;

  /// how far the neighbours of a proposal are looked for
  static constexpr double surroundings_reach = 1.7;
  static constexpr int proposal_steps = 3;

  /// what `number` bubbles of a generation propose
  void propose(const std::vector<Growth_proposer>& generation, std::size_t first, std::size_t number,
               std::vector<Growth_proposal_2>& result)
  {
    m_lists.resize((std::max)(m_lists.size(), number));
    parallel_for(
      m_threads, number,
      [&](std::size_t k) {
        m_lists[k].size = 0;
        if (m_team.owns(generation[first + k].index))
          propose_from(generation[first + k], m_lists[k]);
      },
      m_crystal.grain);
    for (std::size_t k = 0; k < number; ++k)
      result.insert(result.end(), m_lists[k].list.begin(), m_lists[k].list.begin() + m_lists[k].size);
  }

  void propose_from(const Growth_proposer& from, List& proposals) const
  {
    const unsigned taken = taken_places(from);
    Direction u = from.direction;
    for (int turn = 0; turn < 6; ++turn, u = turned(u))
      if ((taken >> turn & 1) == 0)
        propose(from, u, proposals);
  }

  /// a bit for each of the six places around a bubble: whether one that is linked to it takes it
  unsigned taken_places(const Growth_proposer& from) const
  {
    const Index i = from.index;
    const double d = m_bubbles.d[i];
    const Direction u = from.direction, v = turned(u), w = turned(v);
    unsigned taken = 0;
    for (Index j : m_crystal.links(i)) {
      const double x = m_bubbles.x[j] - m_bubbles.x[i], y = m_bubbles.y[j] - m_bubbles.y[i];
      const double reach = 0.5 * Growth_limits_2::least_distance * (d + m_bubbles.d[j]);
      // by the law of cosines; opposite places differ in a sign
      const double least = (x * x + y * y + d * d - reach * reach) / (2 * d);
      const double a = x * u.x + y * u.y, b = x * v.x + y * v.y, c = x * w.x + y * w.y;
      taken |= unsigned(a > least) | unsigned(b > least) << 1 | unsigned(c > least) << 2 |
               unsigned(-a > least) << 3 | unsigned(-b > least) << 4 | unsigned(-c > least) << 5;
    }
    return taken;
  }

  /// adds the bubbles around `p` that are linked to `i`
  void add_linked(Index i, const Point& p, double d, Growth_limits_2& around) const
  {
    around.add_if_near(i, m_bubbles, p, d, surroundings_reach);
    for (Index j : m_crystal.links(i))
      around.add_if_near(j, m_bubbles, p, d, surroundings_reach);
  }

  /// adds those that are linked to one of these, and other proposals of `i`, unless one takes the place already: on an
  /// outline that is far finer than d bubbles are linked to very many
  bool add_farther(const Point& p, double d, const List& proposals, Growth_limits_2& around) const
  {
    for (std::size_t k = 1, n = around.size(); k < n; ++k) {
      const std::size_t first = around.size();
      for (Index l : m_crystal.links(around.index(k)))
        around.add_if_near(l, m_bubbles, p, d, surroundings_reach);
      if (!around.is_free(p, d, first))
        return false;
    }
    const std::size_t first = around.size();
    for (int k = 0; k < proposals.size; ++k)
      around.add(Point(proposals.list[k].x, proposals.list[k].y), proposals.list[k].d);
    return around.is_free(p, d, first);
  }

  /// tests by their cost: most places are taken
  void propose(const Growth_proposer& from, const Direction& u, List& proposals) const
  {
    const Index i = from.index;
    const double x = m_bubbles.x[i], y = m_bubbles.y[i], d_i = m_bubbles.d[i];
    const Point start(x + d_i * u.x, y + d_i * u.y);
    Growth_limits_2 around;
    add_linked(i, start, d_i, around);
    if (!around.is_free(start, d_i) || is_left_to_other(i, start, around) ||
        !add_farther(start, d_i, proposals, around) || is_left_to_other(i, start, around))
      return;
    const Index seen = visible_triangle(i, start);
    if (seen == no_index)
      return;
    const double ahead = m_sizing(start), wanted = 0.5 * (d_i + ahead);
    const auto d_at = [=](double distance) { // linear between the two
      return d_i + (ahead - d_i) * (ahead < d_i ? (std::min)(distance / d_i, 1.) : distance / d_i);
    };
    const Point p = around.settle(Point(x + wanted * u.x, y + wanted * u.y), d_at(wanted),
                                  proposal_steps);
    const double d = d_at(std::sqrt((p.x() - x) * (p.x() - x) + (p.y() - y) * (p.y() - y)));
    if (!around.is_free(p, d))
      return;
    const Walk_end end = m_domain.walk(seen, start, p);
    if (end.is_blocked())
      return;
    const Direction v = m_lattice == Lattice_direction::KEEPS ? u : around.direction(p, d, u);
    proposals.list[proposals.size++] =
      Growth_proposal_2{around.misfit(p, d), from.key, p.x(), p.y(), d, v, end.triangle, i};
  }

  /// Whether another of the generation, one that came before, has about `p` among its six places: then it is
  /// the one to propose it.
  bool is_left_to_other(Index i, const Point& p, const Growth_limits_2& around) const
  {
    constexpr double tolerance = 0.15, least_cosine = 0.62; // of the distance; of six times the angle
    return around.any_of([&](Index j, double x, double y, double d_j) {
      if (j == no_index || !m_proposes[j] || !m_crystal.came_before(j, i))
        return false;
      const double dx = p.x() - x, dy = p.y() - y, distance = std::sqrt(dx * dx + dy * dy);
      if (std::abs(distance - d_j) > tolerance * d_j)
        return false;
      const Direction& u = m_crystal.direction(j);
      const double c = (dx * u.x + dy * u.y) / distance, cosine_3 = c * (4 * c * c - 3);
      return 2 * cosine_3 * cosine_3 - 1 > least_cosine;
    });
  }

  /// the triangle of `p` if the domain's edges do not hide it from bubble `i`, and it lies on none, else `no_index`
  Index visible_triangle(std::size_t i, const Point& p) const
  {
    const Index t = triangle_seen_from(i, p);
    return t != no_index && m_domain.is_on_edge(t, p) ? no_index : t;
  }

  Index triangle_seen_from(std::size_t i, const Point& p) const
  {
    const Index host = m_bubbles.host[i];
    if (m_bubbles.is_on_edge(i))
      return m_domain.walk_from_edge(host, m_bubbles.point(i), p);
    if (m_bubbles.is_in_face(i) || host == no_index) {
      const Index start = host != no_index ? host : m_domain.locate(m_bubbles.point(i), 0);
      if (start == no_index) // a pinned vertex on an edge, which rounding has put outside
        return no_index;
      const Walk_end end = m_domain.walk(start, m_bubbles.point(i), p);
      return end.is_blocked() ? no_index : end.triangle;
    }
    for (Index e : m_front.edges_of_corner(host)) {
      const Index triangle = m_domain.walk_from_edge(e, m_bubbles.point(i), p);
      if (triangle != no_index)
        return triangle;
    }
    return no_index;
  }

  const Team& m_team;
  const Threads m_threads;
  const Domain_2& m_domain;
  const Sizes_2& m_sizing;
  const Crystal_2& m_crystal;
  const Bubbles_2& m_bubbles;
  const Growth_front_2& m_front;
  const Lattice_direction m_lattice;
  std::vector<char> m_proposes; // whether a bubble is one of the generation
  std::vector<List> m_lists;    // of each of some of them
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_GROWTH_PROPOSALS_2_H
