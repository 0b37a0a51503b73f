// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_SOLVER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_SOLVER_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A preconditioner as Eigen's iterations want them, of any function: an iteration of one type compiles once.
class Any_preconditioner
{
public:
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> function;

  template <class Matrix>
  Any_preconditioner& analyzePattern(const Matrix&) { return *this; }
  template <class Matrix>
  Any_preconditioner& factorize(const Matrix&) { return *this; }
  template <class Matrix>
  Any_preconditioner& compute(const Matrix&) { return *this; }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return function(b); }
  Eigen::ComputationInfo info() const { return Eigen::Success; }
};

/// A solution of a sparse system and how good it is.
struct Sparse_solution
{
  Eigen::VectorXd x;
  double residual = 0;         ///< |b - A x| / (|A| |x| + |b|), in the maximum norm
  double condition_number = 0; ///< of the matrix, a lower bound; 0 if it is not known
};

/// Solves sparse systems, most of which are symmetric and definite but for a little: by Cholesky's factorization of
/// the symmetric part, and by an iteration (BiCGSTAB) for what it leaves, which takes two or three steps. In large
/// systems the factorization is an incomplete one; they are in an order of space, which it likes, and it takes
/// about a hundred steps then. Others, and what fails, are solved by LU factorization.
class Sparse_solver
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;
  using Function = std::function<Vector(const Vector&)>; // such as what a factorization makes of a right side

public:
  Sparse_solver(const Matrix& a, const Vector& b, double tolerance)
    : m_a(a), m_b(b), m_tolerance(tolerance), m_norm(maximum_norm(a))
  {}

  /// \throws std::runtime_error if the system is singular, or if the residual stays above the tolerance
  Sparse_solution operator()(bool is_nearly_definite)
  {
    constexpr Eigen::Index largest_factorized = 5000;
    if (is_nearly_definite && m_a.rows() > largest_factorized && solve_incompletely())
      return m_solution;
    if (is_nearly_definite && solve_by_cholesky())
      return m_solution;
    solve_by_lu();
    return m_solution;
  }

private:
  Matrix symmetric_part() const
  {
    const Matrix transposed = m_a.transpose();
    Matrix result = m_a + transposed;
    result *= 0.5;
    return result;
  }

  bool solve_incompletely()
  {
    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky;
    cholesky.compute(symmetric_part());
    return cholesky.info() == Eigen::Success &&
           iterate([&](const Vector& b) -> Vector { return cholesky.solve(b); }, 1000, (std::max)(m_tolerance, 1e-14));
  }

  bool solve_by_cholesky()
  {
    Eigen::SimplicialLDLT<Matrix> cholesky;
    cholesky.compute(symmetric_part());
    if (cholesky.info() != Eigen::Success || !(cholesky.vectorD().minCoeff() > 0))
      return false;
    const Function solve = [&](const Vector& b) -> Vector { return cholesky.solve(b); };
    check_condition(solve);
    return iterate(solve, 50, 1e-14); // a step is cheap
  }

  void solve_by_lu()
  {
    Eigen::SparseLU<Matrix> lu;
    lu.compute(m_a);
    if (lu.info() != Eigen::Success)
      throw_singular("it has no factorization");
    const Function solve = [&](const Vector& b) -> Vector { return lu.solve(b); };
    check_condition(solve);
    m_solution.x = solve(m_b);
    for (int k = 0; k < most_improvements; ++k) {
      m_solution.x += solve(residual());
      if (is_good_enough())
        return;
    }
    constexpr double largest_residual = 1e-6; // of a system that is only badly conditioned
    if (!(m_solution.residual < largest_residual))
      throw_singular("its factorization leaves a residual of " + in_words(m_solution.residual));
    throw std::runtime_error("Bubble_relaxation_2: the residual of the system of " + std::to_string(m_a.rows()) +
                             " equations is " + in_words(m_solution.residual) + " after " +
                             std::to_string(most_improvements) + " improvements and does not reach " +
                             in_words(m_tolerance) + ", as residual_tolerance asks");
  }

  /// returns whether the residual becomes small enough; it is computed anew before each improvement
  bool iterate(const Function& precondition, int most_steps, double tolerance)
  {
    Eigen::BiCGSTAB<Matrix, Any_preconditioner> iteration(m_a);
    iteration.preconditioner().function = precondition;
    iteration.setMaxIterations(most_steps);
    iteration.setTolerance(tolerance);
    m_solution.x = Vector::Zero(m_b.size());
    for (int k = 0; k < most_improvements; ++k) {
      const Vector rest = m_b - m_a * m_solution.x; // sums up in another order than residual()
      m_solution.x += iteration.solve(rest);
      if (!m_solution.x.allFinite())
        return false;
      if (is_good_enough())
        return true;
    }
    return false;
  }

  Vector residual() const
  {
    const Vector product = m_a * m_solution.x;
    return m_b - product;
  }

  bool is_good_enough()
  {
    const double largest = residual().cwiseAbs().maxCoeff();
    const double size = m_norm * m_solution.x.cwiseAbs().maxCoeff() + m_b.cwiseAbs().maxCoeff();
    m_solution.residual = size > 0 ? largest / size : 0.;
    return m_solution.residual <= m_tolerance;
  }

  /// the growth of a vector without structure tells the condition number but for a factor
  void check_condition(const Function& solve)
  {
    constexpr double largest_condition_number = 1e14; // beyond, a solution has no digit
    std::minstd_rand random(1);
    Vector vector(m_b.size()); // of numbers in [-1, 1]
    for (Eigen::Index i = 0; i < vector.size(); ++i)
      vector[i] = 2 * static_cast<double>(random()) / static_cast<double>(random.max()) - 1;
    const Vector grown = solve(vector);
    m_solution.condition_number = m_norm * grown.cwiseAbs().maxCoeff();
    if (!(m_solution.condition_number < largest_condition_number))
      throw_singular("its condition number is at least " + in_words(m_solution.condition_number));
  }

  [[noreturn]] void throw_singular(const std::string& why) const
  {
    throw std::runtime_error("Bubble_relaxation_2: the system of " + std::to_string(m_a.rows()) +
                             " equations is singular: " + why +
                             "; more Gauss points or larger supports may help, or nodes that lie farther apart");
  }

  /// the largest sum of absolute values in a row
  static double maximum_norm(const Matrix& a)
  {
    Vector sums = Vector::Zero(a.rows());
    for (Eigen::Index c = 0; c < a.outerSize(); ++c)
      for (Matrix::InnerIterator entry(a, c); entry; ++entry)
        sums[entry.row()] += std::abs(entry.value());
    return sums.size() > 0 ? sums.maxCoeff() : 0;
  }

  static constexpr int most_improvements = 4;

  const Matrix& m_a;
  const Vector& m_b;
  double m_tolerance, m_norm;
  Sparse_solution m_solution;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_SOLVER_H
