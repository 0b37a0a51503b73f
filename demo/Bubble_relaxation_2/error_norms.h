// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_ERROR_NORMS_H
#define BUBBLE_RELAXATION_2_DEMO_ERROR_NORMS_H

#include "linear_finite_elements.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// The errors of a solution: of its values and of its gradient (that is the seminorm of H1).
struct Error_norms
{
  double l2 = 0, h1 = 0;
};

/// points and weights of Gauss on [0, 1], by Newton's method for the roots of the Legendre polynomial
inline std::vector<std::array<double, 2>> gauss_points(int n)
{
  constexpr double pi = 3.14159265358979323846;
  std::vector<std::array<double, 2>> result;
  for (int k = 0; k < n; ++k) {
    double x = std::cos(pi * (k + 0.75) / (n + 0.5)), slope = 1;
    for (int step = 0; step < 8; ++step) {
      double p = 1, previous = 0;
      for (int j = 1; j <= n; ++j) {
        const double next = ((2 * j - 1) * x * p - (j - 1) * previous) / j;
        previous = p;
        p = next;
      }
      slope = n * (x * p - previous) / (x * x - 1);
      x -= p / slope;
    }
    result.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return result;
}

/// Points and weights for integrals over triangles, also for functions of r^(2/3) and its derivatives around a corner
/// of the triangle: Gauss points in the square that collapses to the triangle (Duffy), where the distance from the
/// first corner is the third power of the coordinate, r = s^3. Squares of gradients, of r^(-2/3), are then
/// polynomials of s.
class Triangle_quadrature
{
public:
  /// barycentric coordinates, and the weight as share of the area
  struct Node
  {
    double a, b, c, weight;
  };

  /// `n` points in each direction, and two more around a corner with a singularity: the squared difference of a
  /// linear function and r^(2/3), with the elements of area, has the degree 11 in s
  explicit Triangle_quadrature(int n)
  {
    for (const auto& s : gauss_points(n))
      for (const auto& t : gauss_points(n))
        add(m_regular, s[0], t[0], s[1] * t[1]);
    for (const auto& s : gauss_points(n + 2))
      for (const auto& t : gauss_points(n + 2))
        add(m_singular, s[0] * s[0] * s[0], t[0], 3 * s[0] * s[0] * s[1] * t[1]);
  }

  const std::vector<Node>& nodes(bool is_singular_at_first_corner) const
  {
    return is_singular_at_first_corner ? m_singular : m_regular;
  }

private:
  static void add(std::vector<Node>& nodes, double radius, double along, double weight)
  {
    nodes.push_back({1 - radius, radius * (1 - along), radius * along, 2 * radius * weight});
  }

  std::vector<Node> m_regular, m_singular;
};

/// Integrates the square of the error over all triangles of the mesh. `error(t, p, barycentric)` returns the error of
/// the value and of the two components of the gradient in the point p of the triangle t; near to `singular_point`
/// it may be as that of r^(2/3).
template <class CDT, class Point_2, class Error>
Error_norms integrate_error(const Triangle_arrays<CDT>& mesh, const Point_2& singular_point, int number_of_points,
                            const Error& error)
{
  const Triangle_quadrature quadrature(number_of_points);
  double l2 = 0, h1 = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    int first = 0;
    bool is_singular = false;
    for (int i = 0; i < 3; ++i)
      if (mesh.point(t, i) == singular_point) {
        first = i;
        is_singular = true;
      }
    const int second = (first + 1) % 3, third = (first + 2) % 3;
    const Point_2 &p = mesh.point(t, first), &q = mesh.point(t, second), &r = mesh.point(t, third);
    const double area = mesh.area(t);
    for (const auto& node : quadrature.nodes(is_singular)) {
      const Point_2 x(p.x() + node.b * (q.x() - p.x()) + node.c * (r.x() - p.x()),
                      p.y() + node.b * (q.y() - p.y()) + node.c * (r.y() - p.y()));
      Eigen::Vector3d barycentric;
      barycentric[first] = node.a;
      barycentric[second] = node.b;
      barycentric[third] = node.c;
      const Eigen::Vector3d e = error(t, x, barycentric);
      l2 += node.weight * area * e[0] * e[0];
      h1 += node.weight * area * (e[1] * e[1] + e[2] * e[2]);
    }
  }
  return {std::sqrt(l2), std::sqrt(h1)};
}

/// The error of linear finite elements with the values `u` at the vertices.
template <class Exact, class CDT>
Error_norms error_of_linear_elements(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& u,
                                     int number_of_points = 4)
{
  return integrate_error(mesh, Exact::corner(), number_of_points,
                         [&](std::size_t t, const auto& p, const Eigen::Vector3d& barycentric) {
    const Eigen::Vector3d values = mesh.values(t, u);
    const Eigen::Vector2d gradient = mesh.hat_gradients(t) * values;
    const auto exact = Exact::gradient(p);
    return Eigen::Vector3d(barycentric.dot(values) - Exact::value(p), gradient[0] - exact.x(),
                           gradient[1] - exact.y());
  });
}

#endif // BUBBLE_RELAXATION_2_DEMO_ERROR_NORMS_H
