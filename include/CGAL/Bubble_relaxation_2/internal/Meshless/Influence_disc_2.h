// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_INFLUENCE_DISC_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_INFLUENCE_DISC_2_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// the influence domain of a node
struct Influence_disc_2
{
  double x, y, radius;

  double squared_distance(double px, double py) const
  {
    const double dx = x - px, dy = y - py;
    return dx * dx + dy * dy;
  }

  /// whether a point lies in the open disc of `factor` times the radius: all ways of searching ask this
  bool contains(double px, double py, double factor) const
  {
    const double reach = factor * radius;
    return squared_distance(px, py) < reach * reach;
  }
};

/// what all discs have in common
struct Influence_extent_2
{
  double xmin = 0, ymin = 0, xmax = 0, ymax = 0; ///< of the nodes
  double smallest = 0, largest = 0;              ///< radii

  explicit Influence_extent_2(const std::vector<Influence_disc_2>& discs)
  {
    if (discs.empty())
      return;
    xmin = xmax = discs[0].x;
    ymin = ymax = discs[0].y;
    smallest = largest = discs[0].radius;
    for (const Influence_disc_2& d : discs) {
      xmin = (std::min)(xmin, d.x);
      xmax = (std::max)(xmax, d.x);
      ymin = (std::min)(ymin, d.y);
      ymax = (std::max)(ymax, d.y);
      smallest = (std::min)(smallest, d.radius);
      largest = (std::max)(largest, d.radius);
    }
  }

  double width() const { return (std::max)(xmax - xmin, ymax - ymin); }

  /// bounds what rounding can do to a coordinate in or near the discs
  double rounding() const
  {
    const double farthest = (std::max)((std::max)(std::abs(xmin), std::abs(xmax)),
                                       (std::max)(std::abs(ymin), std::abs(ymax)));
    return 16 * std::numeric_limits<double>::epsilon() * (farthest + largest);
  }

  /// the distance of a point from the nodes' box, measured along the axes
  double distance(double x, double y) const
  {
    return (std::max)((std::max)((std::max)(xmin - x, x - xmax), (std::max)(ymin - y, y - ymax)), 0.);
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_INFLUENCE_DISC_2_H
