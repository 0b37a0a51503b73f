// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_SMOOTHING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_SMOOTHING_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Editable_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

/// the share of its q that an obtuse triangle counts with
inline constexpr double worth_of_obtuse = 0.95;

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

  /// the smallest q = 2 r_in / r_out of the triangles, the same where obtuse ones count less, and the sum of q^-8: the
  /// worst triangle decides where one is bad, all do where they are alike
  struct Value
  {
    double smallest, smallest_worth, energy;

    /// whether the sum is less, and neither of the others is
    bool is_better_than(const Value& v) const
    {
      return energy < v.energy && smallest >= v.smallest && smallest_worth >= v.smallest_worth;
    }
  };

  /// if the vertex is at `at`; infinite energy where a triangle is flat or turned over
  Value operator()(Vector at) const
  {
    Value value{1, 1, 0};
    for (const Side& s : m_sides) {
      const Triangle t(s, at);
      const double q = t.quality();
      value.smallest = (std::min)(value.smallest, q);
      value.smallest_worth = (std::min)(value.smallest_worth, t.is_obtuse() ? worth_of_obtuse * q : q);
      value.energy += q > flat ? eighth_power(1 / q) : std::numeric_limits<double>::infinity();
    }
    return value;
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
      const double to_area = 2 / t.area2, to_sum = 1 / (t.a + t.b + t.c), to_b = 1 / t.b, to_c = 1 / t.c,
                   along_p = -(to_sum + to_b) * to_b, along_q = -(to_sum + to_c) * to_c;
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

    bool is_obtuse() const
    {
      const double uu = u.x * u.x + u.y * u.y, uv = u.x * v.x + u.y * v.y, vv = v.x * v.x + v.y * v.y;
      return internal::is_obtuse(uv, area2) || internal::is_obtuse(uu - uv, area2) ||
             internal::is_obtuse(vv - uv, area2);
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

/// Moves single vertices to where the triangles around them are better: one step of Newton's method for
/// the energy of `Star_quality_2`, shortened until the energy falls and no triangle is worse than the worst
/// was, also if obtuse triangles count less. Vertices on edges of the domain slide. Vertices in faces may be moved at the
/// same time unless they are neighbours.
class Vertex_smoothing_2
{
public:
  Vertex_smoothing_2(const Domain_2& domain, double treated_quality)
    : m_domain(domain), m_treated_quality(treated_quality)
  {}

  /// returns whether the vertex moved
  bool operator()(const Editable_triangulation_2& mesh, Bubbles_2& bubbles, Index v) const
  {
    const Star_2 corners = mesh.star(v);
    const Star_quality_2 star = quality_around(mesh, bubbles, v, corners);
    const Vector here{0, 0};
    const Star_quality_2::Value now = star(here);
    if (now.smallest >= m_treated_quality)
      return false;
    const Vector step = bubbles.is_on_edge(v) ? step_along(star, bubbles.host[v]) : step_in_face(star);
    const double length = std::sqrt(step.x * step.x + step.y * step.y);
    if (!(length > least_step))
      return false;
    double factor = (std::min)(1., longest_step / length);
    for (int attempt = 0; attempt < 4; ++attempt, factor *= 0.4) {
      const Vector there{factor * step.x, factor * step.y};
      if (star(there).is_better_than(now) && try_to_move(mesh, bubbles, v, corners, star.point(there), there))
        return true;
    }
    return false;
  }

private:
  using Vector = Star_quality_2::Vector;

  /// steps in units of the size at the vertex
  static constexpr double least_step = 0.003, longest_step = 0.2, step_down = 0.1;
  /// for derivatives of the gradient
  static constexpr double h = 1. / 1024;

  static Star_quality_2 quality_around(const Editable_triangulation_2& mesh, const Bubbles_2& bubbles,
                                       Index v, const Star_2& corners)
  {
    Star_quality_2 star(bubbles.point(v), bubbles.d[v]);
    const std::size_t first = first_corner(mesh, corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner_2& c = corners[(first + k) % corners.size()];
      if (mesh.is_inside(c.triangle))
        star.add(mesh.mesh().point(c.triangle, ccw(c.index)), mesh.mesh().point(c.triangle, cw(c.index)));
    }
    return star;
  }

  /// The one in the domain with the first neighbour: sums round the same wherever the star begins.
  static std::size_t first_corner(const Editable_triangulation_2& mesh, const Star_2& corners)
  {
    std::size_t first = 0;
    Index least = no_index;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index w = mesh.vertices(corners[k].triangle)[ccw(corners[k].index)];
      if (mesh.is_inside(corners[k].triangle) && (least == no_index || w < least)) {
        least = w;
        first = k;
      }
    }
    return first;
  }

  /// Newton's step, or down the slope where the energy is not convex
  static Vector step_in_face(const Star_quality_2& star)
  {
    const Vector g = star.gradient(Vector{0, 0}), gx = star.gradient(Vector{h, 0}),
                 gy = star.gradient(Vector{0, h});
    const double xx = (gx.x - g.x) / h, yy = (gy.y - g.y) / h, xy = 0.5 * (gx.y - g.y + gy.x - g.x) / h;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0 && xx > 0))
      return down(g);
    return Vector{(xy * g.y - yy * g.x) / determinant, (xy * g.x - xx * g.y) / determinant};
  }

  Vector step_along(const Star_quality_2& star, Index e) const
  {
    const Direction u = m_domain.direction(e);
    const Vector g = star.gradient(Vector{0, 0}),
                 gu = star.gradient(Vector{h * u.x, h * u.y});
    const double slope = g.x * u.x + g.y * u.y, curvature = (gu.x * u.x + gu.y * u.y - slope) / h;
    if (!(curvature > 0))
      return down(Vector{slope * u.x, slope * u.y});
    return Vector{-slope / curvature * u.x, -slope / curvature * u.y};
  }

  static Vector down(Vector g)
  {
    const double slope = std::sqrt(g.x * g.x + g.y * g.y);
    return slope > 0 ? Vector{-step_down * g.x / slope, -step_down * g.y / slope} : Vector{0, 0};
  }

  /// moves a vertex to `p`, which is `step` away, unless a triangle of the domain around it would be turned
  /// over; returns whether it did
  bool try_to_move(const Editable_triangulation_2& mesh, Bubbles_2& b, Index v, const Star_2& corners, Point p,
                   Vector step) const
  {
    double s = b.s[v];
    if (b.is_on_edge(v)) {
      const Direction u = m_domain.direction(b.host[v]);
      s += b.d[v] / m_domain.length(b.host[v]) * (step.x * u.x + step.y * u.y);
      if (passes_another(mesh, b, v, corners, s))
        return false;
      p = m_domain.point_on_edge(b.host[v], s);
    }
    if (!mesh.stays_valid(corners, p))
      return false;
    if (b.is_in_face(v))
      b.host[v] = m_domain.walk(b.host[v], b.point(v), p).triangle;
    b.s[v] = s;
    b.x[v] = p.x();
    b.y[v] = p.y();
    return true;
  }

  /// Whether a vertex would slide to, or beyond, another one of its edge or an end: triangles do not tell where they are as
  /// near to each other as roundings. One on the rim of a patch looks like a corner, but has its position.
  static bool passes_another(const Editable_triangulation_2& mesh, const Bubbles_2& b, Index v, const Star_2& corners,
                             double s)
  {
    if (!(s > 0 && s < 1))
      return true;
    for (const Corner_2& c : corners)
      for (Index w : mesh.vertices(c.triangle))
        if (w != v && b.s[w] > 0 && b.host[w] == b.host[v] && !(b.s[w] < b.s[v] ? b.s[w] < s : s < b.s[w]))
          return true;
    return false;
  }

  const Domain_2& m_domain;
  double m_treated_quality;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_VERTEX_SMOOTHING_2_H
