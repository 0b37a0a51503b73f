// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_COMPENSATED_SUM_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_COMPENSATED_SUM_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A sum whose rounding error does not grow with the number of terms: what each addition loses is collected beside it
/// (Neumaier's variant of Kahan's summation, ZAMM 54 (1974)). Integrals over meshes of millions of triangles are
/// compared with each other to the last digits.
class Compensated_sum
{
public:
  void operator+=(double term)
  {
    const double sum = m_sum + term;
    m_lost += std::abs(m_sum) >= std::abs(term) ? (m_sum - sum) + term : (term - sum) + m_sum;
    m_sum = sum;
  }

  double value() const { return m_sum + m_lost; }

private:
  double m_sum = 0, m_lost = 0;
};

inline double sum_of(const std::vector<double>& terms)
{
  Compensated_sum sum;
  for (double term : terms)
    sum += term;
  return sum.value();
}

inline double sum_of_products(const std::vector<double>& a, const std::vector<double>& b)
{
  Compensated_sum sum;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += a[k] * b[k];
  return sum.value();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_COMPENSATED_SUM_H
