// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H

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
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// returns the nodes' coefficients, none if the callback stopped it
inline std::vector<double> solve_galerkin(const Galerkin_discretization_2& d, const Galerkin_problem& problem,
                                          Element_free_Galerkin_report_2& report)
{
  report.number_of_nodes = d.nodes.number();
  report.number_of_cells = d.cells.size();
  report.number_of_gauss_points = d.cells.size() * d.cell_rule.points_per_cell();
  report.number_of_boundary_points = d.segments.size() * d.segment_rule.size();

  Progress progress(d.options.callback, 1);
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
  progress.report(1);
  return {solution.x.data(), solution.x.data() + d.nodes.number()};
}

/// `Element_free_Galerkin_solution_2::error()`
class Galerkin_error_2
{
public:
  using Function = std::function<double(const Point&)>;
  using Gradient = std::function<Direction(const Point&)>; // of any length

  Galerkin_error_2(const Galerkin_discretization_2& discretization, const std::vector<double>& coefficients,
                   Function u, Gradient gradient_of_u)
    : m(discretization), m_coefficients(coefficients), m_u(std::move(u)), m_gradient_of_u(std::move(gradient_of_u))
  {}

  Element_free_Galerkin_error_2 operator()() const
  {
    const Cell_quadrature_2 rule((std::max)(m.options.gauss_points + 2, std::size_t(5)));
    double values = 0, gradients = 0;
    compute_in_order<Part>(
      m.parallel, m.cells.size(),
      [&](std::size_t k, Part& part) {
        part.block.clear();
        rule.for_each_point(m.cells[k], [&](double x, double y, double w) { part.block.add_point(x, y, w); });
        part.block.evaluate(m.mls);
        integrate(part);
      },
      [&](const std::vector<Part>& parts, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k) {
          values += parts[k].values;
          gradients += parts[k].gradients;
        }
      },
      [](std::size_t) { return true; });
    return Element_free_Galerkin_error_2{std::sqrt(values), std::sqrt(values + gradients)};
  }

private:
  struct Part
  {
    Shape_block_2 block;
    double values, gradients;
  };

  void integrate(Part& part) const
  {
    const Shape_block_2& b = part.block;
    Eigen::VectorXd c(static_cast<Eigen::Index>(b.nodes.size()));
    for (std::size_t k = 0; k < b.nodes.size(); ++k)
      c[static_cast<Eigen::Index>(k)] = m_coefficients[static_cast<std::size_t>(b.nodes[k])];
    const Eigen::VectorXd value = b.phi * c, dx = b.dx * c, dy = b.dy * c;
    part.values = part.gradients = 0;
    for (std::size_t q = 0; q < b.size(); ++q) {
      const auto k = static_cast<Eigen::Index>(q);
      const Direction exact = m_gradient_of_u(b.point(q));
      const double e = value[k] - m_u(b.point(q)), ex = dx[k] - exact.x, ey = dy[k] - exact.y;
      part.values += b.weights[k] * e * e;
      part.gradients += b.weights[k] * (ex * ex + ey * ey);
    }
  }

  const Galerkin_discretization_2& m;
  const std::vector<double>& m_coefficients;
  const Function m_u;
  const Gradient m_gradient_of_u;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H
