// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_LOCAL_FIT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_LOCAL_FIT_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Influence_disc_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Mls_options.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Moment_matrix_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Weighted_node_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/solve_for_shapes.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Moving least squares at one point: the nodes around it, whether they suffice, and their shape functions.
class Local_fit_2
{
public:
  /// takes the nodes with their radii times `enlargement`
  template <class Influence, class Point_2>
  void gather(const Influence& influence, const Point_2& p, const std::vector<typename Influence::Node_index>& nodes,
              double enlargement)
  {
    m_unit = 0;
    for (auto i : nodes)
      m_unit = (std::max)(m_unit, influence.radius(i) * enlargement / units_per_radius);
    const double scale = 1 / m_unit;
    const double px = CGAL::to_double(p.x()), py = CGAL::to_double(p.y());
    m_nodes.resize(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Influence_disc_2 node = influence.disc(nodes[k]); // the point would have to be rounded each time
      m_nodes[k].x = (node.x - px) * scale;
      m_nodes[k].y = (node.y - py) * scale;
      m_nodes[k].radius = node.radius * enlargement * scale;
    }
  }

  /// returns whether the nodes suffice, and solves if they do
  bool solve(const Mls_options& options, int number_of_derivatives)
  {
    weigh(options.weight, m_nodes, number_of_derivatives);
    switch (options.basis) {
    case Moving_least_squares_basis::CONSTANT:
      return solve<0>(options, number_of_derivatives);
    case Moving_least_squares_basis::LINEAR:
      return solve<1>(options, number_of_derivatives);
    default:
      return solve<2>(options, number_of_derivatives);
    }
  }

  double condition_number() const { return m_condition_number; }

  /// the shape functions by the product rule, in the units of the coordinates
  template <class Shapes>
  void write(int number_of_derivatives, Shapes& shapes) const
  {
    const double d = 1 / m_unit, dd = d * d;
    write(number_of_derivatives >= 0, shapes.values, [](const auto& n) { return n.w * n.s; });
    write(number_of_derivatives > 0, shapes.dx, [d](const auto& n) { return (n.w * n.sx + n.wx * n.s) * d; });
    write(number_of_derivatives > 0, shapes.dy, [d](const auto& n) { return (n.w * n.sy + n.wy * n.s) * d; });
    write(number_of_derivatives > 1, shapes.dxx,
          [dd](const auto& n) { return (n.w * n.sxx + 2 * n.wx * n.sx + n.wxx * n.s) * dd; });
    write(number_of_derivatives > 1, shapes.dxy, [dd](const auto& n) {
      return (n.w * n.sxy + n.wx * n.sy + n.wy * n.sx + n.wxy * n.s) * dd;
    });
    write(number_of_derivatives > 1, shapes.dyy,
          [dd](const auto& n) { return (n.w * n.syy + 2 * n.wy * n.sy + n.wyy * n.s) * dd; });
  }

private:
  template <int degree>
  bool solve(const Mls_options& options, int number_of_derivatives)
  {
    using Matrix = Moment_matrix_2<degree>;
    const bool at_any_price = options.deficient_support == Deficient_support::PSEUDO_INVERSE;
    m_condition_number = std::numeric_limits<double>::infinity();
    if (m_nodes.size() < Matrix::size && !at_any_price)
      return false;
    const Matrix matrix(m_nodes);
    m_condition_number = matrix.condition_number(options.maximum_condition_number);
    const bool suffices = m_condition_number <= options.maximum_condition_number;
    if (suffices)
      solve_for_shapes<degree>([&](const auto& b) { return matrix.solve(b); }, number_of_derivatives, m_nodes);
    else if (at_any_price)
      solve_for_shapes<degree>([&](const auto& b) { return matrix.pseudo_solve(b, units_per_radius); },
                               number_of_derivatives, m_nodes);
    return suffices;
  }

  template <class Shape>
  void write(bool is_asked_for, std::vector<double>& out, const Shape& shape) const
  {
    out.resize(is_asked_for ? m_nodes.size() : 0);
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = shape(m_nodes[k]);
  }

  static constexpr double units_per_radius = 3; // which balances the moments of a usual neighbourhood

  std::vector<Weighted_node_2> m_nodes;
  double m_unit = 1; // of lengths: in thirds of the largest radius all monomials have moments of like size
  double m_condition_number = 0;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_LOCAL_FIT_2_H
