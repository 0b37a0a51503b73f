// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_ELEMENT_FREE_GALERKIN_ERROR_2_H
#define CGAL_ELEMENT_FREE_GALERKIN_ERROR_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Meshless

The error of a solution in the norms of Sobolev (eq. 10).
*/
struct Element_free_Galerkin_error_2
{
  double l2 = 0; ///< the square root of the integral of (u_h - u)^2
  double h1 = 0; ///< the full norm: with the integral of |grad u_h - grad u|^2 added under the root
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_ELEMENT_FREE_GALERKIN_ERROR_2_H
