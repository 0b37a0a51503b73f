// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_CLEARANCE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_CLEARANCE_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/Hilbert_partition_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The length of a vector or up to 9 % more, without a square root and for coordinates of any order.
inline double length_at_most(double x, double y)
{
  x = std::abs(x);
  y = std::abs(y);
  return (std::max)(x, y) + 0.4143 * (std::min)(x, y); // an octagon in the unit circle: sqrt(2) - 1, rounded up
}

/// How far places are from other ranks' parts of the plane. It is asked of one place after the other, each near the
/// last one: what was found there answers most questions.
class Clearance_2
{
public:
  Clearance_2(const Hilbert_partition_2& partition, int rank) : m_partition(&partition), m_rank(rank)
  {
    if (partition.number_of_ranks() == 1)
      m_clearance = std::numeric_limits<double>::infinity();
  }

  /// The radius of a disc around a place that lies in our part, at least as large as `radius`. 0 if it is not known
  /// that there is such a disc: then there is none that is much larger.
  double operator()(double x, double y, double radius)
  {
    const double left = (1 - 1e-9) * m_clearance - length_at_most(x - m_x, y - m_y);
    if (left >= radius)
      return left;
    double found = 0;
    for (double factor : look_ahead) {
      if (!m_partition->owns_disc(m_rank, x, y, factor * radius))
        break;
      found = factor * radius;
    }
    if (found > 0) {
      m_x = x;
      m_y = y;
      m_clearance = found;
    }
    return found;
  }

private:
  /// so many times the radius are tried, for those that come after
  static constexpr std::array<double, 4> look_ahead = {1.2, 2, 4, 8};

  const Hilbert_partition_2* m_partition;
  int m_rank;
  double m_x = 0, m_y = 0, m_clearance = 0; // the last one that was found
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_PARTS_CLEARANCE_2_H
