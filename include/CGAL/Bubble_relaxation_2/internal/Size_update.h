// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZE_UPDATE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZE_UPDATE_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/make_room_for.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Keeps the sizes of the bubbles up to date. d is asked again only where a bubble has moved more than
/// `tolerance` times its size since it was asked last: most bubbles soon hardly move.
template <class Sizing>
class Size_update
{
public:
  static constexpr double tolerance = 0.01;

  Size_update(const Bubbles_2& b, const Sizing& sizing) : m_sizing(sizing), m_x(b.x), m_y(b.y) {}

  void operator()(Bubbles_2& b, std::size_t i)
  {
    const double dx = b.x[i] - m_x[i], dy = b.y[i] - m_y[i], far = tolerance * b.d[i];
    if (dx * dx + dy * dy <= far * far)
      return;
    b.d[i] = m_sizing(b.x[i], b.y[i]);
    m_x[i] = b.x[i];
    m_y[i] = b.y[i];
  }

  void make_room_for(std::size_t n)
  {
    internal::make_room_for(n, m_x);
    internal::make_room_for(n, m_y);
  }

  /// a bubble added after the last; its size is known
  void add(const Bubbles_2& b, std::size_t i) { add(b.x[i], b.y[i]); }

  /// the same, of which it is known where d was asked
  void add(double x, double y)
  {
    m_x.push_back(x);
    m_y.push_back(y);
  }

  double x(std::size_t i) const { return m_x[i]; }
  double y(std::size_t i) const { return m_y[i]; }

  void clear()
  {
    m_x.clear();
    m_y.clear();
  }

private:
  const Sizing& m_sizing;
  std::vector<double> m_x, m_y; // where d was asked
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZE_UPDATE_H
