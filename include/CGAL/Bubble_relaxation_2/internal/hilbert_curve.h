// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_CURVE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_CURVE_H

#include <CGAL/Bubble_relaxation_2/internal/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Hilbert_curve_2.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The longest of the domain's edges; of several that only rounding tells apart, the first.
inline Index longest_edge(const Domain_2& domain)
{
  constexpr double rounding = 1e-9;
  Index longest = 0;
  for (std::size_t e = 1; e < domain.edges().size(); ++e)
    if (domain.length(static_cast<Index>(e)) > (1 + rounding) * domain.length(longest))
      longest = static_cast<Index>(e);
  return longest;
}

/// The curve in whose order the bubbles of a domain are, one rank after the other. A single crystal grows from the
/// longest edge row by row, so the halves of the curve lie side by side there, and ranks have parts of the same row.
inline Hilbert_curve_2 hilbert_curve(const Domain_2& domain)
{
  const Index e = longest_edge(domain);
  const Kernel::Vector_2 along = domain.target(e) - domain.source(e);
  return Hilbert_curve_2(domain.bbox(), std::abs(along.y()) > std::abs(along.x()));
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_HILBERT_CURVE_H
