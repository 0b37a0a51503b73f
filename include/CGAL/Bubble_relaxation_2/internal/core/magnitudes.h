// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_MAGNITUDES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_MAGNITUDES_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <cmath>
#include <limits>
#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

/// The bounds of coordinates, and of lengths that are not 0. Products of three lengths, and their sums, are the highest
/// powers that are computed in double, by the centre of a circle: between these bounds, with some room for fractions of
/// a size, they neither overflow nor lose bits as denormal numbers do. So a mesh does not depend on the scale, and CGAL
/// gets no infinite number.
constexpr double largest_magnitude = 1e90, smallest_length = 1e-90;

/// whether a coordinate is finite and not beyond the bound
inline bool is_coordinate(double x) { return std::abs(x) <= largest_magnitude; }

inline bool is_within_magnitudes(double length) { return length >= smallest_length && length <= largest_magnitude; }

/// what a coordinate must be, in words for the user; one that is not finite has a simpler reason
inline std::string required_of_coordinates(double x, double y)
{
  return std::isfinite(x) && std::isfinite(y) ? "at most " + in_words(largest_magnitude) + " in magnitude" : "finite";
}

/// what a length must be that is no `is_within_magnitudes()`, in the same way
inline std::string required_of_length(double length)
{
  return length > 0 && std::isfinite(length)
           ? "at least " + in_words(smallest_length) + " and at most " + in_words(largest_magnitude)
           : "positive and finite";
}

/// how far a point whose coordinates were rounded a few times may lie beside where it is meant to be
inline double rounding_of(double largest_coordinate)
{
  return 16 * std::numeric_limits<double>::epsilon() * largest_coordinate;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_MAGNITUDES_H
