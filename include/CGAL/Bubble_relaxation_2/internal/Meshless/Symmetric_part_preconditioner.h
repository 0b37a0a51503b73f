// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SYMMETRIC_PART_PRECONDITIONER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SYMMETRIC_PART_PRECONDITIONER_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SYMMETRIC_PART_PRECONDITIONER_H
