// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_BAD_TRIANGLE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_BAD_TRIANGLE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Defect_treatment_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A triangle to be operated on. The worst comes first; among equals its vertices decide.
struct Bad_triangle_2
{
  double quality;
  std::array<std::int64_t, 3> vertices; ///< their numbers among all, in order
  Index triangle;

  bool operator<(const Bad_triangle_2& t) const
  {
    return std::tie(quality, vertices) < std::tie(t.quality, t.vertices);
  }
};

/// q of the isosceles triangle with an angle of twice `half` at its tip: 8 sin(a) sin^2(45 - a/2)
inline double quality_of_isosceles(double half)
{
  const double s = std::sin(half);
  return 4 * s * (1 - s);
}

/// what q can be at most where the input fixes angles between two edges, which one triangle has or two share
inline double best_quality(const Marked_triangulation_2& m, Index t)
{
  double best = 1;
  for (int i = 0; i < 3; ++i) {
    if (m.edges[t][ccw(i)] == no_index || m.edges[t][cw(i)] == no_index)
      continue;
    const Kernel::Vector_2 u = m.tr.point(t, ccw(i)) - m.tr.point(t, i),
                           v = m.tr.point(t, cw(i)) - m.tr.point(t, i);
    const double half = 0.5 * std::atan2(std::abs(u.x() * v.y() - u.y() * v.x()), u * v);
    best = (std::min)(best, (std::max)(quality_of_isosceles(half), quality_of_isosceles(half / 2)));
  }
  return best;
}

/// The triangles with q less than `bad_quality`, unless the input does not allow for more; the worst first.
inline std::vector<Bad_triangle_2> bad_triangles(const Bubbles_2& b, const Marked_triangulation_2& m,
                                                 double bad_quality)
{
  std::vector<Bad_triangle_2> result;
  for (std::size_t k = 0; k < m.inside.size(); ++k) {
    const Index t = static_cast<Index>(k);
    const double q = m.inside[k] ? quality(m.tr, t) : 1.;
    if (!(q < bad_quality && q < 0.9 * best_quality(m, t)))
      continue;
    Bad_triangle_2 bad{q, {}, t};
    for (int i = 0; i < 3; ++i) {
      const Index v = m.tr.vertices[k][i];
      bad.vertices[i] = b.number.empty() ? v : b.number[v];
    }
    std::sort(bad.vertices.begin(), bad.vertices.end());
    result.push_back(bad);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_BAD_TRIANGLE_2_H
