// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_SPARSE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_SPARSE_H

#include <CGAL/Bubble_relaxation_2/internal/in_words.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A solution of a sparse system and how good it is.
struct Sparse_solution
{
  Eigen::VectorXd x;
  double residual = 0;         ///< |b - A x| / (|A| |x| + |b|), in the maximum norm
  double condition_number = 0; ///< of the matrix, a lower bound
};

/// the largest sum of absolute values in a row
inline double maximum_norm(const Eigen::SparseMatrix<double>& a)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(a.rows());
  for (Eigen::Index c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(a, c); entry; ++entry)
      sums[entry.row()] += std::abs(entry.value());
  return sums.size() > 0 ? sums.maxCoeff() : 0;
}

[[noreturn]] inline void throw_singular(Eigen::Index n, const std::string& why)
{
  throw std::runtime_error("Bubble_relaxation_2: the system of " + std::to_string(n) +
                           " equations is singular: " + why +
                           "; more Gauss points, larger supports or nodes farther apart may help");
}

/// Solves by a factorization that was computed, and improves the solution once, or as often as the residual
/// asks for.
template <class Factorization>
Sparse_solution solve_factorized(const Factorization& factorization, const Eigen::SparseMatrix<double>& a,
                                 const Eigen::VectorXd& b, double tolerance)
{
  Sparse_solution result;
  const Eigen::Index n = a.rows();
  if (factorization.info() != Eigen::Success)
    throw_singular(n, "it has no factorization");
  // the growth of a vector without structure tells the condition number but for a factor
  std::minstd_rand random(1);
  Eigen::VectorXd signs(n);
  for (Eigen::Index i = 0; i < n; ++i)
    signs[i] = random() % 2 == 0 ? 1. : -1.;
  const double norm = maximum_norm(a);
  result.condition_number = norm * Eigen::VectorXd(factorization.solve(signs)).cwiseAbs().maxCoeff();
  constexpr double largest_condition_number = 1e14; // beyond, a solution has no digit
  if (!(result.condition_number < largest_condition_number))
    throw_singular(n, "its condition number is at least " + in_words(result.condition_number));

  constexpr int most_improvements = 4;
  result.x = factorization.solve(b);
  for (int k = 0; k <= most_improvements; ++k) {
    const Eigen::VectorXd r = b - a * result.x;
    const double size = norm * result.x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
    result.residual = size > 0 ? r.cwiseAbs().maxCoeff() / size : 0.;
    if (k > 0 && result.residual <= tolerance)
      return result;
    result.x += factorization.solve(r);
  }
  throw std::runtime_error("Bubble_relaxation_2: the residual of the system of " + std::to_string(n) +
                           " equations is " + in_words(result.residual) + " after " +
                           std::to_string(most_improvements) + " improvements and does not reach " +
                           in_words(tolerance));
}

/// Solves a sparse system directly.
/// \throws std::runtime_error if it is singular, or if the residual stays above the tolerance
inline Sparse_solution solve_sparse(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b, bool is_definite,
                                    double tolerance)
{
  if (is_definite) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt(a);
    return solve_factorized(ldlt, a, b, tolerance);
  }
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu;
  lu.compute(a);
  return solve_factorized(lu, a, b, tolerance);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_SPARSE_H
