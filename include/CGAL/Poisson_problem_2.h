// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_POISSON_PROBLEM_2_H
#define CGAL_POISSON_PROBLEM_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <functional>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

A Poisson problem: - div grad u = f in a domain, with u = g on a part of its boundary and du/dn = h on the rest.

A function that is not set is zero. With `Parallel_tag` functions are called by several threads at once.

\tparam Kernel_ a kernel of \cgal

\sa `Element_free_Galerkin_2`
*/
template <class Kernel_>
struct Poisson_problem_2
{
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;   ///< the point type
  using Vector_2 = typename Kernel::Vector_2; ///< the vector type

  std::function<double(const Point_2&)> source;    ///< f
  std::function<double(const Point_2&)> dirichlet; ///< g, the values of u where they are given
  /// h, where the flow du/dn is given; the second argument is the outer normal n, of length 1
  std::function<double(const Point_2&, const Vector_2&)> neumann;
  /// Whether u is given on an edge of the boundary, one of the triangulation as it is passed to the solver, asked with
  /// its midpoint: where that changes the triangulation must have a vertex. If it is not set u is given on all.
  /// Without any such edge u is known up to a constant only: then its mean is zero.
  std::function<bool(const Point_2&)> is_dirichlet;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_POISSON_PROBLEM_2_H
