// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_CORNER_SOLVERS_H
#define BUBBLE_RELAXATION_2_DEMO_CORNER_SOLVERS_H

#include "adaptive_solution.h"
#include "corner_singularity.h"
#include "error_norms.h"
#include "linear_finite_elements.h"

#include <CGAL/Element_free_Galerkin_2.h>
#include <CGAL/node_set_2.h>

#include <Eigen/Core>

#include <cstddef>

// Solvers of the problem with a singular corner, for an `Adaptive_solution`: the values at the vertices, and a way to
// measure their error.

template <class CDT>
CGAL::Poisson_problem_2<typename CDT::Geom_traits> corner_problem()
{
  CGAL::Poisson_problem_2<typename CDT::Geom_traits> problem;
  problem.dirichlet = &Corner_singularity<typename CDT::Geom_traits>::value;
  return problem;
}

template <class CDT>
Solved by_finite_elements(const CDT&, const Triangle_arrays<CDT>& mesh)
{
  const Eigen::VectorXd values = solve_by_linear_elements(mesh, corner_problem<CDT>());
  return Solved{values, [&mesh, values] {
    return error_of_linear_elements<Corner_singularity<typename CDT::Geom_traits>>(mesh, values);
  }};
}

/// With 3 Gauss points in each direction, the default for the linear basis, the error of integration is most of the
/// error of the values from 10 000 nodes on.
template <CGAL::Moving_least_squares_basis basis, class CDT>
Solved by_element_free_galerkin(const CDT& cdt, const Triangle_arrays<CDT>& mesh)
{
  using Point = typename CDT::Geom_traits::Point_2;
  using Exact = Corner_singularity<typename CDT::Geom_traits>;
  const CGAL::Element_free_Galerkin_2<CDT> method(
    cdt, CGAL::node_set_2(cdt), CGAL::parameters::mls_basis(basis).number_of_gauss_points(4));
  const auto solution = method.solve(corner_problem<CDT>());
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    values[static_cast<Eigen::Index>(v)] = solution.value(mesh.points[v]);
  return Solved{values, [&mesh, solution] {
    return integrate_error(mesh, Exact::corner(), 4, [&](std::size_t, const Point& p, const Eigen::Vector3d&) {
      const auto gradient = solution.gradient(p), exact = Exact::gradient(p);
      return Eigen::Vector3d(solution.value(p) - Exact::value(p), gradient.x() - exact.x(), gradient.y() - exact.y());
    });
  }};
}

#endif // BUBBLE_RELAXATION_2_DEMO_CORNER_SOLVERS_H
