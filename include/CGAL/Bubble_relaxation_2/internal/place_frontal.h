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

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Initial bubbles of the faces as a crystal that grows: each bubble proposes six neighbours at the
/// wanted distance, aligned with its own direction, first come first served. It starts from the
/// bubbles that are there, those of the edges aligned with their edge, those of the faces, if there are
/// any, in given directions.
template <class Sizing>
class Frontal_placement
{
public:
  Frontal_placement(const Domain_2& domain, const Sizing& sizing, Bubbles_2& bubbles)
    : m_domain(domain), m_sizing(sizing), m_bubbles(bubbles),
      m_buckets(least_distance, bubbles.d[0], domain.bbox().xmin(), domain.bbox().ymin(),
                4 * bubbles.size())
  {}

  /// `directions`: angles for the bubbles that are there; read for those in faces only
  void operator()(std::vector<double> directions = {})
  {
    for (std::size_t i = 0; i < m_bubbles.size(); ++i)
      m_buckets.insert(static_cast<Index>(i), m_bubbles.x[i], m_bubbles.y[i], m_bubbles.d[i]);
    const std::size_t number_of_seeds = m_bubbles.size();
    m_direction = std::move(directions);
    m_direction.resize(number_of_seeds, 0);
    find_edges_of_corners();
    for (std::size_t i = 0; i < number_of_seeds; ++i) {
      if (m_bubbles.is_on_edge(i))
        propose_neighbors(i, direction_of_edge(m_bubbles.place[i]));
      else if (m_bubbles.is_in_face(i) || m_bubbles.place[i] == no_index)
        propose_neighbors(i, m_direction[i]);
      else
        for (Index e : m_edges_of_corner[m_bubbles.place[i]])
          propose_neighbors(i, direction_of_edge(e));
    }
    for (std::size_t i = number_of_seeds; i < m_bubbles.size(); ++i)
      propose_neighbors(i, m_direction[i]);
  }

private:
  /// a candidate is accepted when no bubble is nearer than this, in units of the mean size
  static constexpr double least_distance = 0.8;

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
    Index triangle = visible_triangle(i, p);
    if (triangle == no_index || !is_free(p, m_bubbles.d[i]))
      return;
    const double wanted = 0.5 * (m_bubbles.d[i] + m_sizing(p));
    p = Point(x + wanted * ux, y + wanted * uy);
    triangle = visible_triangle(i, p);
    if (triangle == no_index)
      return;
    const double d = m_sizing(p);
    if (!is_free(p, d))
      return;
    m_buckets.insert(static_cast<Index>(m_bubbles.size()), p.x(), p.y(), d);
    m_bubbles.add(p, d, Bubbles_2::FACE, triangle);
    m_direction.push_back(angle);
  }

  bool is_free(const Point& p, double d) const
  {
    return m_buckets.for_each_near(p.x(), p.y(), d,
                                   [](Index, double, double) { return false; });
  }

  /// the triangle of `p` if the domain's edges do not hide it from bubble `i`, else `no_index`
  Index visible_triangle(std::size_t i, const Point& p) const
  {
    if (m_bubbles.is_in_face(i)) {
      const Walk_end end = m_domain.walk(m_bubbles.place[i], m_bubbles.point(i), p);
      return end.is_blocked() ? no_index : end.triangle;
    }
    if (m_bubbles.is_on_edge(i))
      return m_domain.walk_from_edge(m_bubbles.place[i], m_bubbles.point(i), p);
    if (m_bubbles.place[i] == no_index) {
      const Index start = m_domain.locate(m_bubbles.point(i), 0);
      const Walk_end end = m_domain.walk(start, m_bubbles.point(i), p);
      return end.is_blocked() ? no_index : end.triangle;
    }
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
  std::vector<double> m_direction;                   // of the lattice around each bubble
  std::vector<std::vector<Index>> m_edges_of_corner;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACE_FRONTAL_H
