// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Gradient_limiter_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Triangle_quadtree_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Values at the vertices of a triangulation, linear in the triangles of its domain. Outside it is the value
/// in the nearest point of the domain, and beyond the convex hull that in the nearest point of the hull.
/// On an edge only the edge's ends count, so that both its triangles give the same bits. Queries change
/// nothing.
class Interpolated_field_2
{
public:
  /// \pre some triangles belong to the domain
  Interpolated_field_2(Flat_triangulation_2 tr, std::vector<double> values)
    : m_tr(std::move(tr)), m_values(std::move(values)), m_quadtree(m_tr)
  {}

  double operator()(double x, double y) const
  {
    if (!std::isfinite(x) || !std::isfinite(y))
      return std::numeric_limits<double>::quiet_NaN();
    const Point q(x, y);
    const Walk_end end = locate_or_exit(m_tr, m_quadtree.start(x, y), q);
    if (end.is_blocked())
      return value_beyond_hull(end, q);
    return m_tr.inside[end.triangle] ? interpolate(end.triangle, q) : value_outside(end.triangle, q);
  }

  const Flat_triangulation_2& triangulation() const { return m_tr; }

private:
  double value(Index t, int i) const { return m_values[m_tr.vertices[t][i]]; }

  double interpolate(Index t, const Point& q) const
  {
    double sum = 0, weights = 0;
    for (int i = 0; i < 3; ++i) {
      const Point &a = m_tr.point(t, ccw(i)), &b = m_tr.point(t, cw(i));
      if (CGAL::orientation(a, b, q) == COLLINEAR)
        return on_side(t, i, q).value; // both triangles of the side must give the same bits
      const double weight =
        std::abs((b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x()));
      sum += weight * value(t, i);
      weights += weight;
    }
    // in a triangle as thin as the rounding of its points all weights may be zero, or lose their bits
    constexpr double least = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
    return weights > least ? sum / weights : on_side(t, opposite_to_longest_side(t), q).value;
  }

  int opposite_to_longest_side(Index t) const
  {
    const auto squared = [&](int i) {
      return CGAL::squared_distance(m_tr.point(t, ccw(i)), m_tr.point(t, cw(i)));
    };
    return squared(0) >= squared(1) && squared(0) >= squared(2) ? 0 : squared(1) >= squared(2) ? 1 : 2;
  }

  struct Nearest
  {
    Point point;
    double distance, value;
  };

  /// the point of the side opposite to vertex `i` that is the nearest to `q`
  Nearest on_side(Index t, int i, const Point& q) const
  {
    int from = ccw(i), to = cw(i);
    if (m_tr.vertices[t][to] < m_tr.vertices[t][from])
      std::swap(from, to);
    const Point &a = m_tr.point(t, from), &b = m_tr.point(t, to);
    const double dx = b.x() - a.x(), dy = b.y() - a.y();
    const double along = ((q.x() - a.x()) * dx + (q.y() - a.y()) * dy) / (dx * dx + dy * dy);
    const double s = (std::max)(0., (std::min)(1., along));
    return Nearest{Point(a.x() + s * dx, a.y() + s * dy),
                   length_of(q.x() - a.x() - s * dx, q.y() - a.y() - s * dy),
                   (1 - s) * value(t, from) + s * value(t, to)};
  }

  /// The side of the hull that follows, counterclockwise or clockwise.
  Walk_end next_on_hull(Walk_end side, bool is_ccw) const
  {
    const auto turn = [&](int i) { return is_ccw ? ccw(i) : cw(i); };
    side.edge = turn(side.edge);
    while (m_tr.neighbors[side.triangle][side.edge] != no_index) {
      const Index next = m_tr.neighbors[side.triangle][side.edge];
      side = Walk_end{next, turn(m_tr.index_of_neighbor(next, side.triangle))};
    }
    return side;
  }

  /// Descends over the sides of the hull that `q` lies beyond, of which `side` is one, to the nearest: among
  /// these there is only one minimum.
  double value_beyond_hull(Walk_end side, const Point& q) const
  {
    Nearest best = on_side(side.triangle, side.edge, q);
    for (bool is_ccw : {true, false})
      for (;;) {
        const Walk_end next = next_on_hull(side, is_ccw);
        if (!m_tr.is_beyond(next.triangle, next.edge, q))
          break;
        const Nearest n = on_side(next.triangle, next.edge, q);
        if (!(n.distance < best.distance))
          break;
        side = next;
        best = n;
      }
    return m_tr.inside[side.triangle] ? best.value : value_outside(side.triangle, best.point);
  }

  /// The value in the point of the domain's boundary that is the nearest to `q` in the triangle `start`
  /// outside. The segment to that point crosses triangles outside only, so the search goes from neighbour to
  /// neighbour over sides that are nearer than what it has found. Most queries outside are so by a rounding
  /// and end in the first triangle.
  double value_outside(Index start, const Point& q) const
  {
    std::vector<Index> queue(1, start);
    std::unordered_set<Index> seen(queue.begin(), queue.end());
    Nearest best{q, std::numeric_limits<double>::infinity(), 0};
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const Index t = queue[k], next = m_tr.neighbors[t][i];
        if (next == no_index)
          continue;
        const Nearest n = on_side(t, i, q);
        if (n.distance > best.distance)
          continue;
        if (!m_tr.inside[next]) {
          if (seen.insert(next).second)
            queue.push_back(next);
        } else if (n.distance < best.distance || n.value < best.value)
          best = n;
      }
    return best.value;
  }

  Flat_triangulation_2 m_tr;
  std::vector<double> m_values;
  Triangle_quadtree_2 m_quadtree;
};

/// The size that a mesh with a domain has: at each vertex the mean length of its edges there, or less where that grows
/// by more than `growth` per unit of length, but no less than half of it: a needle does not ask for more of its kind.
inline Interpolated_field_2 mean_edge_length_field(const Triangulation_copy_2& mesh, double growth)
{
  Sorted_triangulation_2 sorted(mesh); // so that it does not matter how the mesh came about
  const Flat_triangulation_2& tr = sorted.tr;
  std::vector<std::pair<double, std::array<Index, 2>>> edges; // their lengths and ends
  for_each_edge(tr, 0, tr.number_of_triangles(), [&](Index t, int i) {
    const Point &p = tr.point(t, ccw(i)), &q = tr.point(t, cw(i));
    edges.push_back({std::sqrt(CGAL::squared_distance(p, q)), {tr.vertices[t][ccw(i)], tr.vertices[t][cw(i)]}});
  });
  std::sort(edges.begin(), edges.end()); // so that sums are rounded the same way whatever the order of the faces is
  std::vector<double> sizes(tr.points.size(), 0), count(tr.points.size(), 0);
  double all = 0;
  for (const auto& [length, ends] : edges) {
    for (Index v : ends) {
      sizes[v] += length;
      ++count[v];
    }
    all += length;
  }
  for (std::size_t v = 0; v < sizes.size(); ++v)
    sizes[v] = count[v] > 0 ? sizes[v] / count[v] : all / static_cast<double>(edges.size());
  std::vector<double> limited = sizes;
  Gradient_limiter_2(tr, growth).spread(limited);
  for (std::size_t v = 0; v < sizes.size(); ++v)
    sizes[v] = (std::max)(limited[v], sizes[v] / 2);
  return Interpolated_field_2(std::move(sorted.tr), std::move(sizes));
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_INTERPOLATED_FIELD_2_H
