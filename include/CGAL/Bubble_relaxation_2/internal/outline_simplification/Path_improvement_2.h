// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PATH_IMPROVEMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PATH_IMPROVEMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Movable_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/piece_cost.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Moves the vertices of a path within the tolerance, off the old outline too, and drops some, where pieces are short,
/// corners are such that no good triangles fit, or the domain is narrow: a small island grows, and a channel widens, as
/// far as that is allowed. Long straight walls stay as they are.
class Path_improvement_2
{
  static constexpr double good_enough = 0.2, least_gain = 0.01; // costs
  static constexpr double quality_weight = 5; // vertices that are as bad as a triangle with q = 0
  static constexpr double deviation_weight = 0.1;  // less than where pieces are chosen: only what costs something moves
  static constexpr double clear = 0.8; // what is farther away than this part of d does not count
  static constexpr int halvings = 3, moves_of_a_vertex = 4;

public:
  /// \param is_wall of each segment of the outline
  /// \param path of the span; \param ids of its pieces in the movable outline
  Path_improvement_2(const Outline_2& outline, const Outline_span_2& span, const Outline_demands_2& demands,
                     const std::vector<char>& is_wall, Movable_outline_2& movable, Fitted_path_2& path,
                     std::vector<Index>& ids)
    : m_outline(outline), m_span(span), m_demands(demands), m_movable(movable), m_path(path), m_ids(ids),
      m_is_wall(is_wall)
  {}

  /// one sweep; returns whether something changed
  bool operator()()
  {
    bool has_changed = false;
    for (std::size_t k = m_span.is_ring ? 0 : 1; k + 1 < m_path.size(); ++k) {
      if (m_path[k].is_settled || is_on_wall(m_path[k]))
        continue;
      look_around(k);
      const bool is_done = cost(k) < good_enough || !(drop(k) || move(k));
      m_path[k].is_settled = is_done; // or the vertex that has come into its place
      if (is_done)
        continue;
      has_changed = true;
      unsettle(piece_before(k));
      unsettle(k + 1);
    }
    return has_changed;
  }

private:
  bool is_on_wall(const Fitted_vertex_2& v) const
  {
    const auto is_wall = [this](Index segment) { return m_is_wall[m_span.segments[m_span.place(segment)]] != 0; };
    return is_wall(v.segment) && (v.point != old_point(v.segment) || is_wall(v.segment - 1));
  }

  void unsettle(std::size_t k)
  {
    if (k < m_path.size())
      m_path[k].is_settled = false;
    if (m_span.is_ring && k + 1 >= m_path.size()) // the last vertex is the first one
      m_path.front().is_settled = false;
  }

  std::size_t number_of_pieces() const { return m_ids.size(); }

  // a vertex and its neighbours; a ring's last vertex is its first one
  std::size_t piece_before(std::size_t k) const { return k == 0 ? number_of_pieces() - 1 : k - 1; }
  const Fitted_vertex_2& previous(std::size_t k) const { return m_path[piece_before(k)]; }
  const Fitted_vertex_2& next(std::size_t k) const { return m_path[k + 1]; }

  /// those beside the neighbours; none where the path ends with a neighbour
  const Point* before_previous(std::size_t k) const
  {
    const std::size_t n = number_of_pieces();
    return m_span.is_ring ? &m_path[(k + n - 2) % n].point : k > 1 ? &m_path[k - 2].point : nullptr;
  }

  const Point* after_next(std::size_t k) const
  {
    return m_span.is_ring            ? &m_path[(k + 2) % number_of_pieces()].point
           : k + 2 < m_path.size() ? &m_path[k + 2].point
                                     : nullptr;
  }

  Index old_vertex(Index segment) const { return m_span.vertex(segment); }
  const Point& old_point(Index segment) const { return m_outline.points[old_vertex(segment)]; }
  double size_at(const Fitted_vertex_2& v) const { return m_demands.size[old_vertex(v.segment)]; }
  double tolerance_at(Index segment) const
  {
    return (std::min)(m_demands.tolerance[old_vertex(segment)], m_demands.tolerance[old_vertex(end_of(segment))]);
  }

  /// the longest step: a vertex that goes farther than d makes pieces too long
  double longest_step(std::size_t k) const { return (std::min)(tolerance_at(m_path[k].segment), size_at(m_path[k])); }

  Index end_of(Index segment) const
  {
    return m_span.is_ring || segment < static_cast<Index>(m_span.size()) ? segment + 1 : segment;
  }

  /// A segment or a vertex near to a vertex of the path and to the pieces beside it, and how near it is.
  struct Near
  {
    double distance;
    Point source, target; // the same of a vertex
    bool is_vertex;
  };

  /// Of the pieces at a vertex when it is at `p`, which is `step` away from where it was measured, and of what is near
  /// to them. It need not be told when it is more than `bound`.
  double cost_at(std::size_t k, const Point& p, double step, double bound) const
  {
    const double size = size_at(m_path[k]), reach = clear * size;
    const Point &a = previous(k).point, &b = next(k).point;
    double cost = cost_of_length(a, p, size) + cost_of_length(p, b, size);
    if (cost > bound)
      return cost;
    cost += cost_of_corners({before_previous(k), &a, &p, &b, after_next(k)});
    double least = reach, cost_of_least = length_cost(clear);
    for (const Near& near : m_near) { // the nearest first
      if (near.distance - step >= least || cost + cost_of_least > bound)
        break;
      const double l = distance_through_domain(a, p, b, near, least);
      if (l < least)
        cost_of_least = length_cost((least = l) / size);
    }
    return cost + cost_of_least;
  }

  /// the same of the piece between the neighbours of a vertex; what counts is near to it, not to its ends, as before
  double cost_without(std::size_t k) const
  {
    const double size = size_at(m_path[k]);
    const Point &a = previous(k).point, &b = next(k).point;
    double least = clear * size;
    for (const Near& near : m_near)
      if (near.is_vertex)
        least = (std::min)(least, distance_through_domain(a, b, b, near, least));
    return cost_of_length(a, b, size) + cost_of_corners({before_previous(k), &a, &b, after_next(k)}) +
           length_cost(least / size);
  }

  static double cost_of_length(const Point& a, const Point& b, double size)
  {
    const double x = distance(a, b) / size;
    return length_cost(x) + quality_weight * (x - 1) * (x - 1);
  }

  /// of the corners between successive points; where one is missing there is none
  double cost_of_corners(std::initializer_list<const Point*> points) const
  {
    double sum = 0;
    for (auto p = points.begin() + 1; p + 1 != points.end(); ++p)
      if (p[-1] && p[1])
        sum += cost_of_corner(*p[-1], **p, *p[1]);
    return quality_weight * sum;
  }

  double cost_of_corner(const Point& a, const Point& p, const Point& b) const
  {
    const double ux = a.x() - p.x(), uy = a.y() - p.y(), vx = b.x() - p.x(), vy = b.y() - p.y();
    const double cosine = (ux * vx + uy * vy) / std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
    const bool turns_left = vx * uy - vy * ux > 0;
    return (m_span.inside_left ? angle_cost(cosine, !turns_left) : 0) +
           (m_span.inside_right ? angle_cost(cosine, turns_left) : 0);
  }

  double cost(std::size_t k) const
  {
    return cost_at(k, m_path[k].point, 0, (std::numeric_limits<double>::infinity)());
  }

  /// what may be near to a vertex and the pieces beside it, wherever it moves
  void look_around(std::size_t k)
  {
    m_near.clear();
    const Point &a = previous(k).point, &p = m_path[k].point, &b = next(k).point;
    const double way = (std::min)(2 * tolerance_at(m_path[k].segment), moves_of_a_vertex * longest_step(k));
    const double reach = clear * size_at(m_path[k]) + way;
    const Bbox_2 box = a.bbox() + p.bbox() + b.bbox();
    m_movable.grid().for_each_near(
      Bbox_2(box.xmin() - reach, box.ymin() - reach, box.xmax() + reach, box.ymax() + reach), [&](Index id) {
        const Point &c = m_movable.grid().source(id), &d = m_movable.grid().target(id);
        if (c == p || d == p)
          return;
        m_near.push_back({0, c, d, false});
        for (const Point* w : {&c, &d})
          if (*w != a && *w != b)
            m_near.push_back({0, *w, *w, true});
      });
    measure(k);
  }

  /// puts what counts after a step first, the nearest in front
  void measure(std::size_t k)
  {
    for (Near& near : m_near)
      near.distance = distance_to(previous(k).point, m_path[k].point, next(k).point, near);
    const double reach = clear * size_at(m_path[k]) + longest_step(k);
    const auto end = std::partition(m_near.begin(), m_near.end(), [=](const Near& x) { return x.distance < reach; });
    std::sort(m_near.begin(), end, [](const Near& x, const Near& y) { return x.distance < y.distance; });
  }

  static double distance_to(const Point& a, const Point& p, const Point& b, const Near& near)
  {
    if (!near.is_vertex)
      return std::sqrt(CGAL::squared_distance(p, nearest_on_segment(p, near.source, near.target)));
    const Point& w = near.source;
    return std::sqrt((std::min)(CGAL::squared_distance(w, nearest_on_segment(w, p, a)),
                                CGAL::squared_distance(w, nearest_on_segment(w, p, b))));
  }

  /// from the vertex `p` to a segment, or from one of the pieces beside it to a vertex; `none` if it is not less than
  /// that, or if the way leads out of the domain
  double distance_through_domain(const Point& a, const Point& p, const Point& b, const Near& near, double none) const
  {
    const double l = distance_to(a, p, b, near);
    const bool counts =
      l < none && is_in_domain(a, p, b, near.is_vertex ? near.source : nearest_on_segment(p, near.source, near.target));
    return counts ? l : none;
  }

  /// whether the domain lies on the way from the vertex `p`, between `a` and `b`, to `q`, which is near
  bool is_in_domain(const Point& a, const Point& p, const Point& b, const Point& q) const
  {
    if (m_span.inside_left && m_span.inside_right)
      return true;
    const bool left_of_a = is_left(a, p, q), left_of_b = is_left(p, b, q), turns_left = is_left(a, p, b);
    const bool is_left_of_path = turns_left ? left_of_a && left_of_b : left_of_a || left_of_b;
    return is_left_of_path == m_span.inside_left;
  }

  static bool is_left(const Point& a, const Point& b, const Point& p)
  {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x()) > 0;
  }

  /// whether the old vertices that belong to a piece are near to it
  bool is_near(const Fitted_vertex_2& a, const Point& p, Index segment_of_p, bool p_is_first) const
  {
    const Index first = p_is_first ? segment_of_p : a.segment, last = p_is_first ? a.segment : segment_of_p;
    for (Index m = first + 1; m <= last; ++m)
      if (!(distance_to_segment(old_point(m), a.point, p) <= m_demands.tolerance[old_vertex(m)]))
        return false;
    return true;
  }

  /// The segment of the old outline that `p`, in the place of a vertex, may belong to; `no_index` if it is too far off.
  Index segment_for(std::size_t k, const Point& p) const
  {
    const Index first = segment_before(k), last = next(k).segment;
    Index best = no_index;
    double least = (std::numeric_limits<double>::infinity)();
    for (Index s = first; s <= last; ++s) {
      if (!m_span.is_ring && s == static_cast<Index>(m_span.size()))
        break;
      const double l = distance_to_segment(p, old_point(s), old_point(end_of(s)));
      if (l < least && l <= tolerance_at(s)) {
        least = l;
        best = s;
      }
    }
    return best;
  }

  /// that of the vertex before; before a ring's first one it is that of the last one, a turn earlier
  Index segment_before(std::size_t k) const
  {
    return previous(k).segment - (k == 0 ? static_cast<Index>(m_span.size()) : 0);
  }

  Fitted_vertex_2 previous_in_turn(std::size_t k) const
  {
    Fitted_vertex_2 v = previous(k);
    v.segment = segment_before(k);
    return v;
  }

  bool move(std::size_t k)
  {
    bool has_moved = false;
    double now = cost(k) + deviation_cost(m_path[k].point, m_path[k].segment), step = 1;
    for (int halving = 0, moves = 0; halving < halvings && moves < moves_of_a_vertex;) {
      if (try_step(k, step * longest_step(k), now)) {
        has_moved = true;
        ++moves;
      } else {
        step *= 0.5;
        ++halving;
      }
    }
    return has_moved;
  }

  /// Moves a vertex in the best of eight directions, along the way between its neighbours and across it.
  bool try_step(std::size_t k, double step, double& now)
  {
    constexpr double diagonal = 0.70710678118654752;
    constexpr double directions[8][2] = {{1, 0}, {diagonal, diagonal}, {0, 1}, {-diagonal, diagonal},
                                         {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
    const Point old = m_path[k].point, &a = previous(k).point, &b = next(k).point;
    const double l = distance(a, b), ux = l > 0 ? (b.x() - a.x()) / l : 1, uy = l > 0 ? (b.y() - a.y()) / l : 0;
    std::vector<std::pair<double, Fitted_vertex_2>> better;
    for (const auto& d : directions) {
      const Point p(old.x() + step * (d[0] * ux - d[1] * uy), old.y() + step * (d[0] * uy + d[1] * ux));
      if (is_too_long(k, p))
        continue;
      const double cost = cost_at(k, p, step, now);
      if (!(cost < now - least_gain))
        continue;
      const Index segment = segment_for(k, p);
      if (segment == no_index || !is_near(previous_in_turn(k), p, segment, false) ||
          !is_near(next(k), p, segment, true))
        continue;
      const double with_deviation = cost + deviation_cost(p, segment);
      if (with_deviation < now - least_gain)
        better.push_back({with_deviation, {p, segment, no_index}});
    }
    std::stable_sort(better.begin(), better.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    for (const auto& best : better)
      if (m_movable.is_free(ids_at(k), {a, old, b}, {a, best.second.point, b})) {
        now = best.first;
        put(k, best.second);
        measure(k);
        return true;
      }
    return false;
  }

  bool is_too_long(std::size_t k, const Point& p) const
  {
    const double longest = longest_piece * size_at(m_path[k]);
    const Point &old = m_path[k].point, &a = previous(k).point, &b = next(k).point;
    const double to_a = distance(a, p), to_b = distance(p, b);
    return (to_a > longest && to_a > distance(a, old)) || (to_b > longest && to_b > distance(old, b));
  }

  double deviation_cost(const Point& p, Index segment) const
  {
    const double off = distance_to_segment(p, old_point(segment), old_point(end_of(segment)));
    return deviation_weight * piece_cost(1, off / tolerance_at(segment));
  }

  std::vector<Index> ids_at(std::size_t k) const { return {m_ids[piece_before(k)], m_ids[k]}; }

  void put(std::size_t k, const Fitted_vertex_2& v)
  {
    for (Index id : ids_at(k))
      m_movable.remove(id);
    m_path[k] = v;
    if (k == 0)
      m_path.back() = {v.point, v.segment + static_cast<Index>(m_span.size()), v.vertex};
    m_ids[piece_before(k)] = m_movable.insert(previous(k).point, v.point, size_at(v));
    m_ids[k] = m_movable.insert(v.point, next(k).point, size_at(v));
  }

  /// drops a vertex if that costs less
  bool drop(std::size_t k)
  {
    if (k == 0 || number_of_pieces() <= (m_span.is_ring ? 3u : 1u))
      return false;
    const Fitted_vertex_2 &a = previous(k), &b = next(k);
    const Point old = m_path[k].point;
    const double size = size_at(m_path[k]), now = cost(k), then = cost_without(k);
    if (!(then < now - least_gain) || !(distance(a.point, b.point) <= longest_piece * size))
      return false;
    if (!is_near(a, b.point, b.segment, false) ||
        !m_movable.is_free(ids_at(k), {a.point, old, b.point}, {a.point, b.point}))
      return false;
    for (Index id : ids_at(k))
      m_movable.remove(id);
    m_ids[k - 1] = m_movable.insert(a.point, b.point, size);
    m_ids.erase(m_ids.begin() + static_cast<std::ptrdiff_t>(k));
    m_path.erase(m_path.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }

  const Outline_2& m_outline;
  const Outline_span_2& m_span;
  const Outline_demands_2& m_demands;
  Movable_outline_2& m_movable;
  Fitted_path_2& m_path;
  std::vector<Index>& m_ids;
  std::vector<Near> m_near; // to the vertex that is moved
  const std::vector<char>& m_is_wall; // of each segment of the outline
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PATH_IMPROVEMENT_2_H
