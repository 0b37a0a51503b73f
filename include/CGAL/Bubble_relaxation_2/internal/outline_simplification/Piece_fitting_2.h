// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_FITTING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_FITTING_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/piece_cost.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Replaces a span by pieces between places on it, of the least cost: a shortest path over all pieces that stay within
/// the tolerance. Places are its vertices, some of them where they are many times denser than pieces will be, and parts
/// of long segments. A piece stays within the tolerance if all vertices of the span between its ends are near to it;
/// then every point of the span between them is, and every point of the piece is near to one of the span, which goes
/// from one end to the other.
class Piece_fitting_2
{
  static constexpr std::size_t small_ring = 200; // places on a ring, up to which other starts are tried
  // places are this far from each other, in units of d and of the span, where all vertices between are within this
  // share of the tolerance
  static constexpr double dense = 1. / 32, nearly_straight = 0.25;
  // where it is rough, up to twice as many places are within d/2 of one as were if they were this far from each other
  static constexpr std::size_t many = 16;
  // the pieces from a place take most of a kilobyte; from more places than these they are found again in each sweep
  static constexpr std::size_t most_places_with_pieces = 200000;

public:
  static constexpr int parts_of_size = 16; ///< places on long segments are this part of d apart

  Piece_fitting_2(const Outline_2& outline, const Outline_span_2& span, const Outline_demands_2& demands)
    : m_outline(outline), m_span(span), m_demands(demands)
  {
    double length = 0;
    for (std::size_t k = 0; k < span.size(); ++k)
      length += distance(point(k), point(k + 1));
    for (std::size_t k = 0; k < span.size();) {
      const std::size_t next = next_vertex(k, dense * length);
      if (next == k + 1)
        add_places(k);
      else
        m_places.push_back(place_at_vertex(k));
      k = next;
    }
    if (!span.is_ring)
      m_places.push_back(place_at_vertex(span.size()));
    for (std::size_t i = 0; i < m_places.size() && m_places.size() <= most_places_with_pieces; ++i)
      m_pieces.push_back(find_pieces(i));
  }

  /// how many places there are from the first to the last, or once around
  std::size_t number_of_steps() const { return m_span.is_ring ? m_places.size() : m_places.size() - 1; }

  /// The place at which pieces should begin. A ring has the choice: all around from somewhere, and then from the other
  /// side, where the first way has vertices that did not have to be there. Of a small ring more are tried.
  std::size_t best_start() const
  {
    if (!m_span.is_ring)
      return 0;
    const std::size_t n = m_places.size();
    std::vector<double> cost = costs_to_end(0);
    if (n > small_ring) {
      std::size_t place = 0;
      while (place < n / 2)
        place = ends_of_pieces(place, 0, cost).front();
      return costs_to_end(place % n).front() < cost.front() ? place % n : 0;
    }
    std::size_t best = 0;
    double least = cost.front();
    for (std::size_t k = 1; k < 8; ++k) {
      const double other = costs_to_end(k * n / 8).front();
      if (other < least) {
        least = other;
        best = k * n / 8;
      }
    }
    return best;
  }

  /// the least cost of a way from each place to the last, or from each place on once around; counted from `start`
  std::vector<double> costs_to_end(std::size_t start) const
  {
    const std::size_t n = m_places.size(), end = number_of_steps();
    std::vector<double> cost(end + 1, (std::numeric_limits<double>::infinity)());
    cost[end] = 0;
    for (std::size_t i = end; i-- > 0;)
      for (const Piece& piece : pieces_from((start + i) % n))
        if (i + piece.steps <= end)
          cost[i] = (std::min)(cost[i], piece.cost + cost[i + piece.steps]);
    return cost;
  }

  /// where pieces from a place end, those of the best ways first
  std::vector<std::size_t> ends_of_pieces(std::size_t place, std::size_t start,
                                          const std::vector<double>& cost_to_end) const
  {
    std::vector<std::pair<double, std::size_t>> ends;
    for (const Piece& piece : pieces_from(place % m_places.size())) {
      const std::size_t end = place + piece.steps;
      if (end - start < cost_to_end.size())
        ends.emplace_back(piece.cost + cost_to_end[end - start], end);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::size_t> result;
    for (const auto& e : ends)
      result.push_back(e.second);
    return result;
  }

  /// the vertex at a place; places of a ring after the end have later segments
  Fitted_vertex_2 vertex(std::size_t place) const
  {
    const std::size_t n = m_places.size();
    const Place& p = m_places[place % n];
    const Index turn = m_span.is_ring ? static_cast<Index>(place / n * m_span.size()) : 0;
    return {p.point, p.segment + turn, p.is_vertex ? m_span.vertices[p.segment] : no_index};
  }

  /// the vertices of the span between a place and the next one
  Fitted_path_2 vertices_after(std::size_t place) const
  {
    Fitted_path_2 result;
    for (Index m = vertex(place).segment + 1; m < end_between(place + 1); ++m)
      result.push_back({m_outline.points[m_span.vertex(m)], m, m_span.vertex(m)});
    return result;
  }

private:
  struct Place
  {
    Point point;
    Index segment;
    bool is_vertex; // the first end of its segment
    double size, tolerance;
  };

  struct Piece
  {
    std::size_t steps;
    double cost;
  };

  const Point& point(std::size_t k) const { return m_outline.points[m_span.vertices[k]]; }

  Place place_at_vertex(std::size_t k) const
  {
    const Index v = m_span.vertices[k];
    return {point(k), static_cast<Index>(k), true, m_demands.size[v], m_demands.tolerance[v]};
  }

  /// The vertex that is the next place: at once, or, where vertices are dense, the last one of those that are near, and
  /// between which the span is nearly straight. All vertices would be pairs as many as their square.
  std::size_t next_vertex(std::size_t k, double longest) const
  {
    const double reach = (std::min)(longest, dense * m_demands.size[m_span.vertices[k]]);
    std::size_t next = k + 1;
    while (next < m_span.size() && distance(point(k), point(next + 1)) <= reach &&
           is_straight(k, next + 1, nearly_straight))
      ++next;
    return next > k + 1 ? next : next_of_many(k, longest);
  }

  /// The same where the span is rough, though within the tolerance: of many vertices every one in so many is a place, if
  /// a piece can go there.
  std::size_t next_of_many(std::size_t k, double longest) const
  {
    const double reach = (std::min)(longest, 0.5 * m_demands.size[m_span.vertices[k]]);
    std::size_t end = k;
    while (end < m_span.size() && distance(point(k), point(end + 1)) <= reach)
      ++end;
    std::size_t next = (std::max)(k + 1, k + (end - k) / many);
    while (!is_straight(k, next, 1))
      --next;
    return next;
  }

  /// up to a share of the tolerance
  bool is_straight(std::size_t from, std::size_t to, double share) const
  {
    for (std::size_t m = from + 1; m < to; ++m)
      if (!(distance_to_segment(point(m), point(from), point(to)) <= share * m_demands.tolerance[m_span.vertices[m]]))
        return false;
    return true;
  }

  /// the number after that of the last vertex before a place
  Index end_between(std::size_t place) const
  {
    const Fitted_vertex_2 v = vertex(place);
    return v.vertex != no_index ? v.segment : v.segment + 1;
  }

  /// the first vertex of a segment, and equal parts of it; these are counted from the end that comes first in the order
  /// of vertices, so that they have the same bits from both sides
  void add_places(std::size_t k)
  {
    const Place a = place_at_vertex(k), b = place_at_vertex(k + 1);
    m_places.push_back(a);
    const double size = (std::min)(a.size, b.size);
    const int n = static_cast<int>((std::min)(1e6, std::ceil(parts_of_size * distance(a.point, b.point) / size)));
    const bool is_forward = m_span.vertices[k] < m_span.vertices[k + 1];
    const Point &from = is_forward ? a.point : b.point, &to = is_forward ? b.point : a.point;
    for (int i = 1; i < n; ++i) {
      const double t = static_cast<double>(i) / n, s = is_forward ? t : static_cast<double>(n - i) / n;
      m_places.push_back({Point(from.x() + s * (to.x() - from.x()), from.y() + s * (to.y() - from.y())),
                          static_cast<Index>(k), false, a.size + t * (b.size - a.size),
                          (std::min)(a.tolerance, b.tolerance)});
    }
  }

  std::vector<Piece> pieces_from(std::size_t i) const { return m_pieces.empty() ? find_pieces(i) : m_pieces[i]; }

  std::vector<Piece> find_pieces(std::size_t i) const
  {
    std::vector<Piece> pieces;
    const std::size_t n = m_places.size(), last = m_span.is_ring ? i + n - 1 : n - 1;
    const Place& p = m_places[i];
    for (std::size_t j = i + 1; j <= last; ++j) {
      const Place& q = m_places[j % n];
      const double length = distance(p.point, q.point), size = 0.5 * (p.size + q.size);
      if (length > longest_piece * size + p.tolerance && j > i + 1)
        break; // no later piece is near to here
      double deviation = 0;
      if (length > 0 && (j == i + 1 || length <= longest_piece * size) && is_near(i, j, deviation))
        pieces.push_back({j - i, piece_cost(length / size, deviation)});
    }
    return pieces;
  }

  /// whether the vertices between two places are within their tolerances of the segment between these
  bool is_near(std::size_t i, std::size_t j, double& deviation) const
  {
    const Point &a = m_places[i].point, &b = m_places[j % m_places.size()].point;
    for (Index m = end_between(j); --m > m_places[i].segment;) {
      const Index v = m_span.vertex(m);
      const double off = distance_to_segment(m_outline.points[v], a, b) / m_demands.tolerance[v];
      if (!(off <= 1))
        return false;
      deviation = (std::max)(deviation, off);
    }
    return true;
  }

  const Outline_2& m_outline;
  const Outline_span_2& m_span;
  const Outline_demands_2& m_demands;
  std::vector<Place> m_places;
  std::vector<std::vector<Piece>> m_pieces; // from each place; empty if there are too many
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_FITTING_2_H
