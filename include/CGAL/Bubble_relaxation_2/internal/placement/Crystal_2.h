// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/Growth_limits_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// When a bubble of a crystal came in: with its generation, and in this in the order of its misfit and place.
struct Growth_birth_2
{
  std::int64_t generation;
  double misfit, x, y;

  bool operator<(const Growth_birth_2& b) const
  {
    return std::tie(generation, misfit, x, y) < std::tie(b.generation, b.misfit, b.x, b.y);
  }
};

/// Bubbles that form a lattice as they come: the direction of the lattice at each, and its links to those
/// around. Links are in the order in which bubbles came, so that sums over them do not depend on how they
/// were found.
class Crystal_2
{
public:
  using Links = boost::container::small_vector<Index, 10>;

  /// bubbles are looked at so many at a time
  static constexpr std::size_t grain = 64;

  /// Without links. `turns`: when the bubbles that are there propose; those with 0 do not
  Crystal_2(const Domain_2& domain, Bubbles_2& bubbles, std::vector<char> turns, const Threads& threads)
    : m_threads(threads), m_bubbles(bubbles), m_turns(std::move(turns)),
      m_buckets(link_reach, bubbles.size() == 0 ? 1. : bubbles.d[0], domain.bbox().xmin(), domain.bbox().ymin(),
                4 * bubbles.size())
  {
    m_direction.assign(bubbles.size(), Direction{1, 0});
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      tick(i);
      insert_in_buckets(i);
    }
  }

  /// makes room for `n` more bubbles
  void make_room_for(std::size_t n)
  {
    m_bubbles.make_room_for(n);
    internal::make_room_for(n, m_direction);
    m_links.reserve(m_bubbles.size() + n);
    m_buckets.make_room_for(n);
  }

  std::size_t size() const { return m_bubbles.size(); }
  const Bubbles_2& bubbles() const { return m_bubbles; }
  const Links& links(std::size_t i) const { return m_links[i]; }

  const Direction& direction(std::size_t i) const { return m_direction[i]; }
  Direction& direction(std::size_t i) { return m_direction[i]; }

  /// whether no bubble is in the way of one of size `d` at (x, y)
  bool is_free(double x, double y, double d) const
  {
    return m_buckets.is_free(x, y, d, Growth_limits_2::least_distance);
  }

  const Bubble_buckets_2& buckets() const { return m_buckets; }

  /// a bubble of a face comes in, without links
  void add(const Point& p, double d, Index triangle, const Direction& direction)
  {
    const std::size_t i = m_bubbles.size();
    m_bubbles.add(p, d, Bubbles_2::FACE, triangle);
    m_direction.push_back(direction);
    insert_in_buckets(i);
  }

  /// adds, without links, one that was there before, but was not known here
  void add_known(const Point& p, double d, Bubbles_2::Dimension dimension, Index host, const Direction& direction,
                 char turn)
  {
    add(p, d, host, direction);
    m_bubbles.dimension.back() = dimension;
    m_turns.resize(m_bubbles.size(), 0);
    m_turns.back() = turn;
  }

  /// when a bubble proposes that was there before; 0 for others
  char turn(std::size_t i) const { return i < m_turns.size() ? m_turns[i] : char(0); }

  /// makes room for the births of `n` bubbles, when none were told yet
  void make_room_for_births(std::size_t n) { m_births.reserve(n); }

  /// Tells when the next bubble of which this was not told yet came in; if of one, then of all. Without it they
  /// come in the order in which they are added.
  void add_birth(const Growth_birth_2& birth) { m_births.push_back(birth); }

  const Growth_birth_2& birth(std::size_t i) const { return m_births[i]; }

  bool came_before(Index i, Index j) const { return m_births.empty() ? i < j : m_births[i] < m_births[j]; }

  /// links the bubbles from `first` on, which were added last, to all around
  void link_from(std::size_t first)
  {
    m_links.resize(m_bubbles.size());
    parallel_for(
      m_threads, m_bubbles.size() - first, [this, first](std::size_t k) { find_links(first + k); }, grain);
    for (std::size_t i = first; i < m_bubbles.size(); ++i) {
      tick(i);
      for (Index j : m_links[i])
        if (static_cast<std::size_t>(j) < first)
          insert_link(m_links[j], static_cast<Index>(i));
    }
  }

  /// where a bubble settles among those that it is linked to
  Point settled(std::size_t i) const
  {
    return internal::settled(m_bubbles.point(i), m_bubbles.d[i], [&](const auto& add) {
      for (Index j : m_links[i])
        add(m_bubbles.x[j], m_bubbles.y[j], m_bubbles.d[j]);
    });
  }

  void set_point(std::size_t i, const Point& p)
  {
    m_bubbles.x[i] = p.x();
    m_bubbles.y[i] = p.y();
  }

  /// Gives a bubble that has settled its triangle and its size. One that an edge stands in the way of goes back
  /// to where it came in.
  void finish(const Domain_2& domain, const Sizes_2& sizing, std::size_t i)
  {
    const Point p = m_buckets.point(i), q = m_bubbles.point(i);
    const Walk_end end = domain.walk(m_bubbles.host[i], p, q);
    if (end.is_blocked()) {
      set_point(i, p);
      return;
    }
    m_bubbles.host[i] = end.triangle;
    m_bubbles.d[i] = sizing(q);
  }

  /// the bubbles from `first` on are found where they are now
  void find_again_from(std::size_t first)
  {
    for (std::size_t i = first; i < m_bubbles.size(); ++i)
      m_buckets.move(i, m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
  }

private:
  /// how far, in units of the mean size, bubbles are linked
  static constexpr double link_reach = 1.6;
  /// bubbles are not linked when one is this many times as large: it would have too many links
  static constexpr double largest_ratio = 4;

  void insert_in_buckets(std::size_t i)
  {
    m_buckets.insert(static_cast<Index>(i), m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
  }

  void find_links(std::size_t i)
  {
    const double d = m_bubbles.d[i];
    Links& links = m_links[i];
    m_buckets.for_each_near(m_bubbles.x[i], m_bubbles.y[i], d, [&](Index j, double, double d_j) {
      if (static_cast<std::size_t>(j) != i && d <= largest_ratio * d_j && d_j <= largest_ratio * d)
        links.push_back(j);
      return true;
    });
    std::sort(links.begin(), links.end(), [this](Index j, Index k) { return came_before(j, k); });
  }

  void insert_link(Links& links, Index i)
  {
    links.insert(std::upper_bound(links.begin(), links.end(), i,
                                  [this](Index j, Index k) { return came_before(j, k); }),
                 i);
  }

  const Threads m_threads;
  Bubbles_2& m_bubbles;
  std::vector<char> m_turns;
  std::vector<Direction> m_direction;
  std::vector<Links> m_links;
  std::vector<Growth_birth_2> m_births; // empty if bubbles lie in memory in the order in which they came
  Bubble_buckets_2 m_buckets;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_CRYSTAL_2_H
