// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A function from its values at the nodes, without a mesh: the errors of value and gradient for the three bases,
// as nodes get closer.

#include "paper_domains.h"

#include <CGAL/Moving_least_squares_2.h>
#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>
#include <vector>

using paper::Point;
using Influence = CGAL::Influence_domain_2<paper::K>;
using Mls = CGAL::Moving_least_squares_2<paper::K>;
using Basis = CGAL::Moving_least_squares_basis;

double u(const Point& p) { return std::sin(3 * p.x()) * std::exp(p.y()); }
double u_x(const Point& p) { return 3 * std::cos(3 * p.x()) * std::exp(p.y()); }
double u_y(const Point& p) { return u(p); }

/// points of the domain between the nodes, the square without the disc
std::vector<Point> points_in_domain(std::size_t n)
{
  std::mt19937 random(1);
  const auto coordinate = [&random] { return 2 * (random() / 4294967296.) - 1; };
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = coordinate(), y = coordinate();
    if (paper::distance(Point(x, y), 0) > 0.5)
      points.push_back(Point(x, y));
  }
  return points;
}

int main()
{
  const std::vector<Point> points = points_in_domain(5000);
  std::cout << "largest errors\n"
               "            constant basis         linear basis           quadratic basis\n"
               "   nodes    value      gradient    value      gradient    value      gradient   enlarged supports\n";
  for (double f : {1., 0.5, 0.25}) {
    const paper::Domain domain = paper::square_with_hole(f);
    const auto nodes = CGAL::npbs_place_nodes(paper::triangulate(domain),
                                              CGAL::parameters::sizing_function(domain.d));
    std::vector<double> values;
    for (const Point& p : nodes.points)
      values.push_back(u(p));
    const Influence influence(nodes, CGAL::parameters::support_factor(2.5));

    std::cout << std::setw(8) << nodes.size() << std::scientific << std::setprecision(2);
    std::size_t number_of_enlarged = 0;
    for (Basis basis : {Basis::CONSTANT, Basis::LINEAR, Basis::QUADRATIC}) {
      const Mls mls(influence, CGAL::parameters::mls_basis(basis));
      const Mls::Values result = mls.evaluate(points, values, 1);
      double error = 0, gradient_error = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        error = (std::max)(error, std::abs(result.values[i] - u(points[i])));
        gradient_error = (std::max)(gradient_error, std::hypot(result.dx[i] - u_x(points[i]),
                                                              result.dy[i] - u_y(points[i])));
      }
      number_of_enlarged += result.number_of_enlarged_supports;
      std::cout << std::setw(12) << error << std::setw(11) << gradient_error;
    }
    std::cout << std::setw(11) << number_of_enlarged << '\n';
  }
}
