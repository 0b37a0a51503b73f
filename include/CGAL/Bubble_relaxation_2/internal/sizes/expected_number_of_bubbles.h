// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_EXPECTED_NUMBER_OF_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_EXPECTED_NUMBER_OF_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace CGAL::Bubble_relaxation_2::internal {

/// How many bubbles the domain and the sizing field ask for: on the corners, on the edges by the integral
/// of 1/d, in the faces by the integral of 2 / (sqrt(3) d^2), the density of the hexagonal lattice.
class Expected_number_of_bubbles
{
public:
  /// `limit`: sums are not followed beyond it
  Expected_number_of_bubbles(const Domain_2& domain, const Sizes_2& sizing, double limit)
    : m_domain(domain), m_sizing(sizing), m_limit(limit),
      m_coarsest((std::max)(domain.bbox().x_span(), domain.bbox().y_span()) / 16)
  {}

  double operator()()
  {
    double on_edges = 0, cells_of_edges = 0, on_boundary = 0;
    for (std::size_t e = 0; e < m_domain.edges().size() && on_edges <= m_limit; ++e) {
      const double integral = integral_over_edge(static_cast<Index>(e)), between_ends = (std::max)(0., integral - 1);
      const Domain_edge_2& edge = m_domain.edges()[e];
      on_boundary += edge.inside_left && edge.inside_right ? 0 : integral;
      on_edges += between_ends;
      cells_of_edges += 0.5 * between_ends * (edge.inside_left + edge.inside_right);
    }
    const double in_edges = static_cast<double>(m_domain.corners().size()) + on_edges;
    if (on_edges > m_limit) // triangles of a needle would be cut as often as its edges, and have next to no area
      return in_edges;
    const double in_area = integral_over_faces();
    m_without_corners = in_area + 0.5 * on_boundary + 1; // as Pick counts the points of a lattice in a polygon
    // the area around a bubble on an edge, on the sides that belong to the domain, is taken
    return in_edges + (std::max)(0., in_area - cells_of_edges);
  }

  /// how many the sizing field alone asks for, as if edges need not end at corners; known after the call above
  double without_corners() const { return m_without_corners; }

  /// the integral of the density over the domain
  double integral_over_faces()
  {
    m_sum = 0;
    const Flat_triangulation_2& tr = m_domain.triangulation();
    for (Index t = 0; static_cast<std::size_t>(t) < tr.number_of_triangles(); ++t)
      if (m_domain.is_inside(t))
        add(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2), 0);
    return m_sum;
  }

  /// the same, roughly, from some thousand places, whatever the limit
  double rough_integral_over_faces() const
  {
    double sum = 0;
    const Flat_triangulation_2& tr = m_domain.triangulation();
    for (Index t = 0; static_cast<std::size_t>(t) < tr.number_of_triangles(); ++t)
      if (m_domain.is_inside(t))
        add_roughly(tr.point(t, 0), tr.point(t, 1), tr.point(t, 2), 0, sum);
    return sum;
  }

  /// the integral of 1/d along an edge
  double integral_over_edge(Index e)
  {
    m_sum = 0;
    if (m_domain.edges()[e].takes_bubbles())
      add(m_domain.source(e), m_domain.target(e), 0);
    return m_sum;
  }

private:
  static constexpr int deepest = 48;

  void add(const Point& p, const Point& q, const Point& r, int depth)
  {
    if (m_sum > m_limit)
      return;
    const double d = m_sizing(CGAL::centroid(p, q, r)), longest = longest_side(p, q, r), area = area_of(p, q, r);
    const double number = number_in(area, d);
    // the parts of a needle are needles: without an end for those that are thinner than 1e-6 d there would be millions
    if (longest <= 4 * d || number < 1e-6 || depth == deepest) {
      m_sum += number;
      return;
    }
    if (longest <= m_coarsest && is_smooth(p, q, r, d)) {
      m_sum += 2 / std::sqrt(3.) * area * m_mean_density;
      return;
    }
    in_halves(p, q, r, [&](const Point& u, const Point& v, const Point& w) { add(u, v, w, depth + 1); });
  }

  /// Parts are halved by area, so needles are asked for once.
  void add_roughly(const Point& p, const Point& q, const Point& r, int depth, double& sum) const
  {
    constexpr int most = 12; // halvings of the box; where coordinates are coarse parts get no smaller
    const double area = area_of(p, q, r);
    if (area > m_coarsest * m_coarsest / 16 && depth < most)
      in_halves(p, q, r, [&](const Point& u, const Point& v, const Point& w) { add_roughly(u, v, w, depth + 1, sum); });
    else
      sum += number_in(area, m_sizing(CGAL::centroid(p, q, r)));
  }

  /// of the hexagonal lattice
  static double number_in(double area, double d) { return 2 / std::sqrt(3.) * area / (d * d); }

  static double area_of(const Point& p, const Point& q, const Point& r)
  {
    return 0.5 * std::abs((q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
  }

  static double longest_side(const Point& p, const Point& q, const Point& r)
  {
    return std::sqrt(
      (std::max)({CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
  }

  /// calls `visit` with both parts of a triangle, cut at its longest side, so that parts get no thinner
  template <class Visitor>
  static void in_halves(const Point& p, const Point& q, const Point& r, const Visitor& visit)
  {
    const double pq = CGAL::squared_distance(p, q), qr = CGAL::squared_distance(q, r),
                 rp = CGAL::squared_distance(r, p);
    const auto cut = [&visit](const Point& u, const Point& v, const Point& w) {
      const Point m = CGAL::midpoint(u, v);
      visit(u, m, w);
      visit(m, v, w);
    };
    if (pq >= qr && pq >= rp)
      cut(p, q, r);
    else if (qr >= rp)
      cut(q, r, p);
    else
      cut(r, p, q);
  }

  void add(const Point& p, const Point& q, int depth)
  {
    if (m_sum > m_limit)
      return;
    const Point m = CGAL::midpoint(p, q);
    const double d = m_sizing(m), length = std::sqrt(CGAL::squared_distance(p, q));
    if (length <= 2 * d || depth == deepest ||
        (length <= m_coarsest && is_near(p, d) && is_near(q, d))) {
      m_sum += length / d;
      return;
    }
    add(p, m, depth + 1);
    add(m, q, depth + 1);
  }

  /// whether d changes little from the centre of a triangle to the middles of its sides; then their mean
  /// of 1/d^2 is that of the triangle, to third order
  bool is_smooth(const Point& p, const Point& q, const Point& r, double d)
  {
    constexpr double little = 0.15;
    double sum = 0;
    for (const Point& m : {CGAL::midpoint(p, q), CGAL::midpoint(q, r), CGAL::midpoint(r, p)}) {
      const double d_m = m_sizing(m);
      if (!(std::abs(d_m - d) <= little * d))
        return false;
      sum += 1 / (d_m * d_m);
    }
    m_mean_density = sum / 3;
    return true;
  }

  bool is_near(const Point& p, double d) const { return std::abs(m_sizing(p) - d) <= 0.05 * d; }

  const Domain_2& m_domain;
  const Sizes_2& m_sizing;
  double m_limit, m_coarsest;
  double m_sum = 0, m_without_corners = 0;
  double m_mean_density = 0; // of the last smooth triangle
};

/// `count`: what ended when it had found `expected`
[[noreturn]] inline void throw_too_many_bubbles(std::size_t maximum, const char* asking, double expected,
                                                const Expected_number_of_bubbles& count)
{
  std::ostringstream message;
  message.imbue(std::locale::classic());
  message << "Bubble_relaxation_2: parameter maximum_number_of_bubbles = " << maximum << ": " << asking
          << " ask for more, at least " << std::ceil(expected);
  if (const double all = count.rough_integral_over_faces(); all > 2 * expected)
    message << ", about " << std::setprecision(2) << all;
  throw std::length_error(message.str());
}

constexpr const char* sizes_and_outline = "the sizing function and the fine parts of the outline (limit_by_outline)";

/// \throws std::length_error if sizes that are limited by the outline ask for too many bubbles on edges alone
inline void count_bubbles_on_edges(const Domain_2& domain, std::size_t maximum, const Sizes_2& sizes)
{
  const double most = static_cast<double>(maximum);
  Expected_number_of_bubbles count(domain, sizes, most);
  double sum = 0;
  for (std::size_t e = 0; e < domain.edges().size() && sum <= most; ++e)
    sum += count.integral_over_edge(static_cast<Index>(e));
  if (sum > most)
    throw_too_many_bubbles(maximum, sizes_and_outline, sum, count);
}

/// Counts how many bubbles sizes ask for in the domain: that costs calls of d, so it is done once. `asking`: what asks
/// for them, in words for the user
/// \throws std::length_error if they are more than the user wants to have
inline void count_bubbles(const Domain_2& domain, std::size_t maximum, const char* asking, Sizes_2& sizes)
{
  Expected_number_of_bubbles count(domain, sizes, static_cast<double>(maximum));
  const double expected = count();
  if (expected > static_cast<double>(maximum))
    throw_too_many_bubbles(maximum, asking, expected, count);
  sizes.expected_number = expected;
  sizes.number_without_corners = count.without_corners();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_EXPECTED_NUMBER_OF_BUBBLES_H
