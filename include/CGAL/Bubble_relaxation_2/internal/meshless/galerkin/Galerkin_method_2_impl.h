// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_method_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_discretization_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_system_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Sparse_solver.h>

#include <CGAL/Deficient_support_error_2.h>
#include <CGAL/Element_free_Galerkin_error_2.h>
#include <CGAL/Element_free_Galerkin_report_2.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE
std::vector<double> solve_galerkin(const Galerkin_discretization_2& d, const Galerkin_problem& problem,
                                   Element_free_Galerkin_report_2& report)
{
  report.number_of_nodes = d.nodes.number();
  report.number_of_cells = d.cells.size();
  report.number_of_gauss_points = d.cells.size() * d.cell_rule.points_per_cell();
  report.number_of_boundary_points = d.segments.size() * d.segment_rule.size();

  Progress progress(d.options.callback);
  progress.remember_stop();
  Phase_timer integration_time(report.integration_seconds);
  Galerkin_system_2 system(d, problem, progress, report);
  try {
    report.is_stopped_by_callback = !progress.report(0) || !system.assemble();
  } catch (const Deficient_support_error_2&) {
    d.report_deficient_points();
    throw;
  }
  integration_time.stop();
  if (report.is_stopped_by_callback)
    return {};
  Phase_timer solution_time(report.solution_seconds);
  const auto matrix = system.matrix();
  const Sparse_solution solution =
    Sparse_solver(matrix, system.load(), d.options.residual_tolerance)(system.is_nearly_definite());
  report.number_of_non_zeros = static_cast<std::size_t>(matrix.nonZeros());
  report.residual = solution.residual;
  report.condition_number = solution.condition_number;
  solution_time.stop();
  progress.finish();
  return {solution.x.data(), solution.x.data() + d.nodes.number()};
}

/// the integrals of the squares of the error and its gradient, over the points of a block
inline std::array<double, 2> squared_errors(const Shape_block_2& b, const std::vector<double>& coefficients,
                                            const std::function<double(const Point&)>& u,
                                            const std::function<Direction(const Point&)>& gradient_of_u)
{
  Eigen::VectorXd c(static_cast<Eigen::Index>(b.nodes.size()));
  for (std::size_t k = 0; k < b.nodes.size(); ++k)
    c[static_cast<Eigen::Index>(k)] = coefficients[static_cast<std::size_t>(b.nodes[k])];
  const Eigen::VectorXd value = b.phi * c, dx = b.dx * c, dy = b.dy * c;
  std::array<double, 2> result{0, 0};
  for (std::size_t q = 0; q < b.size(); ++q) {
    const auto k = static_cast<Eigen::Index>(q);
    const Direction exact = gradient_of_u(b.point(q));
    const double e = value[k] - u(b.point(q)), ex = dx[k] - exact.x, ey = dy[k] - exact.y;
    result[0] += b.weights[k] * e * e;
    result[1] += b.weights[k] * (ex * ex + ey * ey);
  }
  return result;
}

CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE
Element_free_Galerkin_error_2 error_of_solution(const Galerkin_discretization_2& d,
                                                const std::vector<double>& coefficients,
                                                const std::function<double(const Point&)>& u,
                                                const std::function<Direction(const Point&)>& gradient_of_u)
{
  const std::size_t gauss_points = (std::max)(d.options.gauss_points + 2, std::size_t(5)),
                    at_once = parts_at_once(gauss_points);
  const Cell_quadrature_2 rule(gauss_points);
  std::vector<Shape_block_2> blocks((std::min)(d.cells.size(), at_once));
  std::vector<std::array<double, 2>> errors(blocks.size());
  double values = 0, gradients = 0;
  const auto compute = [&](std::size_t i, std::size_t k) {
    d.evaluate_cell(i, rule, blocks[k]);
    errors[k] = squared_errors(blocks[k], coefficients, u, gradient_of_u);
  };
  compute_in_order(d.threads, d.cells.size(), at_once, compute, [&](std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      values += errors[k][0];
      gradients += errors[k][1];
    }
    return true;
  });
  return {std::sqrt(values), std::sqrt(values + gradients)};
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_IMPL_H
