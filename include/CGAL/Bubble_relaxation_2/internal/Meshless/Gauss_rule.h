// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GAUSS_RULE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GAUSS_RULE_H

#include <Eigen/Eigenvalues>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Points and weights on [0, 1].
struct Gauss_rule
{
  std::vector<double> points, weights;

  std::size_t size() const { return points.size(); }
};

/// Gauss's rule of `n` points for the weight function (1 - t)^exponent on [0, 1]: exact for polynomials up to
/// degree 2 n - 1. `exponent` is 0 (Legendre) or 1, which is what collapses a square to a triangle.
/// The points are the eigenvalues of the tridiagonal matrix of the three-term recurrence of the orthogonal
/// (Jacobi) polynomials (Golub and Welsch, Math. Comp. 23, 1969).
inline Gauss_rule gauss_rule(std::size_t n, int exponent = 0)
{
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size), beside(size > 1 ? size - 1 : 0);
  for (Eigen::Index k = 0; k < size; ++k) {
    const double i = static_cast<double>(k), j = i + 1;
    if (exponent == 1)
      diagonal[k] = -1 / ((2 * i + 1) * (2 * i + 3));
    if (j < static_cast<double>(n))
      beside[k] = exponent == 1 ? std::sqrt(j * (j + 1)) / (2 * j + 1) : j / std::sqrt(4 * j * j - 1);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside);
  Gauss_rule rule;
  for (Eigen::Index k = 0; k < size; ++k) {
    const double first = solver.eigenvectors()(0, k);
    rule.points.push_back((1 + solver.eigenvalues()[k]) / 2);
    rule.weights.push_back(first * first / (exponent + 1));
  }
  return rule;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GAUSS_RULE_H
