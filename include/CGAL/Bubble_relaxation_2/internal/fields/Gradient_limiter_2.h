// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_GRADIENT_LIMITER_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_GRADIENT_LIMITER_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The least value at `q` that a value which grows by `g` per unit of length brings there from the segment
/// between `a` and `b`, between which it is linear: the front of a plane wave.
inline double front_from_segment(const Point& a, double value_a, const Point& b, double value_b,
                                 const Point& q, double g)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::sqrt(dx * dx + dy * dy);
  const double px = q.x() - a.x(), py = q.y() - a.y();
  const double slope = (value_b - value_a) / length;
  double along = 0; // from a, where the ray to q starts
  if (slope < 0)
    along = length;
  if (std::abs(slope) < g) {
    const double foot = (px * dx + py * dy) / length, height = std::abs(px * dy - py * dx) / length;
    along = foot - height * slope / std::sqrt(g * g - slope * slope);
    along = (std::max)(0., (std::min)(length, along));
  }
  const double s = along / length, rx = px - s * dx, ry = py - s * dy;
  return (1 - s) * value_a + s * value_b + g * std::sqrt(rx * rx + ry * ry);
}

/// Lowers values at the vertices of a triangulation so that they grow by no more than `g` per unit of length
/// along its domain: from the smallest value to larger ones, as Dijkstra's algorithm goes. A vertex that is
/// lowered later, which obtuse triangles do to each other, is visited again.
class Gradient_limiter_2
{
public:
  Gradient_limiter_2(const Flat_triangulation_2& tr, double g)
    : m_tr(tr), m_g(g), m_around(tr.vertices, tr.points.size(), [&tr](std::size_t t) { return tr.inside[t] != 0; })
  {}

  /// The largest values, up to rounding, that fronts across triangles allow: near to
  /// min over y of values(y) + g |x - y|, measured within the domain. Their linear interpolation may be
  /// steeper than `g`, by 15 % beside a minimum in a vertex of equilateral triangles.
  void spread(std::vector<double>& values)
  {
    // in needles fronts go to and fro between the long sides, and each time they lower values by less
    constexpr double little = 1e-4;
    sweep(values, little, [this](Index t, std::vector<double>& h) {
      std::array<double, 3> limits;
      for (int i = 0; i < 3; ++i) {
        const Index v = m_tr.vertices[t][i], a = m_tr.vertices[t][ccw(i)], b = m_tr.vertices[t][cw(i)];
        limits[i] = h[v]; // no front has less than what it comes from
        if (h[v] > (std::min)(h[a], h[b]))
          limits[i] = front_from_segment(m_tr.points[a], h[a], m_tr.points[b], h[b], m_tr.points[v], m_g);
      }
      return limits;
    });
  }

  /// Lowers values until their linear interpolation is no steeper than `g` in any triangle.
  void clip(std::vector<double>& values)
  {
    sweep(values, 0, [this](Index t, std::vector<double>& h) { return clipped(t, h); });
  }

  /// the length of the gradient of the linear interpolation in a triangle
  double gradient(Index t, const std::vector<double>& h) const
  {
    const auto& v = m_tr.vertices[t];
    return gradient(Shape(m_tr, t, 0, 1, 2), h[v[1]] - h[v[0]], h[v[2]] - h[v[0]]);
  }

private:
  static constexpr double tolerance = 1e-7;

  /// A triangle seen from one of its vertices: twice the area, and products of its sides a and b, and of c, from the end
  /// of a to that of b. These are computed from points: a difference of others loses all digits in needles.
  struct Shape
  {
    Shape(const Flat_triangulation_2& tr, Index t, int o, int a, int b)
    {
      const Point &p = tr.point(t, o), &q = tr.point(t, a), &r = tr.point(t, b);
      const double ux = q.x() - p.x(), uy = q.y() - p.y(), vx = r.x() - p.x(), vy = r.y() - p.y();
      const double wx = r.x() - q.x(), wy = r.y() - q.y();
      aa = ux * ux + uy * uy;
      bb = vx * vx + vy * vy;
      cc = wx * wx + wy * wy;
      ab = ux * vx + uy * vy;
      ac = ux * wx + uy * wy;
      bc = vx * wx + vy * wy;
      area = std::abs(ux * vy - uy * vx);
    }

    double aa, bb, cc, ab, ac, bc, area;
  };

  /// for the values `a` and `b` over that of the third vertex: that of `a` along c, and of what `b` has more along a
  static double gradient(const Shape& s, double a, double b)
  {
    double more = b - a;
    const double unit = (std::max)(std::abs(a), std::abs(more)); // else fourth powers of lengths might be none
    if (unit == 0)
      return 0;
    a /= unit;
    more /= unit;
    const double squared = a * a * s.cc - 2 * a * more * s.ac + more * more * s.aa;
    return squared > 0 ? std::sqrt(squared) * unit / s.area : 0;
  }

  /// The values of a triangle, lowered so that its gradient is no more than g. The smallest one stays.
  std::array<double, 3> clipped(Index t, const std::vector<double>& h) const
  {
    std::array<double, 3> limits;
    std::array<int, 3> order{0, 1, 2}; // from the smallest to the largest
    for (int i = 0; i < 3; ++i)
      limits[i] = h[m_tr.vertices[t][i]];
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return limits[i] < limits[j] || (limits[i] == limits[j] && m_tr.vertices[t][i] < m_tr.vertices[t][j]);
    });
    const Shape s(m_tr, t, order[0], order[1], order[2]);
    const double base = limits[order[0]];
    double a = limits[order[1]] - base, b = limits[order[2]] - base;
    if (!(gradient(s, a, b) > m_g * (1 + tolerance)))
      return limits;
    a = (std::min)(a, m_g * std::sqrt(s.aa));
    b = (std::min)(b, m_g * std::sqrt(s.bb));
    if (gradient(s, a, b) > m_g)
      lower(s, a, b);
    limits[order[1]] = base + patience(t, order[1]) * a;
    limits[order[2]] = base + patience(t, order[2]) * b;
    return limits;
  }

  /// In needles triangles lower the values of each other again and again. The share of its height over the smallest
  /// value of a triangle that a vertex is left with: 1 at first, 0 when it was lowered very often, which ends that.
  double patience(Index t, int i) const
  {
    constexpr int often = 50;
    const int times = m_times_lowered[m_tr.vertices[t][i]];
    return times < often ? 1 : (std::max)(0., 2 - double(times) / often);
  }

  /// Lowers the values `a` and `b` over that of the third vertex until the gradient is g.
  void lower(const Shape& s, double& a, double& b) const
  {
    if (a > b) // after both were cut to the lengths of their sides
      return lower(mirrored(s), b, a);
    if (b * s.aa <= a * s.ab) { // the larger one is too small for the other
      a = largest(s.bb, s.ab, s.area, b);
      return;
    }
    b = largest(s.aa, s.ab, s.area, a);
    if (b < a) // the larger one may not fall below the other: both are as high as one
      a = b = m_g * s.area / std::sqrt(s.cc);
  }

  static Shape mirrored(Shape s)
  {
    std::swap(s.aa, s.bb);
    s.ac = -std::exchange(s.bc, -s.ac);
    return s;
  }

  /// the largest value of one vertex for that of the other, for which the gradient is g
  double largest(double squared_side, double product, double area, double other) const
  {
    return (other * product + area * std::sqrt((std::max)(0., m_g * m_g * squared_side - other * other))) /
           squared_side;
  }

  /// `little`: values are not lowered by a share that is less
  template <class Limits>
  void sweep(std::vector<double>& values, double little, const Limits& limits)
  {
    using Visit = std::pair<double, Index>;
    std::vector<Visit> all;
    m_times_lowered.assign(values.size(), 0);
    for (std::size_t v = 0; v < values.size(); ++v)
      if (!m_around[v].empty())
        all.emplace_back(values[v], static_cast<Index>(v));
    std::priority_queue<Visit, std::vector<Visit>, std::greater<Visit>> queue(std::greater<Visit>(),
                                                                              std::move(all));
    for (std::size_t visits = 0; !queue.empty(); ++visits) {
      tick(visits);
      const Visit visit = queue.top();
      queue.pop();
      if (visit.first != values[visit.second])
        continue; // was lowered, and is in the queue again
      for (Index t : m_around[visit.second]) {
        const std::array<double, 3> limit = limits(t, values);
        for (int i = 0; i < 3; ++i) {
          const Index v = m_tr.vertices[t][i];
          if (limit[i] < values[v] * (1 - little)) {
            values[v] = limit[i];
            ++m_times_lowered[v];
            queue.emplace(limit[i], v);
          }
        }
      }
    }
  }

  const Flat_triangulation_2& m_tr;
  double m_g;
  Triangles_around_2 m_around;      // of the domain
  std::vector<int> m_times_lowered; // of each vertex in this sweep
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FIELDS_GRADIENT_LIMITER_2_H
