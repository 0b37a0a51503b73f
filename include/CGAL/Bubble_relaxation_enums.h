// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_ENUMS_H
#define CGAL_BUBBLE_RELAXATION_ENUMS_H

namespace CGAL {

/// \addtogroup PkgBubbleRelaxation2Enums
/// @{

/// How the equation of motion of the bubbles (eq. 3 of the paper) is integrated.
enum class Bubble_integrator
{
  RUNGE_KUTTA_4,       ///< the paper's: classical Runge-Kutta, four force evaluations a step, in length units
  SEMI_IMPLICIT_EULER  ///< the default: one force evaluation a step, in units of the local size, hence scale-free
};

/// Where the bubbles of the faces start. Those of edges cut them in equal parts of the integral of ds/d.
enum class Bubble_placement
{
  /// the free vertices that exist are the bubbles, in the faces whatever d asks, on an edge if it has as many
  /// as the integral of ds/d asks, rounded; else the edge is cut anew, also with `Bubble_population::NONE`
  KEEP,
  RHOMBIC,  ///< the paper's: recursive subdivision in rhombic cells with angles of 60 and 120 degrees
  FRONTAL   ///< the default: a front of hexagonally aligned candidates
};

/// How the number of bubbles is adjusted between two rounds of simulation.
enum class Bubble_population
{
  NONE,           ///< the number stays as placed, but for bubbles that come to lie in one place
  OVERLAP_RATIO,  ///< the paper's: delete where bubbles overlap too much, insert where too little
  DELAUNAY        ///< the default: insert at large circumcircles, delete crowded and ill-connected bubbles
};

/// Why a relaxation ended.
enum class Bubble_stop_reason
{
  CONVERGED,          ///< no bubble moved more than the tolerance and the population stayed as it was
  ITERATION_LIMIT,    ///< all rounds were done
  STOPPED_BY_CALLBACK ///< the callback returned `false`
};

/// @}

} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_ENUMS_H
