// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_GALERKIN_PROBLEMS_H
#define BUBBLE_RELAXATION_2_TEST_GALERKIN_PROBLEMS_H

#include "domains.h"
#include "random_seeds.h"

#include <CGAL/Element_free_Galerkin_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

/// Problems with known solutions, nodes, and a solver whose parameters are known when it runs: one type of named
/// parameters compiles once.
namespace galerkin {

using domains::CDT;
using domains::K;
using domains::Point;
using Vector = K::Vector_2;
using Problem = CGAL::Poisson_problem_2<K>;
using Nodes = CGAL::Node_set_2<Point>;
using Solver = CGAL::Element_free_Galerkin_2<CDT>;
using Solution = Solver::Solution;
using Basis = CGAL::Moving_least_squares_basis;
using Cells = CGAL::Integration_cells;
using Dirichlet = CGAL::Dirichlet_condition;

/// a function, its gradient and its Laplacian
struct Exact
{
  std::function<double(const Point&)> u;
  std::function<Vector(const Point&)> gradient;
  std::function<double(const Point&)> laplacian;

  /// the problem that it solves; `is_dirichlet` tells where it is given on the boundary
  Problem problem(std::function<bool(const Point&)> is_dirichlet = nullptr) const
  {
    Problem p;
    const Exact e = *this;
    p.source = [e](const Point& q) { return -e.laplacian(q); };
    p.dirichlet = u;
    p.neumann = [e](const Point& q, const Vector& n) { return n * e.gradient(q); };
    p.is_dirichlet = std::move(is_dirichlet);
    return p;
  }
};

/// the problem of the paper (eq. 9)
inline Exact paper_problem()
{
  const auto u = [](const Point& p) { return std::exp(p.x() * p.y()); };
  return Exact{u, [u](const Point& p) { return Vector(p.y(), p.x()) * u(p); },
               [u](const Point& p) { return (p.x() * p.x() + p.y() * p.y()) * u(p); }};
}

inline Exact linear()
{
  return Exact{[](const Point& p) { return 1 + 2 * p.x() - 3 * p.y(); }, [](const Point&) { return Vector(2, -3); },
               [](const Point&) { return 0.; }};
}

inline Exact quadratic()
{
  return Exact{
    [](const Point& p) { return 1 + 2 * p.x() - 3 * p.y() + p.x() * p.x() - 2 * p.x() * p.y() + 3 * p.y() * p.y(); },
    [](const Point& p) { return Vector(2 + 2 * p.x() - 2 * p.y(), -3 - 2 * p.x() + 6 * p.y()); },
    [](const Point&) { return 8.; }};
}

/// n x n nodes in the unit square, the inner ones moved by up to `jitter` times their distance; those in `is_hole`
/// are left out
inline Nodes grid(int n, double jitter = 0, const std::function<bool(const Point&)>& is_hole = nullptr)
{
  std::mt19937 random(random_seeds::seed(7));
  Nodes nodes;
  const double h = 1. / (n - 1);
  const auto shift = [&](int i) {
    const double s = 2 * h * jitter * (static_cast<double>(random()) / 4294967296. - 0.5);
    return i == 0 || i == n - 1 ? 0. : s;
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = h * i + shift(i), y = h * j + shift(j);
      if (is_hole && is_hole(Point(x, y)))
        continue;
      nodes.points.push_back(Point(i == n - 1 ? 1 : x, j == n - 1 ? 1 : y));
      nodes.sizes.push_back(h);
    }
  return nodes;
}

inline CDT square() { return domains::make({domains::square(0, 0, 1)}); }

/// a square hole that no line of nodes fits
inline CDT square_with_hole() { return domains::make({domains::square(0, 0, 1), domains::square(0.41, 0.33, 0.26)}); }

inline bool is_in_hole(const Point& p) { return p.x() > 0.41 && p.x() < 0.67 && p.y() > 0.33 && p.y() < 0.59; }

struct Options
{
  double support_factor = 2.5;
  Basis basis = Basis::LINEAR;
  Cells cells = Cells::TRIANGLES;
  int grid_cells = 12;
  double gauss_points = 3;
  Dirichlet dirichlet = Dirichlet::NITSCHE;
  double penalty_factor = 1e4;
  double nitsche_factor = 30;
  bool consistent = true;
  double residual_tolerance = 1e-12;
  CGAL::Deficient_support deficient_support = CGAL::Deficient_support::ENLARGE;
  std::function<bool(double)> callback;

  auto parameters() const
  {
    return CGAL::parameters::support_factor(support_factor)
      .mls_basis(basis)
      .integration_cells(cells)
      .grid_cells(grid_cells)
      .number_of_gauss_points(gauss_points)
      .dirichlet_condition(dirichlet)
      .penalty_factor(penalty_factor)
      .nitsche_factor(nitsche_factor)
      .consistent_integration(consistent)
      .residual_tolerance(residual_tolerance)
      .deficient_support(deficient_support)
      .callback(callback);
  }
};

/// the paper's: 12 x 12 cells, 2 x 2 points, penalty, radius 0.15 where the nodes are 1/11 apart
inline Options paper_options(double penalty_factor)
{
  Options o;
  o.support_factor = 0.15 * 11;
  o.cells = Cells::GRID;
  o.gauss_points = 2;
  o.dirichlet = Dirichlet::PENALTY;
  o.penalty_factor = penalty_factor;
  o.consistent = false;
  return o;
}

inline Solution solve(const CDT& cdt, const Nodes& nodes, const Problem& problem, const Options& o)
{
  return Solver(cdt, nodes, o.parameters()).solve(problem);
}

inline CGAL::Element_free_Galerkin_error_2 error(const CDT& cdt, const Nodes& nodes, const Exact& exact,
                                               const Options& o,
                                               std::function<bool(const Point&)> is_dirichlet = nullptr)
{
  return solve(cdt, nodes, exact.problem(std::move(is_dirichlet)), o).error(exact.u, exact.gradient);
}

} // namespace galerkin

#endif // BUBBLE_RELAXATION_2_TEST_GALERKIN_PROBLEMS_H
