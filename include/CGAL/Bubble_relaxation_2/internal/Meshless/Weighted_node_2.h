// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_NODE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_NODE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/weight_functions.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A node in whose support the point of evaluation lies. All is in units of one length, so that neither
/// powers nor second derivatives leave the range of numbers, whatever the unit of the coordinates is.
struct Weighted_node_2
{
  double x, y;          ///< from the point of evaluation to the node
  double radius;        ///< of its support
  double w;             ///< weight
  double wx, wy;        ///< its derivatives by the point of evaluation
  double wxx, wxy, wyy;
  double s, sx, sy;     ///< the factor that makes the shape function of the weight, and its derivatives
  double sxx, sxy, syy;
};

/// Fills in weights and the derivatives that are asked for.
template <class Weight>
void weigh(std::vector<Weighted_node_2>& nodes, int number_of_derivatives)
{
  for (Weighted_node_2& n : nodes) {
    const double scale = 1 / n.radius;
    const double ux = -n.x * scale;
    const double uy = -n.y * scale;
    const double q = std::sqrt(ux * ux + uy * uy);
    const Radial_weight weight = q < 1 ? Weight::at(q) : Radial_weight{0, 0, 0};
    n.w = weight.w;
    if (number_of_derivatives < 1)
      continue;
    n.wx = weight.g * ux * scale;
    n.wy = weight.g * uy * scale;
    if (number_of_derivatives < 2)
      continue;
    n.wxx = (weight.g + weight.h * ux * ux) * scale * scale;
    n.wxy = weight.h * ux * uy * scale * scale;
    n.wyy = (weight.g + weight.h * uy * uy) * scale * scale;
  }
}

inline void weigh(Moving_least_squares_weight weight, std::vector<Weighted_node_2>& nodes,
                  int number_of_derivatives)
{
  switch (weight) {
  case Moving_least_squares_weight::QUARTIC_SPLINE:
    return weigh<Quartic_spline_weight>(nodes, number_of_derivatives);
  case Moving_least_squares_weight::CUBIC_SPLINE:
    return weigh<Cubic_spline_weight>(nodes, number_of_derivatives);
  case Moving_least_squares_weight::GAUSSIAN:
    return weigh<Gaussian_weight>(nodes, number_of_derivatives);
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_NODE_2_H
