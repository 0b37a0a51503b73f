// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_DISC_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_DISC_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Bubble_buckets_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

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

/// What the lists of discs cannot tell: in which discs a point lies when they are enlarged, and which node is the
/// nearest. It takes the bubbles' buckets, and goes through all nodes where these would visit more cells than
/// there are nodes.
class Node_buckets_2
{
public:
  explicit Node_buckets_2(const std::vector<Influence_disc_2>& discs)
    : m_discs(discs), m_extent(discs),
      m_buckets(1, discs.empty() ? 1 : discs[0].radius, m_extent.xmin, m_extent.ymin, discs.size())
  {
    for (std::size_t i = 0; i < discs.size(); ++i)
      m_buckets.insert(static_cast<Index>(i), discs[i].x, discs[i].y, discs[i].radius);
  }

  /// calls `visit(i)` for each disc that contains a point, enlarged by a factor, in no particular order
  template <class Visitor>
  void for_each(double x, double y, double factor, Visitor visit) const
  {
    if (m_discs.empty() || m_extent.distance(x, y) > factor * m_extent.largest)
      return;
    if (factor < most_radii)
      m_buckets.for_each_large(x, y, 0, factor, [&visit](const auto& entry, double) {
        visit(entry.id);
        return true;
      });
    else
      for (std::size_t i = 0; i < m_discs.size(); ++i)
        if (m_discs[i].contains(x, y, factor))
          visit(static_cast<Index>(i));
  }

  /// The node nearest to a point, of several the first; -1 if there is none. `distance`: a guess, such as that of
  /// any node.
  Index nearest(double x, double y, double distance) const
  {
    Nearest nearest;
    const auto visit = [&nearest](const auto& entry, double squared) {
      nearest.consider(entry.id, squared);
      return true;
    };
    // a far point would look into cells whose numbers overflow
    const double far = m_extent.distance(x, y);
    if (!m_discs.empty() && far <= most_radii * (m_extent.width() + m_extent.largest)) {
      double within = (std::max)(distance * (1 + 1e-9), far);
      within = (std::max)(within, m_extent.smallest);
      for (; nearest.node < 0 && within < most_radii * m_extent.largest; within *= 2)
        m_buckets.for_each_within(x, y, within, visit);
    }
    if (nearest.node < 0)
      for (std::size_t i = 0; i < m_discs.size(); ++i)
        nearest.consider(static_cast<Index>(i), m_discs[i].squared_distance(x, y));
    return nearest.node;
  }

private:
  static constexpr double most_radii = 64; ///< that a query may reach, at a few cells for each

  struct Nearest
  {
    Index node = -1;
    double squared = std::numeric_limits<double>::infinity();

    void consider(Index i, double s)
    {
      if (node < 0 || s < squared || (s == squared && i < node)) {
        node = i;
        squared = s;
      }
    }
  };

  const std::vector<Influence_disc_2>& m_discs;
  const Influence_extent_2 m_extent;
  Bubble_buckets_2 m_buckets;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SEARCH_INFLUENCE_DISC_2_H
