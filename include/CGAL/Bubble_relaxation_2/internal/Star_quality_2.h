// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_STAR_QUALITY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_STAR_QUALITY_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The quality of the triangles around a vertex as a function of its place, in coordinates relative to
/// where it is now and in units of a length near to that of the edges: no lengths are too large or too small.
class Star_quality_2
{
public:
  struct Vector { double x, y; };

  Star_quality_2(const Point& center, double unit) : m_center(center), m_unit(unit) {}

  /// a triangle whose side opposite to the vertex runs from `p` to `q`, counterclockwise
  void add(const Point& p, const Point& q)
  {
    const Vector a = local(p), b = local(q);
    m_sides.push_back(Side{a, b, std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y))});
  }

  /// the smallest q = 2 r_in / r_out of the triangles if the vertex is at `at`; negative if it is not
  /// on the inner side of all sides
  double smallest(Vector at) const
  {
    double least = 1;
    for (const Side& s : m_sides)
      least = (std::min)(least, Triangle(s, at).quality());
    return least;
  }

  /// the sum of q^-8: the worst triangle decides where one is bad, all do where they are alike
  double energy(Vector at) const
  {
    double sum = 0;
    for (const Side& s : m_sides) {
      const double q = Triangle(s, at).quality();
      if (!(q > flat))
        return std::numeric_limits<double>::infinity();
      sum += eighth_power(1 / q);
    }
    return sum;
  }

  Vector gradient(Vector at) const
  {
    Vector sum{0, 0};
    for (const Side& s : m_sides) {
      const Triangle t(s, at);
      const double q = t.quality();
      if (!(q > flat))
        continue;
      const double factor = -8 * eighth_power(1 / q);
      // of log q = log 4 + 2 log(2 area) - log(sum of the lengths) - sum of the logs of the lengths
      const double to_area = 2 / t.area2, along_p = -(1 / (t.a + t.b + t.c) + 1 / t.b) / t.b,
                   along_q = -(1 / (t.a + t.b + t.c) + 1 / t.c) / t.c;
      sum.x += factor * (to_area * (s.p.y - s.q.y) + along_p * t.u.x + along_q * t.v.x);
      sum.y += factor * (to_area * (s.q.x - s.p.x) + along_p * t.u.y + along_q * t.v.y);
    }
    return sum;
  }

  Point point(Vector at) const
  {
    return Point(m_center.x() + m_unit * at.x, m_center.y() + m_unit * at.y);
  }

private:
  struct Side { Vector p, q; double length; };

  // with the vertex at `at`
  struct Triangle
  {
    Vector u, v; // from the ends of the side to the vertex
    double a, b, c, area2;

    Triangle(const Side& s, Vector at)
      : u{at.x - s.p.x, at.y - s.p.y}, v{at.x - s.q.x, at.y - s.q.y}, a(s.length),
        b(std::sqrt(u.x * u.x + u.y * u.y)), c(std::sqrt(v.x * v.x + v.y * v.y)),
        area2(u.x * v.y - u.y * v.x)
    {}

    double quality() const
    {
      const double q = 4 * area2 * area2 / ((a + b + c) * a * b * c);
      return area2 > 0 ? q : -q;
    }
  };

  static constexpr double flat = 1e-3;

  static double eighth_power(double x)
  {
    const double x2 = x * x, x4 = x2 * x2;
    return x4 * x4;
  }

  Vector local(const Point& p) const
  {
    return Vector{(p.x() - m_center.x()) / m_unit, (p.y() - m_center.y()) / m_unit};
  }

  Point m_center;
  double m_unit;
  boost::container::small_vector<Side, 10> m_sides;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_STAR_QUALITY_2_H
