// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Growth_front_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Surroundings_2.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// How the lattice turns as a crystal grows.
enum class Lattice_direction
{
  BENDS, ///< with its neighbours: rows follow the boundary, and the lines along which d grows
  KEEPS  ///< not at all
};

/// Fills the domain's faces with bubbles as a crystal grows: each bubble of the front proposes six
/// neighbours at the wanted distance, aligned with the lattice around it.
///
/// Who proposes first matters where d changes. A crystal that grows from fine to coarse loses rows where
/// it must; one that grows from coarse to fine has no room for new ones and tears. So the smallest bubble
/// is the next, but where d falls away from the start the front goes on in rows: a bubble counts as no
/// smaller than the one that proposed it.
///
/// The crystal grows by generations: all of about the smallest size propose at once, by what was there
/// before; of proposals for one place the one that fits best is accepted; then the new bubbles settle
/// among each other. Nothing depends on an order within a generation, so threads change no bit.
template <class Concurrency_tag, class Sizing>
class Crystal_growth_2
{
public:
  Crystal_growth_2(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles,
                   Lattice_direction lattice)
    : m_domain(domain), m_sizing(sizing), m_bubbles(bubbles), m_lattice(lattice), m_front(domain),
      m_buckets(link_reach, bubbles.d[0], domain.bbox().xmin(), domain.bbox().ymin(),
                4 * bubbles.size())
  {
    m_direction.assign(bubbles.size(), Direction{1, 0});
    m_proposes.assign(bubbles.size(), 0);
    for (std::size_t i = 0; i < bubbles.size(); ++i)
      insert_in_buckets(i);
    link_from(0);
  }

  void set_direction(std::size_t i, const Direction& u) { m_direction[i] = u; }

  /// one of the bubbles that were there before belongs to the front when the growth begins
  void add_to_front(std::size_t i) { m_front.add(m_bubbles, i, m_bubbles.d[i], m_direction[i]); }

  /// grows until there is no front left
  void operator()()
  {
    while (!m_front.empty()) {
      take_generation();
      parallel_for<Concurrency_tag>(
        m_generation.size(), [this](std::size_t k) { propose_from(k); }, grain);
      for (const Proposer& p : m_generation)
        m_proposes[p.index] = 0;
      const std::size_t first = m_bubbles.size();
      accept_proposals();
      link_from(first);
      settle_from(first);
      for (std::size_t i = first; i < m_bubbles.size(); ++i)
        m_front.add(m_bubbles, i, (std::max)(m_keys[i - first], m_bubbles.d[i]), m_direction[i]);
    }
  }

private:
  struct Proposal
  {
    double key, misfit;
    Point p;
    double d;
    Index triangle;
    Direction direction;
  };

  struct Proposals
  {
    std::array<Proposal, 6> list;
    int size;
  };

  /// a proposal, and what it is sorted by
  struct Candidate
  {
    double misfit;
    const Proposal* proposal;
  };

  using Links = boost::container::small_vector<Index, 10>;

  /// how far, in units of the mean size, bubbles are linked
  static constexpr double link_reach = 1.6;
  /// how far the neighbours of a proposal are looked for
  static constexpr double surroundings_reach = 1.7;
  /// bubbles are not linked when one is this many times as large: it would have too many links
  static constexpr double largest_ratio = 4;
  static constexpr int proposal_steps = 3;
  static constexpr int settling_rounds = 3;
  static constexpr std::size_t grain = 64;

  void insert_in_buckets(std::size_t i)
  {
    m_buckets.insert(static_cast<Index>(i), m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
  }

  void take_generation()
  {
    m_front.take_generation(m_generation);
    for (const Proposer& p : m_generation)
      m_proposes[p.index] = !m_bubbles.is_corner(p.index);
    if (m_proposals.size() < m_generation.size())
      m_proposals.resize(m_generation.size());
  }

  void propose_from(std::size_t k)
  {
    const Proposer& from = m_generation[k];
    m_proposals[k].size = 0;
    const unsigned taken = taken_places(from);
    Direction u = from.direction;
    for (int turn = 0; turn < 6; ++turn, u = turned(u))
      if ((taken >> turn & 1) == 0)
        propose(from, u, m_proposals[k]);
  }

  /// a bit for each of the six places around a bubble: whether one that is linked to it takes it
  unsigned taken_places(const Proposer& from) const
  {
    const Index i = from.index;
    const double d = m_bubbles.d[i];
    const Direction u = from.direction, v = turned(u), w = turned(v);
    unsigned taken = 0;
    for (Index j : m_links[i]) {
      const double x = m_bubbles.x[j] - m_bubbles.x[i], y = m_bubbles.y[j] - m_bubbles.y[i];
      const double reach = 0.5 * Surroundings_2::least_distance * (d + m_bubbles.d[j]);
      // by the law of cosines; opposite places differ in a sign
      const double least = (x * x + y * y + d * d - reach * reach) / (2 * d);
      const double a = x * u.x + y * u.y, b = x * v.x + y * v.y, c = x * w.x + y * w.y;
      taken |= unsigned(a > least) | unsigned(b > least) << 1 | unsigned(c > least) << 2 |
               unsigned(-a > least) << 3 | unsigned(-b > least) << 4 | unsigned(-c > least) << 5;
    }
    return taken;
  }

  /// the bubbles around `p` that are linked to `i`, or to one of these, and other proposals of `i`
  Surroundings_2 surroundings(Index i, const Point& p, const Proposals& proposals) const
  {
    Surroundings_2 result;
    const double d = m_bubbles.d[i];
    result.add_if_near(i, m_bubbles, p, d, surroundings_reach);
    for (Index j : m_links[i])
      result.add_if_near(j, m_bubbles, p, d, surroundings_reach);
    for (std::size_t k = 1, n = result.size(); k < n; ++k)
      for (Index l : m_links[result.index(k)])
        if (!result.has(l))
          result.add_if_near(l, m_bubbles, p, d, surroundings_reach);
    for (int k = 0; k < proposals.size; ++k)
      result.add(proposals.list[k].p, proposals.list[k].d);
    return result;
  }

  /// tests by their cost: most places are taken
  void propose(const Proposer& from, const Direction& u, Proposals& proposals)
  {
    const Index i = from.index;
    const double x = m_bubbles.x[i], y = m_bubbles.y[i], d_i = m_bubbles.d[i];
    const Point start(x + d_i * u.x, y + d_i * u.y);
    const Surroundings_2 around = surroundings(i, start, proposals);
    if (!around.is_free(start, d_i) || is_left_to_other(i, start, around))
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
      Proposal{from.key, around.misfit(p, d), p, d, end.triangle, v};
  }

  /// Whether another of the generation, an earlier one, has about `p` among its six places: then it is
  /// the one to propose it.
  bool is_left_to_other(Index i, const Point& p, const Surroundings_2& around) const
  {
    constexpr double tolerance = 0.15, least_cosine = 0.62; // of the distance; of six times the angle
    return around.any_of([&](Index j, double x, double y, double d_j) {
      if (j == no_index || j >= i || !m_proposes[j])
        return false;
      const double dx = p.x() - x, dy = p.y() - y, distance = std::sqrt(dx * dx + dy * dy);
      if (std::abs(distance - d_j) > tolerance * d_j)
        return false;
      const Direction& u = m_direction[j];
      const double c = (dx * u.x + dy * u.y) / distance, cosine_3 = c * (4 * c * c - 3);
      return 2 * cosine_3 * cosine_3 - 1 > least_cosine;
    });
  }

  /// makes bubbles of the proposals, those that fit best first, as far as there is room
  void accept_proposals()
  {
    m_sorted.clear();
    for (std::size_t k = 0; k < m_generation.size(); ++k)
      for (int l = 0; l < m_proposals[k].size; ++l)
        m_sorted.push_back(Candidate{m_proposals[k].list[l].misfit, &m_proposals[k].list[l]});
    std::sort(m_sorted.begin(), m_sorted.end(), [](const Candidate& a, const Candidate& b) {
      return a.misfit < b.misfit || (a.misfit == b.misfit && a.proposal->p < b.proposal->p);
    });
    m_keys.clear();
    for (const Candidate& c : m_sorted) {
      const Point& p = c.proposal->p;
      if (m_buckets.is_free(p.x(), p.y(), c.proposal->d, Surroundings_2::least_distance))
        accept(*c.proposal);
    }
  }

  void accept(const Proposal& a)
  {
    const std::size_t i = m_bubbles.size();
    m_bubbles.add(a.p, a.d, Bubbles_2::FACE, a.triangle);
    m_direction.push_back(a.direction);
    m_proposes.push_back(0);
    m_keys.push_back(a.key);
    insert_in_buckets(i);
  }

  /// links the bubbles from `first` on to all around
  void link_from(std::size_t first)
  {
    m_links.resize(m_bubbles.size());
    parallel_for<Concurrency_tag>(
      m_bubbles.size() - first, [this, first](std::size_t k) { find_links(first + k); }, grain);
    for (std::size_t i = first; i < m_bubbles.size(); ++i)
      for (Index j : m_links[i])
        if (static_cast<std::size_t>(j) < first)
          m_links[j].push_back(static_cast<Index>(i));
  }

  void find_links(std::size_t i)
  {
    const double d = m_bubbles.d[i];
    m_buckets.for_each_near(m_bubbles.x[i], m_bubbles.y[i], d, [&](Index j, double, double d_j) {
      if (static_cast<std::size_t>(j) != i && d <= largest_ratio * d_j && d_j <= largest_ratio * d)
        m_links[i].push_back(j);
      return true;
    });
  }

  /// the bubbles from `first` on settle among each other
  void settle_from(std::size_t first)
  {
    const std::size_t n = m_bubbles.size() - first;
    m_settled.resize((std::max)(m_settled.size(), n));
    for (int round = 0; round < settling_rounds; ++round) {
      parallel_for<Concurrency_tag>(
        n,
        [this, first](std::size_t k) {
          const std::size_t i = first + k;
          m_settled[k] = settled(m_bubbles, i, m_links[i]);
        },
        grain);
      parallel_for<Concurrency_tag>(
        n, [this, first](std::size_t k) { set_point(first + k, m_settled[k]); }, grain);
    }
    parallel_for<Concurrency_tag>(
      n, [this, first](std::size_t k) { finish(first + k); }, grain);
    for (std::size_t i = first; i < m_bubbles.size(); ++i)
      m_buckets.move(i, m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
  }

  void set_point(std::size_t i, const Point& p)
  {
    m_bubbles.x[i] = p.x();
    m_bubbles.y[i] = p.y();
  }

  /// the triangle and the size of a bubble that has settled; one that an edge stands in the way of goes
  /// back to where it was accepted
  void finish(std::size_t i)
  {
    const Point p = m_buckets.point(i), q = m_bubbles.point(i);
    const Walk_end end = m_domain.walk(m_bubbles.place[i], p, q);
    if (end.is_blocked()) {
      set_point(i, p);
      return;
    }
    m_bubbles.place[i] = end.triangle;
    m_bubbles.d[i] = m_sizing(q);
  }

  /// the triangle of `p` if the domain's edges do not hide it from bubble `i`, else `no_index`
  Index visible_triangle(std::size_t i, const Point& p) const
  {
    const Index place = m_bubbles.place[i];
    if (m_bubbles.is_on_edge(i))
      return m_domain.walk_from_edge(place, m_bubbles.point(i), p);
    if (m_bubbles.is_in_face(i) || place == no_index) {
      const Index start = place != no_index ? place : m_domain.locate(m_bubbles.point(i), 0);
      const Walk_end end = m_domain.walk(start, m_bubbles.point(i), p);
      return end.is_blocked() ? no_index : end.triangle;
    }
    for (Index e : m_front.edges_of_corner(place)) {
      const Index triangle = m_domain.walk_from_edge(e, m_bubbles.point(i), p);
      if (triangle != no_index)
        return triangle;
    }
    return no_index;
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
  Bubbles_2& m_bubbles;
  const Lattice_direction m_lattice;
  Growth_front_2 m_front;
  Bubble_buckets_2 m_buckets;
  std::vector<Direction> m_direction;                // of the lattice around each bubble
  std::vector<char> m_proposes;                      // whether it is one of the generation
  std::vector<Links> m_links;                        // to bubbles around, of each
  // of the present generation
  std::vector<Proposer> m_generation;
  std::vector<Proposals> m_proposals;                // of each proposer
  std::vector<Candidate> m_sorted;
  std::vector<double> m_keys;                        // of the proposers of the new bubbles
  std::vector<Point> m_settled;                      // the new bubbles' places
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CRYSTAL_GROWTH_2_H
