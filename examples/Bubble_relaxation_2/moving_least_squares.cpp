// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// A function from its values at the nodes, without a mesh: the errors of value and gradient for the three bases,
// as nodes get closer.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Moving_least_squares_2.h>
#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <random>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Influence = CGAL::Influence_domain_2<K>;
using Mls = CGAL::Moving_least_squares_2<K>;
using Basis = CGAL::Moving_least_squares_basis;

double u(const Point& p) { return std::sin(3 * p.x()) * std::exp(p.y()); }
double u_x(const Point& p) { return 3 * std::cos(3 * p.x()) * std::exp(p.y()); }
double u_y(const Point& p) { return u(p); }

double distance_from_center(const Point& p) { return std::hypot(p.x(), p.y()); }

/// a square with a round hole, whose edges are as long as d is there
CDT domain(double f)
{
  const int corners = static_cast<int>(std::lround(16 * CGAL_PI / f));
  const std::vector<Point> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<Point> hole;
  for (int i = 0; i < corners; ++i)
    hole.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / corners), 0.5 * std::sin(2 * CGAL_PI * i / corners)));
  CDT cdt;
  cdt.insert_constraint(square.begin(), square.end(), true);
  cdt.insert_constraint(hole.begin(), hole.end(), true);
  return cdt;
}

/// points of the domain between the nodes
std::vector<Point> points_in_domain(std::size_t n)
{
  std::mt19937 random(1);
  const auto coordinate = [&random] { return 2 * (static_cast<double>(random()) / 4294967296.) - 1; };
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = coordinate(), y = coordinate();
    if (distance_from_center(Point(x, y)) > 0.5)
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
    const auto d = [f](const Point& p) { return f * distance_from_center(p) / 8; };
    const auto nodes = CGAL::npbs_place_nodes(domain(f), CGAL::parameters::sizing_function(d));
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
