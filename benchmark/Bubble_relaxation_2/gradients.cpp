// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// How well a mesh follows sizes that change fast: the unit square with sizes of a constant gradient g, and
// with kinks. For each field a row with the vertices, the largest |d_i - d_j| / |x_i - x_j| of the mesh's
// edges, mean and smallest q, the smallest angle in degrees, the share of interior vertices of degree other
// than six, and mean and deviation of edge length over d.
//
//   gradients            g = 0.05 to 2
//   gradients 0.25 0.3   these

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/npbs_relax.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace {

using paper::Point;
using paper::Sizing;

void print_header()
{
  std::cout << std::left << std::setw(10) << "field" << std::right << std::setw(6) << "g" << std::setw(8)
            << "N" << std::setw(9) << "largest" << std::setw(8) << "mean q" << std::setw(7) << "min q"
            << std::setw(7) << "angle" << std::setw(8) << "irreg." << std::setw(7) << "L/d" << std::setw(7)
            << "dev." << '\n'
            << std::fixed;
}

void measure(const std::string& name, double g, const Sizing& d)
{
  const paper::Outline square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  paper::CDT cdt = paper::triangulate({square});
  const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  const auto& q = report.quality;
  std::cout << std::left << std::setw(10) << name << std::right << std::setprecision(2) << std::setw(6) << g
            << std::setw(8) << report.number_of_vertices << std::setprecision(3) << std::setw(9)
            << report.largest_size_gradient << std::setprecision(4) << std::setw(8) << q.mean_quality()
            << std::setprecision(3) << std::setw(7) << q.minimum_quality() << std::setprecision(1)
            << std::setw(7) << q.minimum_angle() << std::setw(7) << 100 * q.irregular_share() << '%'
            << std::setprecision(3) << std::setw(7) << q.mean_length_ratio() << std::setw(7)
            << q.length_ratio_deviation() << std::endl;
}

/// fields that have about `n` vertices
void measure_all(double g, double n)
{
  // the integral of 2 / (sqrt(3) d^2) over the square is about 1.15 / (g d0)
  const double least = 1.15 / (g * n);
  measure("ramp", g, [=](const Point& p) { return least + g * p.x(); });
  measure("valley", g, [=](const Point& p) { return 2 * least + g * std::abs(p.x() - 0.5); });
  measure("plateau", g, [=](const Point& p) { return (std::max)(0.0125, g * (p.x() - 0.5)); });
  measure("ridge", g, [=](const Point& p) { return 2 * least + g * (0.5 - std::abs(p.x() - 0.5)); });
  // 7.25 ln(1 / d0) / g^2: a fixed number of vertices for each factor of the size
  measure("cone", g, [=](const Point& p) { return 1e-5 * g + g * paper::distance(p, 0.4, 0.55); });
  measure("disc", g, [=](const Point& p) {
    return (std::max)(0.02, 0.02 + g * (paper::distance(p, 0.4, 0.55) - 0.25));
  });
}

/// a size that jumps by a factor across a circle
void measure_jump(double factor)
{
  measure("jump", factor, [=](const Point& p) {
    return paper::distance(p, 0.4, 0.55) < 0.25 ? 0.01 : 0.01 * factor;
  });
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<double> gradients{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 2};
  if (argc > 1) {
    gradients.clear();
    for (int i = 1; i < argc; ++i)
      gradients.push_back(std::atof(argv[i]));
  }
  print_header();
  for (double g : gradients)
    measure_all(g, 4000);
  for (double factor : {1.25, 1.5, 2., 4.})
    measure_jump(factor);
}
