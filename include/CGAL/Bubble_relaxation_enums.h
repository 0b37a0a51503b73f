// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_ENUMS_H
#define CGAL_BUBBLE_RELAXATION_ENUMS_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

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
  /// the free vertices that exist, but for those in circles around sharp corners, are the bubbles: in the faces
  /// whatever d asks, on an edge if it has as many as the integral of ds/d asks, rounded; else the edge is cut anew,
  /// also with `Bubble_population::NONE`. Otherwise only some of those in a face are taken where they are nearer to each other
  /// or to the outline than 0.75 times the mean of both d, unless `number_of_rounds` is 0, and population control inserts
  /// and deletes where d has changed. The mesh that was given, treated, is the result if its
  /// smallest q is larger than that of the simulated bubbles, unless a larger share of its triangles does not fit d,
  /// since their area is more than twice that of an equilateral triangle with the side d, or less than half of it
  KEEP,
  RHOMBIC,  ///< the paper's: recursive subdivision in rhombic cells with angles of 60 and 120 degrees
  FRONTAL   ///< the default: a front of hexagonally aligned candidates
};

/// How the number of bubbles is adjusted between two rounds of simulation.
enum class Bubble_population
{
  /// The number stays as placed, but for bubbles that come to lie in one place. Where vertices in faces of a mesh are kept
  /// (`Bubble_placement::KEEP`), and are more than four times as many as d asks for, but not more than
  /// `maximum_number_of_bubbles`, d is divided by what makes it ask for about as many; so it is in the report and in nodes.
  NONE,
  OVERLAP_RATIO,  ///< the paper's: delete where bubbles overlap too much, insert where too little
  DELAUNAY        ///< the default: insert at large circumcircles, delete crowded and ill-connected bubbles
};

/// The parts of a relaxation, in their order.
enum class Bubble_phase
{
  READING,    ///< the domain, the mesh that is there, and the sizes that the outline allows
  PLACEMENT,  ///< of the first bubbles
  SIMULATION, ///< rounds of steps, with changes of the population between them
  TREATMENT,  ///< triangulation, treatment of the last defects, refinement of small angles
  EVALUATION, ///< the triangles within the circles around sharp corners, and statistics; a callback that stops them now has
              ///< a complete mesh, unless it is to be restored
  WRITING     ///< of the triangulation. Of the user's only the callback and `put()` of maps of tags are called; a stop is
              ///< obeyed only if the triangulation is to be restored, and then handles become invalid
};

/// Why a relaxation ended.
enum class Bubble_stop_reason
{
  CONVERGED,          ///< no bubble moved more than the tolerance and the population stayed as it was
  ITERATION_LIMIT,    ///< all rounds were done
  STOPPED_BY_CALLBACK ///< the callback returned `false` before the phase `EVALUATION`, or later with
                      ///< `restore_when_stopped`
};

/// How the nodes near a point are found. Both ways find the same nodes.
enum class Influence_search
{
  BUCKETS,  ///< the default: from lists of the cells of a grid; the fastest way, and complete on every domain
  EXPANSION ///< the paper's: from the nearest node over neighbour sets; where that may be incomplete, as by default
};

/// The polynomials that moving least squares reproduce exactly.
enum class Moving_least_squares_basis
{
  CONSTANT, ///< 1: Shepard's interpolation weights
  LINEAR,   ///< the default: 1, x, y
  QUADRATIC ///< 1, x, y, x^2, xy, y^2
};

/// The weight of a node in moving least squares, as a function of q, its distance in units of its support
/// radius. All have continuous second derivatives, also at q = 1, from where on they vanish.
enum class Moving_least_squares_weight
{
  QUARTIC_SPLINE, ///< the paper's and the default: 1 - 6 q^2 + 8 q^3 - 3 q^4
  CUBIC_SPLINE,   ///< 2/3 - 4 q^2 + 4 q^3 for q < 1/2, 4/3 (1 - q)^3 beyond
  /// exp(-(q/0.4)^2) less its Taylor polynomial of second order in q^2 about q = 1
  GAUSSIAN
};

/// What becomes of a point where moving least squares have too few nodes, or nodes too badly placed.
enum class Deficient_support
{
  ENLARGE, ///< the default: there the support radii grow by steps of 1.1 until the nodes suffice; it is counted
  REPORT,  ///< an exception names the point
  /// the equations are solved as well as they can be, and nobody is told. The result reproduces not even
  /// constants. For comparison only: the errors of the paper's random node set come from it.
  PSEUDO_INVERSE
};

/// How the element-free Galerkin method imposes given values on the boundary, where its functions do not
/// interpolate.
enum class Dirichlet_condition
{
  NITSCHE,             ///< the default: consistent, symmetric and definite for a factor that is large enough
  PENALTY,             ///< the paper's: the squared deviation times a large factor
  LAGRANGE_MULTIPLIERS ///< multipliers that are linear along the boundary, on fewer points than there are nodes
};

/// The cells over which the element-free Galerkin method integrates.
enum class Integration_cells
{
  TRIANGLES, ///< the default: the triangles of the mesh, which respect the boundary
  GRID       ///< the paper's: the rectangles of a regular grid over the domain
};

/// How values at vertices, linear in triangles, are transferred to another triangulation.
enum class Vertex_transfer
{
  INTERPOLATION, ///< the value that the source has at each vertex; no new extremes, but the integral drifts
  /// the default: the nearest function in the mean square. It keeps the integral, and linear functions are exact; at
  /// jumps it overshoots
  PROJECTION,
  /// the projection as far as no vertex gets a value that the source does not have in the triangles around it; it keeps
  /// the integral as well
  MONOTONE_PROJECTION
};

/// How values of faces, constant in each, are transferred to another triangulation. All ways keep the integral.
enum class Face_transfer
{
  MEAN, ///< the mean over each triangle, no new extremes; of first order, and many transfers blur the field
  /// the mean of functions that are linear in the source's triangles: of second order, and linear functions are
  /// exact; at jumps it overshoots
  RECONSTRUCTION,
  /// the default: the same as far as no triangle gets a value beyond those that the source has in the triangles that
  /// overlap it and the ones around these
  MONOTONE_RECONSTRUCTION
};

/// @}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_ENUMS_H
