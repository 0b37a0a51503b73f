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
#include <random>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A preconditioner as Eigen's iterations want them: a factorization, perhaps incomplete, of the symmetric part
/// (A + A^T) / 2 of a matrix that is symmetric but for a little.
template <class Factorization>
class Symmetric_part_preconditioner
{
  using Matrix = Eigen::SparseMatrix<double>;

public:
  template <class Any_matrix>
  Symmetric_part_preconditioner& compute(const Any_matrix& a)
  {
    const Matrix matrix(a), transposed(matrix.transpose());
    m_factorization.compute(Matrix(0.5 * (matrix + transposed)));
    return *this;
  }

  template <class Any_matrix>
  Symmetric_part_preconditioner& analyzePattern(const Any_matrix&)
  {
    return *this;
  }

  template <class Any_matrix>
  Symmetric_part_preconditioner& factorize(const Any_matrix& a)
  {
    return compute(a);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return m_factorization.solve(b); }

  Eigen::ComputationInfo info() const { return m_factorization.info(); }

  const Factorization& factorization() const { return m_factorization; }

private:
  Factorization m_factorization;
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
  using Cholesky = Eigen::SimplicialLDLT<Matrix>;
  using Incomplete_cholesky = Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>>;

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
  bool solve_incompletely()
  {
    Eigen::BiCGSTAB<Matrix, Symmetric_part_preconditioner<Incomplete_cholesky>> iteration(m_a);
    iteration.setMaxIterations(1000);
    iteration.setTolerance((std::max)(m_tolerance, 1e-14));
    return iterate(iteration);
  }

  bool solve_by_cholesky()
  {
    Eigen::BiCGSTAB<Matrix, Symmetric_part_preconditioner<Cholesky>> iteration(m_a);
    if (iteration.preconditioner().info() != Eigen::Success ||
        !(iteration.preconditioner().factorization().vectorD().minCoeff() > 0))
      return false;
    check_condition(iteration.preconditioner());
    iteration.setMaxIterations(50);
    iteration.setTolerance(1e-14); // a step is cheap
    return iterate(iteration);
  }

  void solve_by_lu()
  {
    Eigen::SparseLU<Matrix> lu;
    lu.compute(m_a);
    if (lu.info() != Eigen::Success)
      throw_singular("it has no factorization");
    check_condition(lu);
    m_solution.x = lu.solve(m_b);
    for (int k = 0; k < most_improvements; ++k) {
      m_solution.x += lu.solve(m_b - m_a * m_solution.x);
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
  template <class Iteration>
  bool iterate(Iteration& iteration)
  {
    if (iteration.preconditioner().info() != Eigen::Success)
      return false;
    m_solution.x = Vector::Zero(m_b.size());
    for (int k = 0; k < most_improvements; ++k) {
      m_solution.x += iteration.solve(m_b - m_a * m_solution.x);
      if (!m_solution.x.allFinite())
        return false;
      if (is_good_enough())
        return true;
    }
    return false;
  }

  bool is_good_enough()
  {
    const double residual = (m_b - m_a * m_solution.x).cwiseAbs().maxCoeff();
    const double size = m_norm * m_solution.x.cwiseAbs().maxCoeff() + m_b.cwiseAbs().maxCoeff();
    m_solution.residual = size > 0 ? residual / size : 0.;
    return m_solution.residual <= m_tolerance;
  }

  /// the growth of a vector without structure tells the condition number but for a factor
  template <class Factorization>
  void check_condition(const Factorization& factorization)
  {
    constexpr double largest_condition_number = 1e14; // beyond, a solution has no digit
    std::minstd_rand random(1);
    Vector vector(m_b.size()); // of numbers in [-1, 1]
    for (Eigen::Index i = 0; i < vector.size(); ++i)
      vector[i] = 2 * static_cast<double>(random()) / static_cast<double>(random.max()) - 1;
    const Vector grown = factorization.solve(vector);
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
