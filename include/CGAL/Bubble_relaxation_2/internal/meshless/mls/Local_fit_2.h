// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_LOCAL_FIT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_LOCAL_FIT_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Moment_matrix_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/search/Influence_search_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The values of the named parameters of moving least squares.
struct Mls_options
{
  Moving_least_squares_basis basis = Moving_least_squares_basis::LINEAR;
  Moving_least_squares_weight weight = Moving_least_squares_weight::QUARTIC_SPLINE;
  Deficient_support deficient_support = Deficient_support::ENLARGE;
  double maximum_condition_number = 1e4;
};

/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Mls_options read_mls_options(const NamedParameters& np)
{
  Mls_options o;
  take(np, internal_np::mls_basis, o.basis);
  take(np, internal_np::mls_weight, o.weight);
  take(np, internal_np::deficient_support, o.deficient_support);
  take(np, internal_np::maximum_condition_number, o.maximum_condition_number);
  // beyond that eigenvalues are rounding errors
  if (!(o.maximum_condition_number >= 1 && o.maximum_condition_number <= 1e14))
    throw_invalid_parameter("maximum_condition_number", o.maximum_condition_number, "between 1 and 1e14");
  return o;
}

/// \file
/// The shape function of node i is w_i s_i with s_i = gamma . p_i and A gamma = p, where p are the monomials at
/// the point of evaluation x. The centre of the monomials is x, but it is not moved with x when derivatives are
/// taken: so p is (1, 0, 0 ...), its derivative by the first coordinate (0, 1, 0 ...), and p_i does not change.
/// A gamma = p differentiated once and twice gives (k, l = x, y)
///   A gamma_k  = p_k - A_k gamma,
///   A gamma_kl = p_kl - A_k gamma_l - A_l gamma_k - A_kl gamma,
/// and A_k gamma is the sum of dw_i/dk s_i p_i: derivatives of A are not needed as matrices.

template <int degree>
void solve_for_values(const Moment_matrix_2<degree>& matrix, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  const Vector gamma = matrix.solve(Vector{1});
  for (Weighted_node_2& n : nodes)
    n.s = dot(gamma, monomials<degree>(n.x, n.y));
}

template <int degree>
void solve_for_gradients(const Moment_matrix_2<degree>& matrix, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  Vector bx{}, by{};
  for (const Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    add(bx, -n.wx * n.s, p);
    add(by, -n.wy * n.s, p);
  }
  if constexpr (degree > 0) {
    bx[1] += 1;
    by[2] += 1;
  }
  const Vector gamma_x = matrix.solve(bx), gamma_y = matrix.solve(by);
  for (Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    n.sx = dot(gamma_x, p);
    n.sy = dot(gamma_y, p);
  }
}

template <int degree>
void solve_for_hessians(const Moment_matrix_2<degree>& matrix, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  Vector bxx{}, bxy{}, byy{};
  for (const Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    add(bxx, -(2 * n.wx * n.sx + n.wxx * n.s), p);
    add(bxy, -(n.wx * n.sy + n.wy * n.sx + n.wxy * n.s), p);
    add(byy, -(2 * n.wy * n.sy + n.wyy * n.s), p);
  }
  if constexpr (degree > 1) {
    bxx[3] += 2;
    bxy[4] += 1;
    byy[5] += 2;
  }
  const Vector gamma_xx = matrix.solve(bxx), gamma_xy = matrix.solve(bxy), gamma_yy = matrix.solve(byy);
  for (Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    n.sxx = dot(gamma_xx, p);
    n.sxy = dot(gamma_xy, p);
    n.syy = dot(gamma_yy, p);
  }
}

/// Moving least squares at one point: the nodes around it, whether they suffice, and their shape functions.
class Local_fit_2
{
public:
  /// takes the nodes with their radii times `enlargement`
  void gather(const Influence_search_2& search, const Point& p, const std::vector<std::int32_t>& nodes,
              double enlargement)
  {
    m_unit = 0;
    for (std::int32_t i : nodes)
      m_unit = (std::max)(m_unit, search.disc(static_cast<std::size_t>(i)).radius * enlargement / units_per_radius);
    const double scale = 1 / m_unit;
    m_nodes.resize(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Influence_disc_2 node = search.disc(static_cast<std::size_t>(nodes[k]));
      m_nodes[k].x = (node.x - p.x()) * scale;
      m_nodes[k].y = (node.y - p.y()) * scale;
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
    const bool at_any_price = options.deficient_support == Deficient_support::PSEUDO_INVERSE;
    m_condition_number = std::numeric_limits<double>::infinity();
    if (m_nodes.size() < Moment_matrix_2<degree>::size && !at_any_price)
      return false;
    Moment_matrix_2<degree> matrix(m_nodes);
    m_condition_number = matrix.condition_number(options.maximum_condition_number);
    const bool suffices = m_condition_number <= options.maximum_condition_number;
    if (!suffices && !at_any_price)
      return false;
    if (!suffices)
      matrix.use_pseudo_inverse(units_per_radius);
    solve_for_values<degree>(matrix, m_nodes);
    if (number_of_derivatives > 0)
      solve_for_gradients<degree>(matrix, m_nodes);
    if (number_of_derivatives > 1)
      solve_for_hessians<degree>(matrix, m_nodes);
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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_LOCAL_FIT_2_H
