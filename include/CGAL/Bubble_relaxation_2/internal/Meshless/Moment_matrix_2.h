// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MOMENT_MATRIX_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MOMENT_MATRIX_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Weighted_node_2.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the number of monomials in x and y up to a degree
constexpr int number_of_monomials(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// the monomials of degree d in x and y after those of lower degree in m
template <int d, class Vector>
void add_monomials(double x, double y, Vector& m)
{
  constexpr int i = number_of_monomials(d - 1);
  m[i] = m[i - d] * x;
  for (int b = 0; b < d; ++b)
    m[i + 1 + b] = m[i - d + b] * y;
}

/// 1, x, y, x^2, xy, y^2, x^3 ...: x^a y^b has the index number_of_monomials(a + b - 1) + b
template <int degree>
Eigen::Matrix<double, number_of_monomials(degree), 1> monomials(double x, double y)
{
  Eigen::Matrix<double, number_of_monomials(degree), 1> m;
  m[0] = 1;
  if constexpr (degree > 0)
    add_monomials<1>(x, y, m);
  if constexpr (degree > 1)
    add_monomials<2>(x, y, m);
  if constexpr (degree > 2)
    add_monomials<3>(x, y, m);
  if constexpr (degree > 3)
    add_monomials<4>(x, y, m);
  return m;
}

/// The moment matrix A = sum of w_i p_i p_i^T of moving least squares, where p_i are the monomials up to
/// `degree` at the i-th node, centred at the point of evaluation and scaled.
template <int degree>
class Moment_matrix_2
{
public:
  static constexpr int size = number_of_monomials(degree);
  using Vector = Eigen::Matrix<double, size, 1>;

  explicit Moment_matrix_2(const std::vector<Weighted_node_2>& nodes)
  {
    // products of two monomials are monomials: their sums are all that is needed
    using Moments = Eigen::Matrix<double, number_of_monomials(2 * degree), 1>;
    Moments moments = Moments::Zero();
    for (const Weighted_node_2& n : nodes)
      moments += n.w * monomials<2 * degree>(n.x, n.y);
    for (int d = 0, i = 0; d <= degree; ++d)
      for (int b = 0; b <= d; ++b, ++i)
        for (int e = 0, j = 0; e <= degree; ++e)
          for (int c = 0; c <= e; ++c, ++j)
            m_matrix(i, j) = moments[number_of_monomials(d + e - 1) + b + c];
    m_cholesky.compute(m_matrix);
  }

  /// The condition number if it exceeds `limit`, else a bound for it that does not either.
  double condition_number(double limit) const
  {
    const double bound = condition_bound();
    if (bound <= limit)
      return bound;
    const auto values = Decomposition(m_matrix).singularValues(); // eigenvalues, since they are not negative
    return values[size - 1] > 0 ? values[0] / values[size - 1] : std::numeric_limits<double>::infinity();
  }

  Vector solve(const Vector& b) const { return m_cholesky.solve(b); }

  /// The least of all solutions that come nearest: parts that hardly matter to the matrix are left out. What is
  /// least depends on the unit of length; here it is `unit` times that of the nodes.
  Vector pseudo_solve(const Vector& b, double unit) const
  {
    const Vector scale = monomials<degree>(1 / unit, 1 / unit);
    const Any_matrix scaled = scale.asDiagonal() * m_matrix * scale.asDiagonal();
    Decomposition decomposition(scaled, Eigen::ComputeFullU | Eigen::ComputeFullV);
    decomposition.setThreshold(1e-12);
    const Any_vector any = scale.cwiseProduct(b);
    return scale.cwiseProduct(Vector(decomposition.solve(any)));
  }

private:
  using Matrix = Eigen::Matrix<double, size, size>;
  // what is rarely needed has one type for all sizes, since it takes compilers long
  static constexpr int largest_size = number_of_monomials(2);
  using Any_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, largest_size, largest_size>;
  using Any_vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, largest_size, 1>;
  using Decomposition = Eigen::JacobiSVD<Any_matrix, Eigen::NoQRPreconditioner>;

  /// A bound from what is at hand. Divided by the roots of its diagonal the matrix has ones there, hence the
  /// trace n, and a determinant D; if l is its least eigenvalue, the inequality of the means for the others
  /// says D <= l ((n - l)/(n - 1))^(n - 1) <= l (n/(n - 1))^(n - 1). The least eigenvalue of the matrix itself is
  /// at least l times the least element of the diagonal, and the largest at most the trace.
  double condition_bound() const
  {
    if (m_cholesky.info() != Eigen::Success)
      return std::numeric_limits<double>::infinity();
    double d = 1;
    for (int i = 0; i < size; ++i)
      d *= m_cholesky.matrixLLT()(i, i) * m_cholesky.matrixLLT()(i, i) / m_matrix(i, i);
    double least = d;
    for (int i = 1; i < size; ++i)
      least *= (size - 1.) / size;
    return least > 0 ? m_matrix.trace() / (least * m_matrix.diagonal().minCoeff())
                     : std::numeric_limits<double>::infinity();
  }

  Matrix m_matrix;
  Eigen::LLT<Matrix> m_cholesky;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MOMENT_MATRIX_2_H
