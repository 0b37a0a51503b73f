// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H

#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>


namespace CGAL::Bubble_relaxation_2::internal {

constexpr double longest_piece = 1.5; ///< in units of d

/// What a piece costs whose length is `x` times the wanted one. A short piece asks for small triangles around it, whose
/// sizes grow by a fifth of the distance: about 3.6 times this many more vertices, the integral of the density of
/// vertices around the piece minus that of the rest. A long one costs quality.
inline double length_cost(double x)
{
  if (x >= 1)
    return 2 * (x - 1) * (x - 1);
  return 25 * (x - 1 - logarithm_of(x)) - 12.5 * (1 - x) * (1 - x);
}

/// `deviation`: from the old outline, in units of the tolerance. It costs little, so that of two pieces of about the
/// same length the nearer one is taken.
inline double piece_cost(double x, double deviation) { return length_cost(x) + 0.2 * deviation * deviation; }

/// What the triangles at a vertex of the outline lack in q, in sum, where the domain has an angle with this cosine:
/// nothing at multiples of 60 degrees, and most halfway between. A wave, so that it takes no trigonometry; its heights
/// are about those of isosceles triangles that share the angle equally.
inline double angle_cost(double cosine, bool is_reflex)
{
  constexpr double convex_height = 0.09, reflex_height = 0.045, cosine_of_30 = 0.8660254037844386;
  if (!is_reflex && cosine > cosine_of_30)
    return convex_height;
  const double c = cosine * cosine;
  return (is_reflex ? reflex_height : convex_height) * (1 - c * (9 - c * (24 - 16 * c))); // (1 - cos(6 angle)) / 2
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H
