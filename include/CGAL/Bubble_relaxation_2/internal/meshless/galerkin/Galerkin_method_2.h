// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_discretization_2.h>

#include <CGAL/Element_free_Galerkin_error_2.h>
#include <CGAL/Element_free_Galerkin_report_2.h>

#include <functional>
#include <vector>

// This needs Eigen, and to be compiled with the options of who calls it, so it is not in the core that is installed:
// the project's own programs have it compiled once.
#ifdef CGAL_BUBBLE_RELAXATION_2_COMPILED_GALERKIN
#define CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE
#else
#define CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE inline
#endif

namespace CGAL::Bubble_relaxation_2::internal {

/// returns the nodes' coefficients, none if the callback stopped it
CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE
std::vector<double> solve_galerkin(const Galerkin_discretization_2& d, const Galerkin_problem& problem,
                                   Element_free_Galerkin_report_2& report);

/// `Element_free_Galerkin_solution_2::error()`
/// \param gradient_of_u a vector of any length
CGAL_BUBBLE_RELAXATION_2_GALERKIN_INLINE
Element_free_Galerkin_error_2 error_of_solution(const Galerkin_discretization_2& d,
                                                const std::vector<double>& coefficients,
                                                const std::function<double(const Point&)>& u,
                                                const std::function<Direction(const Point&)>& gradient_of_u);

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED_GALERKIN
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_method_2_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_METHOD_2_H
