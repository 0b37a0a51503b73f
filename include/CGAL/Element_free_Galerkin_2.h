// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_ELEMENT_FREE_GALERKIN_2_H
#define CGAL_ELEMENT_FREE_GALERKIN_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Galerkin_discretization_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Galerkin_system_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/solve_sparse.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/Progress.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Element_free_Galerkin_report_2.h>
#include <CGAL/Element_free_Galerkin_solution_2.h>
#include <CGAL/Poisson_problem_2.h>
#include <CGAL/node_set_2.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless
*/
template <class CDT>
class Element_free_Galerkin_2
{
  using Discretization = Bubble_relaxation_2::internal::Galerkin_discretization_2<typename CDT::Geom_traits>;

public:
  using Kernel = typename CDT::Geom_traits;
  using Point_2 = typename Kernel::Point_2;
  using Nodes = Node_set_2<Point_2>;
  using Problem = Poisson_problem_2<Kernel>;
  using Solution = Element_free_Galerkin_solution_2<Kernel>;

  template <class NamedParameters = parameters::Default_named_parameters>
  Element_free_Galerkin_2(const CDT& cdt, const Nodes& nodes,
                          const NamedParameters& np = parameters::default_values())
    : m_discretization(std::make_shared<const Discretization>(cdt, nodes, np))
  {}

  Solution solve(const Problem& problem) const
  {
    using namespace Bubble_relaxation_2::internal;
    const Discretization& d = *m_discretization;
    Element_free_Galerkin_report_2 report;
    report.number_of_nodes = d.nodes.number();
    report.number_of_cells = d.cells.size();
    report.number_of_gauss_points = d.cells.size() * d.cell_rule.points_per_cell();
    report.number_of_boundary_points = d.segments.size() * d.segment_rule.size();

    Progress progress(d.options.callback, 1);
    std::vector<double> coefficients;
    Phase_timer integration_time(report.integration_seconds);
    Galerkin_system_2<Kernel> system(d, problem, progress, report);
    report.is_stopped_by_callback = !progress.report(0) || !system.assemble();
    integration_time.stop();
    if (!report.is_stopped_by_callback) {
      Phase_timer solution_time(report.solution_seconds);
      const auto matrix = system.matrix();
      const Sparse_solution solution =
        solve_sparse(matrix, system.load(), system.is_definite(), d.options.residual_tolerance);
      coefficients.assign(solution.x.data(), solution.x.data() + d.nodes.number());
      report.number_of_non_zeros = static_cast<std::size_t>(matrix.nonZeros());
      report.residual = solution.residual;
      report.condition_number = solution.condition_number;
      solution_time.stop();
      progress.report(1);
    }
    return Solution(m_discretization, std::move(coefficients), report);
  }

private:
  std::shared_ptr<const Discretization> m_discretization;
};

} // namespace CGAL

#endif // CGAL_ELEMENT_FREE_GALERKIN_2_H
