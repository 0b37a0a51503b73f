// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Initial bubbles of the faces as a crystal that grows: each bubble proposes six neighbours at the
/// wanted distance, aligned with its own direction. It starts from the bubbles that are there, those of
/// the edges aligned with their edge, those of the faces, if there are any, in given directions.
///
/// Who proposes first matters where d changes. A crystal that grows from fine to coarse loses rows
/// where it must; one that grows from coarse to fine has no room for new ones and tears. So the smallest
/// bubble is always the next, but where d falls away from the start the front goes on in rows: a bubble
/// counts as no smaller than the one that proposed it.
template <class Sizing>
class Frontal_placement
{
public:
  Frontal_placement(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles)
    : m_domain(domain), m_sizing(sizing), m_bubbles(bubbles),
      m_buckets(search_distance, bubbles.d[0], domain.bbox().xmin(), domain.bbox().ymin(),
                4 * bubbles.size())
  {}

  /// `directions`: angles for the bubbles that are there; read for those in faces only
  void operator()(std::vector<double> directions = {})
  {
    m_direction = std::move(directions);
    m_direction.resize(m_bubbles.size(), 0);
    m_start.resize(m_bubbles.size(), no_index);
    find_edges_of_corners();
    for (std::size_t i = 0; i < m_bubbles.size(); ++i) {
      m_buckets.insert(static_cast<Index>(i), m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
      m_front.emplace(m_bubbles.d[i], i);
      if (m_bubbles.is_in_face(i))
        m_start[i] = m_bubbles.place[i];
      else if (m_bubbles.place[i] == no_index)
        m_start[i] = m_domain.locate(m_bubbles.point(i), 0);
    }
    while (!m_front.empty()) {
      const Front_bubble next = m_front.top();
      m_front.pop();
      grow_from(next);
    }
  }

private:
  using Front_bubble = std::pair<double, std::size_t>; // how small it counts, index

  /// a candidate is accepted when no bubble is nearer than this, in units of the mean size
  static constexpr double least_distance = 0.8;
  /// bubbles nearer than this are its neighbours
  static constexpr double largest_distance = 1.3;
  /// how far from the first guess of its place they are looked for
  static constexpr double search_distance = 1.6;

  void find_edges_of_corners()
  {
    m_edges_of_corner.resize(m_domain.corners().size());
    for (std::size_t e = 0; e < m_domain.edges().size(); ++e) {
      m_edges_of_corner[m_domain.edges()[e].source].push_back(static_cast<Index>(e));
      m_edges_of_corner[m_domain.edges()[e].target].push_back(static_cast<Index>(e));
    }
  }

  double direction_of_edge(Index e) const
  {
    const Point &a = m_domain.source(e), &b = m_domain.target(e);
    return std::atan2(b.y() - a.y(), b.x() - a.x());
  }

  void grow_from(const Front_bubble& next)
  {
    const std::size_t i = next.second, before = m_bubbles.size();
    if (m_bubbles.is_on_edge(i))
      propose_neighbors(i, direction_of_edge(m_bubbles.place[i]));
    else if (m_start[i] != no_index)
      propose_neighbors(i, m_direction[i]);
    else if (m_bubbles.place[i] != no_index)
      for (Index e : m_edges_of_corner[m_bubbles.place[i]])
        propose_neighbors(i, direction_of_edge(e));
    for (std::size_t j = before; j < m_bubbles.size(); ++j)
      m_front.emplace((std::max)(next.first, m_bubbles.d[j]), j);
  }

  void propose_neighbors(std::size_t i, double direction)
  {
    constexpr double sixty_degrees = 1.0471975511965977462;
    for (int k = 0; k < 6; ++k)
      propose(i, direction + k * sixty_degrees);
  }

  void propose(std::size_t i, double angle)
  {
    const double ux = std::cos(angle), uy = std::sin(angle), x = m_bubbles.x[i], y = m_bubbles.y[i];
    Point p(x + m_bubbles.d[i] * ux, y + m_bubbles.d[i] * uy);
    if (!find_neighbors(p, m_bubbles.d[i]) || visible_triangle(i, p) == no_index)
      return;
    const double d_i = m_bubbles.d[i], ahead = m_sizing(p), wanted = 0.5 * (d_i + ahead);
    const double at_wanted = d_i + (ahead - d_i) * wanted / d_i; // linear between the two
    p = settle(Point(x + wanted * ux, y + wanted * uy), at_wanted);
    const Index triangle = visible_triangle(i, p);
    if (triangle == no_index)
      return;
    const double d = m_sizing(p);
    if (!is_free(p, d))
      return;
    m_buckets.insert(static_cast<Index>(m_bubbles.size()), p.x(), p.y(), d);
    m_bubbles.add(p, d, Bubbles_2::FACE, triangle);
    m_direction.push_back(angle);
    m_start.push_back(triangle);
  }

  /// finds the bubbles around a candidate; returns whether none is too near
  bool find_neighbors(const Point& p, double d)
  {
    m_near.clear();
    return m_buckets.for_each_near(p.x(), p.y(), d, [&](Index j, double squared, double d_j) {
      const double reach = 0.5 * least_distance * (d + d_j);
      m_near.push_back(j);
      return squared >= reach * reach;
    });
  }

  bool is_free(const Point& p, double d) const
  {
    return std::none_of(m_near.begin(), m_near.end(), [&](Index j) {
      const double reach = 0.5 * least_distance * (d + m_bubbles.d[j]);
      return CGAL::squared_distance(p, m_bubbles.point(j)) < reach * reach;
    });
  }

  /// The place of a candidate among all its neighbours, not only at the right distance from the one that
  /// proposed it: a few steps of Newton's method for springs between them.
  Point settle(const Point& p, double d) const
  {
    constexpr int steps = 3;
    double x = p.x(), y = p.y();
    for (int k = 0; k < steps; ++k) {
      double sum_x = 0, sum_y = 0, number = 0;
      for (Index j : m_near) {
        const double dx = x - m_bubbles.x[j], dy = y - m_bubbles.y[j];
        const double distance = std::sqrt(dx * dx + dy * dy), wanted = 0.5 * (d + m_bubbles.d[j]);
        if (distance == 0 || distance > largest_distance * wanted)
          continue;
        number += 1;
        sum_x += (wanted - distance) * dx / distance;
        sum_y += (wanted - distance) * dy / distance;
      }
      // springs in all directions are half as stiff as in one
      const double compliance = 1 / (std::max)(1., 0.5 * number);
      x += compliance * sum_x;
      y += compliance * sum_y;
    }
    return Point(x, y);
  }

  /// the triangle of `p` if the domain's edges do not hide it from bubble `i`, else `no_index`
  Index visible_triangle(std::size_t i, const Point& p) const
  {
    if (m_start[i] != no_index) {
      const Walk_end end = m_domain.walk(m_start[i], m_bubbles.point(i), p);
      return end.is_blocked() ? no_index : end.triangle;
    }
    if (m_bubbles.is_on_edge(i))
      return m_domain.walk_from_edge(m_bubbles.place[i], m_bubbles.point(i), p);
    for (Index e : m_edges_of_corner[m_bubbles.place[i]]) {
      const Index triangle = m_domain.walk_from_edge(e, m_bubbles.point(i), p);
      if (triangle != no_index)
        return triangle;
    }
    return no_index;
  }

  const Domain_2& m_domain;
  const Sizing& m_sizing;
  Bubbles_2& m_bubbles;
  Bubble_buckets_2 m_buckets;
  std::priority_queue<Front_bubble, std::vector<Front_bubble>, std::greater<Front_bubble>> m_front;
  std::vector<double> m_direction;                   // of the lattice around each bubble
  std::vector<Index> m_start;                        // the triangle of those off the domain's edges
  std::vector<std::vector<Index>> m_edges_of_corner;
  std::vector<Index> m_near;                         // the bubbles around the last candidate
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H
