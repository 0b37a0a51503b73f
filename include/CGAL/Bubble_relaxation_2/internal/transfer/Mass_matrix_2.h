// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_MASS_MATRIX_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_MASS_MATRIX_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Compensated_sum.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The mass matrix of the hat functions of a mesh: for each two of them the integral of their product.
class Mass_matrix_2
{
public:
  using Vector = std::vector<double>;

  explicit Mass_matrix_2(const Face_set_2& faces)
    : m_faces(faces), m_areas(faces.areas()), m_lumped(faces.points.size(), 0)
  {
    for (std::size_t t = 0; t < m_areas.size(); ++t)
      for (Index v : faces.triangles[t])
        m_lumped[v] += m_areas[t] / 3;
  }

  const std::vector<double>& areas() const { return m_areas; } ///< of the triangles

  /// the sums of rows: the integrals of the hat functions
  const Vector& lumped() const { return m_lumped; }

  Vector operator*(const Vector& x) const
  {
    Vector y(x.size(), 0);
    for (std::size_t t = 0; t < m_areas.size(); ++t) {
      const std::array<Index, 3>& v = m_faces.triangles[t];
      const double sum = x[v[0]] + x[v[1]] + x[v[2]];
      for (Index i : v)
        y[i] += m_areas[t] / 12 * (x[i] + sum);
    }
    return y;
  }

  /// the integral of the function with these values at the vertices
  double integral(const Vector& x) const { return sum_of_products(m_lumped, x); }

  /// Solves for the free vertices; at others the result is 0. By Chebyshev's iteration, preconditioned with the
  /// diagonal: the eigenvalues lie between 1/2 and 2 then, however bad the triangles are (Wathen, IMA J. Numer. Anal. 7
  /// (1987)), so each step makes the error three times smaller (Wathen and Rees, ETNA 34 (2009)). Unlike conjugate
  /// gradients it has no products of whole vectors, in which small triangles would vanish beside large ones: the result
  /// depends on the residual linearly, and far away from it not at all.
  Vector solve(Vector residual, const std::vector<char>& is_free) const
  {
    constexpr double middle = 1.25, half_width = 0.75; // of the interval of eigenvalues
    Vector x(residual.size(), 0), step(residual.size(), 0);
    double rho = 0;
    for (int k = 0; k < number_of_steps; ++k) {
      const double next_rho = k == 0 ? half_width / middle : 1 / (2 * middle / half_width - rho);
      const double kept = k == 0 ? 0 : next_rho * rho, taken = k == 0 ? 1 / middle : 2 * next_rho / half_width;
      for (std::size_t i = 0; i < x.size(); ++i)
        if (is_free[i]) {
          step[i] = kept * step[i] + taken * 2 * residual[i] / m_lumped[i]; // the diagonal is half of a row's sum
          x[i] += step[i];
        }
      const Vector image = *this * step;
      for (std::size_t i = 0; i < x.size(); ++i)
        residual[i] -= image[i];
      rho = next_rho;
    }
    return x;
  }

private:
  static constexpr int number_of_steps = 35; // 3^-35 is 2e-17

  const Face_set_2& m_faces;
  std::vector<double> m_areas;
  Vector m_lumped;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_MASS_MATRIX_2_H
