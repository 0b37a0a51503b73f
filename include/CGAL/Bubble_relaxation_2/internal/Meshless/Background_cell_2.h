// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_BACKGROUND_CELL_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_BACKGROUND_CELL_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Gauss_rule.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A cell of integration: the triangle or the parallelogram that two vectors span from a corner.
struct Background_cell_2
{
  double x, y;   ///< the corner
  double ux, uy; ///< the vectors
  double vx, vy;
  bool is_triangle;

  double area() const { return std::abs(ux * vy - uy * vx) * (is_triangle ? 0.5 : 1.); }
};

/// Gauss's rules for cells, with `n` points in each direction: exact for polynomials of degree 2 n - 1, on
/// parallelograms in each direction. The rule for triangles is the one for the square with a side collapsed.
class Cell_quadrature_2
{
public:
  explicit Cell_quadrature_2(std::size_t n) : m_along(gauss_rule(n)), m_collapsed(gauss_rule(n, 1)) {}

  std::size_t points_per_cell() const { return m_along.size() * m_along.size(); }

  /// calls `visit(x, y, weight)` for all points of the cell
  template <class Visitor>
  void for_each_point(const Background_cell_2& cell, const Visitor& visit) const
  {
    const double jacobian = std::abs(cell.ux * cell.vy - cell.uy * cell.vx);
    const Gauss_rule& across = cell.is_triangle ? m_collapsed : m_along;
    for (std::size_t i = 0; i < across.size(); ++i)
      for (std::size_t j = 0; j < m_along.size(); ++j) {
        const double s = across.points[i];
        const double t = m_along.points[j] * (cell.is_triangle ? 1 - s : 1.);
        visit(cell.x + s * cell.ux + t * cell.vx, cell.y + s * cell.uy + t * cell.vy,
              jacobian * across.weights[i] * m_along.weights[j]);
      }
  }

private:
  Gauss_rule m_along, m_collapsed;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_BACKGROUND_CELL_2_H
