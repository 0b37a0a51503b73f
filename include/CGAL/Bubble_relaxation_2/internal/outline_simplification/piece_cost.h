// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <cmath>

namespace CGAL::Bubble_relaxation_2::internal {

constexpr double longest_piece = 1.5; ///< in units of d

/// What a piece costs whose length is `x` times the wanted one. A short piece asks for small triangles around it, whose
/// sizes grow by a fifth of the distance: about 3.6 times this many more vertices, the integral of the density of
/// vertices around the piece minus that of the rest. A long one costs quality.
inline double length_cost(double x)
{
  if (x >= 1)
    return 2 * (x - 1) * (x - 1);
  return 25 * (x - 1 - std::log(x)) - 12.5 * (1 - x) * (1 - x);
}

/// `deviation`: from the old outline, in units of the tolerance. It costs little, so that of two pieces of about the
/// same length the nearer one is taken.
inline double piece_cost(double x, double deviation) { return length_cost(x) + 0.2 * deviation * deviation; }

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_PIECE_COST_H
