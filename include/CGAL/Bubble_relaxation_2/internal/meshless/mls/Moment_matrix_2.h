// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MOMENT_MATRIX_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MOMENT_MATRIX_2_H

#include <CGAL/Bubble_relaxation_enums.h>

#include <Eigen/Core>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// \file
/// Weights of moving least squares as functions of q, the distance from the node in units of its support
/// radius. All decrease from q = 0 to 0 at q = 1, as (1 - q)^3, so that two derivatives are continuous there.

/// A weight W and what its derivatives in the plane are made of: for a vector u of length q,
/// grad W = g u and the Hessian is g I + h u u^T.
struct Radial_weight
{
  double w;
  double g; ///< W'/q
  double h; ///< g'/q; where it grows without bounds for q -> 0, h u u^T still vanishes, and h is 0 at q = 0
};

/// 1 - 6 q^2 + 8 q^3 - 3 q^4
inline Radial_weight quartic_spline_weight(double q)
{
  const double r = 1 - q;
  return {r * r * r * (1 + 3 * q), -12 * r * r, q > 0 ? 24 * r / q : 0};
}

/// 2/3 - 4 q^2 + 4 q^3 up to q = 1/2, and 4/3 (1 - q)^3 from there
inline Radial_weight cubic_spline_weight(double q)
{
  if (q <= 0.5)
    return {2. / 3 - 4 * q * q * (1 - q), 12 * q - 8, q > 0 ? 12 / q : 0};
  const double r = 1 - q;
  return {4. / 3 * r * r * r, -4 * r * r / q, 4 * r * (1 + q) / (q * q * q)};
}

/// exp(t) - 1 - t - t^2/2 for t >= 0 without the cancellation for small t
inline double remainder_of_exp(double t)
{
  if (t > 1)
    return std::exp(t) - 1 - t - t * t / 2;
  double sum = 1;
  for (int k = 17; k > 3; --k) // the first term left out is below 1e-16 of the sum
    sum = 1 + sum * t / k;
  return t * t * t / 6 * sum;
}

/// exp(-(q/c)^2) with c = 0.4, less its Taylor polynomial of second order in q^2 about q = 1: with
/// b = 1/c^2 and t = b (1 - q^2) that is exp(-b) (exp(t) - 1 - t - t^2/2), a positive number.
inline Radial_weight gaussian_weight(double q)
{
  constexpr double b = 6.25;
  static const double rim = std::exp(-b);
  const double t = b * (1 - q) * (1 + q);
  const double third = remainder_of_exp(t);
  const double second = third + t * t / 2; // the remainder after one term less, the derivative of the above
  const double first = second + t;
  return {rim * third, -2 * b * rim * second, 4 * b * b * rim * first};
}

inline Radial_weight radial_weight(Moving_least_squares_weight weight, double q)
{
  switch (weight) {
  case Moving_least_squares_weight::QUARTIC_SPLINE:
    return quartic_spline_weight(q);
  case Moving_least_squares_weight::CUBIC_SPLINE:
    return cubic_spline_weight(q);
  default:
    return gaussian_weight(q);
  }
}

/// A node in whose support the point of evaluation lies. All is in units of one length, so that neither
/// powers nor second derivatives leave the range of numbers, whatever the unit of the coordinates is.
struct Weighted_node_2
{
  double x, y;          ///< from the point of evaluation to the node
  double radius;        ///< of its support
  double w;             ///< weight
  double wx, wy;        ///< its derivatives by the point of evaluation
  double wxx, wxy, wyy;
  double s, sx, sy;     ///< the factor that makes the shape function of the weight, and its derivatives
  double sxx, sxy, syy;
};

/// Fills in weights and the derivatives that are asked for.
inline void weigh(Moving_least_squares_weight kind, std::vector<Weighted_node_2>& nodes, int number_of_derivatives)
{
  for (Weighted_node_2& n : nodes) {
    const double scale = 1 / n.radius;
    const double ux = -n.x * scale;
    const double uy = -n.y * scale;
    const double q = std::sqrt(ux * ux + uy * uy);
    const Radial_weight weight = q < 1 ? radial_weight(kind, q) : Radial_weight{0, 0, 0};
    n.w = weight.w;
    if (number_of_derivatives < 1)
      continue;
    n.wx = weight.g * ux * scale;
    n.wy = weight.g * uy * scale;
    if (number_of_derivatives < 2)
      continue;
    n.wxx = (weight.g + weight.h * ux * ux) * scale * scale;
    n.wxy = weight.h * ux * uy * scale * scale;
    n.wyy = (weight.g + weight.h * uy * uy) * scale * scale;
  }
}

/// the number of monomials in x and y up to a degree
constexpr int number_of_monomials(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// 1, x, y, x^2, xy, y^2, x^3 ...: x^a y^b has the index number_of_monomials(a + b - 1) + b
template <int degree>
using Monomials = std::array<double, number_of_monomials(degree)>;

template <int degree>
Monomials<degree> monomials(double x, double y)
{
  Monomials<degree> m;
  m[0] = 1;
  for (int d = 1, i = 1; d <= degree; ++d) {
    m[i] = m[i - d] * x;
    for (int b = 0; b < d; ++b)
      m[i + 1 + b] = m[i - d + b] * y;
    i += d + 1;
  }
  return m;
}

// Plain loops instead of Eigen's matrices of fixed size, which take compilers long; the order of sums is theirs.

/// sums up n numbers, `step` apart, by halves
inline double sum_by_halves(const double* t, int n, int step = 1)
{
  if (n < 2)
    return n < 1 ? 0 : t[0];
  return sum_by_halves(t, n / 2, step) + sum_by_halves(t + n / 2 * step, n - n / 2, step);
}

/// sums up n numbers: those of even places, those of odd ones, and what is left
inline double sum_by_pairs(const double* t, int n)
{
  if (n < 4)
    return n == 3 ? t[0] + t[1] + t[2] : sum_by_halves(t, n);
  const double sum = sum_by_halves(t, n / 2, 2) + sum_by_halves(t + 1, n / 2, 2);
  return n % 2 == 0 ? sum : sum + t[n - 1];
}

template <std::size_t n>
double dot(const std::array<double, n>& a, const std::array<double, n>& b)
{
  if constexpr (n == 1)
    return a[0] * b[0];
  else if constexpr (n == 3)
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  else
    return (a[0] * b[0] + (a[2] * b[2] + a[4] * b[4])) + (a[1] * b[1] + (a[3] * b[3] + a[5] * b[5]));
}

template <std::size_t n>
void add(std::array<double, n>& sum, double factor, const std::array<double, n>& a)
{
  for (std::size_t i = 0; i < n; ++i)
    sum[i] += factor * a[i];
}

/// The moment matrix A = sum of w_i p_i p_i^T of moving least squares, where p_i are the monomials up to
/// `degree` at the i-th node, centred at the point of evaluation and scaled.
template <int degree>
class Moment_matrix_2
{
public:
  static constexpr int size = number_of_monomials(degree);
  using Vector = Monomials<degree>;

  explicit Moment_matrix_2(const std::vector<Weighted_node_2>& nodes)
  {
    // products of two monomials are monomials: their sums are all that is needed
    Monomials<2 * degree> moments{};
    for (const Weighted_node_2& n : nodes)
      add(moments, n.w, monomials<2 * degree>(n.x, n.y));
    for (int d = 0, i = 0; d <= degree; ++d)
      for (int b = 0; b <= d; ++b, ++i)
        for (int e = 0, j = 0; e <= degree; ++e)
          for (int c = 0; c <= e; ++c, ++j)
            m_matrix[i][j] = moments[number_of_monomials(d + e - 1) + b + c];
    factorize();
  }

  /// The condition number if it exceeds `limit`, else a bound for it that does not either.
  double condition_number(double limit) const
  {
    const double bound = condition_bound();
    if (bound <= limit)
      return bound;
    Vector ones;
    ones.fill(1);
    const auto values = Decomposition(scaled(ones)).singularValues(); // eigenvalues, since they are not negative
    return values[size - 1] > 0 ? values[0] / values[size - 1] : std::numeric_limits<double>::infinity();
  }

  /// from now on `solve()` does as `pseudo_solve()`
  void use_pseudo_inverse(double unit) { m_unit = unit; }

  /// \pre the condition number is finite, unless the pseudo-inverse is used
  Vector solve(const Vector& b) const
  {
    if (m_unit > 0)
      return pseudo_solve(b);
    Vector x = b;
    std::array<double, size> terms;
    for (int i = 0; i < size; ++i) {
      for (int k = 0; k < i; ++k)
        terms[k] = m_lower[i][k] * x[k];
      x[i] = (x[i] - sum_by_halves(terms.data(), i)) / m_lower[i][i];
    }
    for (int i = size; i-- > 0;) {
      for (int k = i + 1; k < size; ++k)
        terms[k] = m_lower[k][i] * x[k];
      x[i] = (x[i] - sum_by_pairs(terms.data() + i + 1, size - i - 1)) / m_lower[i][i];
    }
    return x;
  }

private:
  using Matrix = std::array<Vector, size>;
  // what is rarely needed has types that are needed elsewhere too, since each takes compilers long
  using Decomposition = Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner>;

  /// rows and columns times the elements of a vector
  Eigen::MatrixXd scaled(const Vector& scale) const
  {
    Eigen::MatrixXd result(size, size);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        result(i, j) = scale[i] * m_matrix[i][j] * scale[j];
    return result;
  }

  /// The least of all solutions that come nearest: parts that hardly matter to the matrix are left out. What is
  /// least depends on the unit of length.
  Vector pseudo_solve(const Vector& b) const
  {
    const Vector scale = monomials<degree>(1 / m_unit, 1 / m_unit);
    Decomposition decomposition(scaled(scale), Eigen::ComputeFullU | Eigen::ComputeFullV);
    decomposition.setThreshold(1e-12);
    Eigen::VectorXd any(size);
    for (int i = 0; i < size; ++i)
      any[i] = scale[i] * b[i];
    const Eigen::VectorXd solution = decomposition.solve(any);
    Vector result;
    for (int i = 0; i < size; ++i)
      result[i] = scale[i] * solution[i];
    return result;
  }

  /// Cholesky's factorization
  void factorize()
  {
    m_lower = m_matrix;
    for (int k = 0; k < size; ++k) {
      const double pivot = m_lower[k][k] - product_of_rows(k, k);
      if (!(pivot > 0))
        return;
      m_lower[k][k] = std::sqrt(pivot);
      for (int i = k + 1; i < size; ++i)
        m_lower[i][k] = (m_lower[i][k] - product_of_rows(i, k)) / m_lower[k][k];
    }
    m_is_definite = true;
  }

  /// of the first k elements
  double product_of_rows(int i, int k) const
  {
    double sum = 0;
    for (int j = 0; j < k; ++j)
      sum += m_lower[i][j] * m_lower[k][j];
    return sum;
  }

  /// A bound from what is at hand. Divided by the roots of its diagonal the matrix has ones there, hence the
  /// trace n, and a determinant D; if l is its least eigenvalue, the inequality of the means for the others
  /// says D <= l ((n - l)/(n - 1))^(n - 1) <= l (n/(n - 1))^(n - 1). The least eigenvalue of the matrix itself is
  /// at least l times the least element of the diagonal, and the largest at most the trace.
  double condition_bound() const
  {
    if (!m_is_definite)
      return std::numeric_limits<double>::infinity();
    Vector diagonal;
    double least = 1;
    for (int i = 0; i < size; ++i) {
      diagonal[i] = m_matrix[i][i];
      least *= m_lower[i][i] * m_lower[i][i] / diagonal[i];
    }
    for (int i = 1; i < size; ++i)
      least *= (size - 1.) / size;
    return least > 0 ? sum_by_halves(diagonal.data(), size) /
                         (least * *std::min_element(diagonal.begin(), diagonal.end()))
                     : std::numeric_limits<double>::infinity();
  }

  Matrix m_matrix;
  Matrix m_lower; // the factor, above which lies what does not matter
  bool m_is_definite = false;
  double m_unit = 0; // of the pseudo-inverse, times that of the nodes; 0: that is not used
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_MOMENT_MATRIX_2_H
