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
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What a cell adds to the equations: a dense matrix and a vector for a few unknowns.
struct Galerkin_part
{
  std::vector<Index> unknowns; ///< ascending
  Eigen::MatrixXd matrix;      ///< a row a test function
  Eigen::VectorXd load;
};

/// A sparse matrix while parts are added to it. Each entry is the sum of its parts in their order, whatever the
/// number of threads.
class Sparse_rows
{
public:
  explicit Sparse_rows(std::size_t n) : m_rows(n), m_load(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n))) {}

  /// adds the first `number` of parts, which have a `Galerkin_part` for a base
  template <class Part>
  void add(const Threads& threads, const std::vector<Part>& parts, std::size_t number)
  {
    // the rows of all parts, sorted by row; a row is one thread's
    std::vector<Row_of_part> sorted;
    for (std::size_t k = 0; k < number; ++k)
      for (std::size_t r = 0; r < parts[k].unknowns.size(); ++r)
        sorted.push_back(Row_of_part{parts[k].unknowns[r], static_cast<Index>(k), static_cast<Index>(r)});
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Row_of_part& a, const Row_of_part& b) { return a.row < b.row; });
    std::vector<std::size_t> first;
    for (std::size_t k = 0; k < sorted.size(); ++k)
      if (k == 0 || sorted[k].row != sorted[k - 1].row)
        first.push_back(k);
    first.push_back(sorted.size());
    const auto add_to_row = [&](std::size_t i) {
      for (std::size_t k = first[i]; k < first[i + 1]; ++k)
        add_row(sorted[k].row, parts[sorted[k].part], sorted[k].row_of_part);
    };
    parallel_for(threads, first.size() - 1, add_to_row, 1);
  }

  const Eigen::VectorXd& load() const { return m_load; }

  /// the entry on the diagonal; 0 if there is none
  double diagonal(std::size_t i) const
  {
    for (const Entry& e : m_rows[i])
      if (static_cast<std::size_t>(e.column) == i)
        return e.value;
    return 0;
  }

  Eigen::SparseMatrix<double> matrix() const
  {
    const auto n = static_cast<Eigen::Index>(m_rows.size());
    Eigen::VectorXi sizes = Eigen::VectorXi::Zero(n); // of columns
    for (const std::vector<Entry>& row : m_rows)
      for (const Entry& e : row)
        ++sizes[e.column];
    Eigen::SparseMatrix<double> result(n, n);
    result.reserve(sizes);
    for (Eigen::Index i = 0; i < n; ++i)
      for (const Entry& e : m_rows[static_cast<std::size_t>(i)])
        result.insert(i, e.column) = e.value;
    result.makeCompressed();
    return result;
  }

private:
  struct Entry
  {
    Index column;
    double value;
  };

  struct Row_of_part
  {
    Index row, part, row_of_part;
  };

  void add_row(Index row, const Galerkin_part& part, Index row_of_part)
  {
    m_load[row] += part.load[row_of_part];
    std::vector<Entry>& entries = m_rows[static_cast<std::size_t>(row)];
    const std::size_t old_size = entries.size();
    std::size_t k = 0;
    for (std::size_t c = 0; c < part.unknowns.size(); ++c) {
      const Index column = part.unknowns[c];
      const double value = part.matrix(row_of_part, static_cast<Eigen::Index>(c));
      while (k < old_size && entries[k].column < column)
        ++k;
      if (k < old_size && entries[k].column == column)
        entries[k].value += value;
      else
        entries.push_back(Entry{column, value});
    }
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(old_size);
    std::inplace_merge(entries.begin(), middle, entries.end(),
                       [](const Entry& a, const Entry& b) { return a.column < b.column; });
  }

  std::vector<std::vector<Entry>> m_rows; // sorted by columns
  Eigen::VectorXd m_load;
};

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
  /// the mean of the matrix and its transpose, which has entries in the same places
  Matrix symmetric_part() const
  {
    Matrix result = m_a.transpose();
    for (Eigen::Index k = 0; k < result.nonZeros(); ++k)
      result.valuePtr()[k] = (m_a.valuePtr()[k] + result.valuePtr()[k]) * 0.5;
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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_SPARSE_SOLVER_H
