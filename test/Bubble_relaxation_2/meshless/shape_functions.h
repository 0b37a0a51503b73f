// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_SHAPE_FUNCTIONS_H
#define BUBBLE_RELAXATION_2_TEST_SHAPE_FUNCTIONS_H

#include <CGAL/Moving_least_squares_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// What tests of moving least squares share.
namespace shape_functions {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Influence = CGAL::Influence_domain_2<K>;
using Mls = CGAL::Moving_least_squares_2<K>;
using Shapes = Mls::Shape_functions;
using Basis = CGAL::Moving_least_squares_basis;
using Weight = CGAL::Moving_least_squares_weight;
using CGAL::Deficient_support;
using CGAL::Bubble_relaxation_2::internal::number_of_monomials;

constexpr std::array<Basis, 3> bases{Basis::CONSTANT, Basis::LINEAR, Basis::QUADRATIC};
constexpr std::array<Weight, 3> weights{Weight::QUARTIC_SPLINE, Weight::CUBIC_SPLINE, Weight::GAUSSIAN};

inline std::array<const std::vector<double>*, 6> arrays(const Shapes& s)
{
  return {&s.values, &s.dx, &s.dy, &s.dxx, &s.dxy, &s.dyy};
}

/// a third of the largest support radius at a point, the unit of lengths
inline double unit(const Influence& influence, const Shapes& s)
{
  double radius = 0;
  for (auto i : s.nodes)
    radius = (std::max)(radius, influence.radius(i) * s.enlargement);
  return radius / 3;
}

/// By how much shape functions and their derivatives miss the polynomials of the basis, which are taken about
/// the point and in its unit of lengths. With `relative` each error is in units of the sum of the magnitudes of
/// what is summed up, if that is more than 1: large terms have large rounding errors.
inline double reproduction_error(const Influence& influence, const Point& p, const Shapes& s, Basis basis,
                                 bool relative = false, int number_of_derivatives = 2)
{
  const double h = unit(influence, s);
  // the value, dx, dy, dxx, dxy and dyy at the point itself of x^a y^b
  const auto exact = [](int k, int a, int b) {
    constexpr std::array<std::array<int, 2>, 6> powers{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
    return powers[k] == std::array<int, 2>{a, b} ? (k == 3 || k == 5 ? 2. : 1.) : 0.;
  };
  double worst = 0;
  for (int a = 0; a <= static_cast<int>(basis); ++a)
    for (int b = 0; a + b <= static_cast<int>(basis); ++b)
      for (int k = 0; k < number_of_monomials(number_of_derivatives); ++k) {
        const std::vector<double>& shape = *arrays(s)[k];
        const double length = k == 0 ? 1 : k < 3 ? h : h * h;
        long double sum = 0, magnitude = 1;
        for (std::size_t i = 0; i < shape.size(); ++i) {
          const Point& node = influence.point(s.nodes[i]);
          const double term = shape[i] * length * std::pow((node.x() - p.x()) / h, a) *
                              std::pow((node.y() - p.y()) / h, b);
          sum += term;
          magnitude += std::abs(term);
        }
        if (!shape.empty())
          worst = (std::max)(worst, static_cast<double>(std::abs(sum - exact(k, a, b)) /
                                                        (relative ? magnitude : 1)));
      }
  return worst;
}

/// the shape function of a node, or a derivative of it, 0 for a node in whose support the point does not lie
inline double of_node(const Shapes& s, const std::vector<double>& values, std::int32_t node)
{
  const auto at = std::lower_bound(s.nodes.begin(), s.nodes.end(), node);
  return at != s.nodes.end() && *at == node ? values[static_cast<std::size_t>(at - s.nodes.begin())] : 0;
}

} // namespace shape_functions

#endif // BUBBLE_RELAXATION_2_TEST_SHAPE_FUNCTIONS_H
