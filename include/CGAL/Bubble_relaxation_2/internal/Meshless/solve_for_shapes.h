// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_FOR_SHAPES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_FOR_SHAPES_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Moment_matrix_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Weighted_node_2.h>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// \file
/// The shape function of node i is w_i s_i with s_i = gamma . p_i and A gamma = p, where p are the monomials at
/// the point of evaluation x. The centre of the monomials is x, but it is not moved with x when derivatives are
/// taken: so p is (1, 0, 0 ...), its derivative by the first coordinate (0, 1, 0 ...), and p_i does not change.
/// A gamma = p differentiated once and twice gives (k, l = x, y)
///   A gamma_k  = p_k - A_k gamma,
///   A gamma_kl = p_kl - A_k gamma_l - A_l gamma_k - A_kl gamma,
/// and A_k gamma is the sum of dw_i/dk s_i p_i: derivatives of A are not needed as matrices.

template <int degree, class Solve>
void solve_for_values(const Solve& solve, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  const Vector gamma = solve(Vector::Unit(0));
  for (Weighted_node_2& n : nodes)
    n.s = gamma.dot(monomials<degree>(n.x, n.y));
}

template <int degree, class Solve>
void solve_for_gradients(const Solve& solve, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  Vector bx = Vector::Zero(), by = Vector::Zero();
  for (const Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    bx -= n.wx * n.s * p;
    by -= n.wy * n.s * p;
  }
  if constexpr (degree > 0) {
    bx[1] += 1;
    by[2] += 1;
  }
  const Vector gamma_x = solve(bx), gamma_y = solve(by);
  for (Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    n.sx = gamma_x.dot(p);
    n.sy = gamma_y.dot(p);
  }
}

template <int degree, class Solve>
void solve_for_hessians(const Solve& solve, std::vector<Weighted_node_2>& nodes)
{
  using Vector = typename Moment_matrix_2<degree>::Vector;
  Vector bxx = Vector::Zero(), bxy = Vector::Zero(), byy = Vector::Zero();
  for (const Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    bxx -= (2 * n.wx * n.sx + n.wxx * n.s) * p;
    bxy -= (n.wx * n.sy + n.wy * n.sx + n.wxy * n.s) * p;
    byy -= (2 * n.wy * n.sy + n.wyy * n.s) * p;
  }
  if constexpr (degree > 1) {
    bxx[3] += 2;
    bxy[4] += 1;
    byy[5] += 2;
  }
  const Vector gamma_xx = solve(bxx), gamma_xy = solve(bxy), gamma_yy = solve(byy);
  for (Weighted_node_2& n : nodes) {
    const Vector p = monomials<degree>(n.x, n.y);
    n.sxx = gamma_xx.dot(p);
    n.sxy = gamma_xy.dot(p);
    n.syy = gamma_yy.dot(p);
  }
}

/// `solve` gives the solution of A gamma = b for any b.
template <int degree, class Solve>
void solve_for_shapes(const Solve& solve, int number_of_derivatives, std::vector<Weighted_node_2>& nodes)
{
  solve_for_values<degree>(solve, nodes);
  if (number_of_derivatives > 0)
    solve_for_gradients<degree>(solve, nodes);
  if (number_of_derivatives > 1)
    solve_for_hessians<degree>(solve, nodes);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SOLVE_FOR_SHAPES_H
