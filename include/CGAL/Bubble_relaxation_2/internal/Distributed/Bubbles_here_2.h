// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLES_HERE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLES_HERE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>

#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Finds bubbles as `Neighbor_sets_2` does, but where they are now and not by references.
class Bubbles_here_2
{
public:
  explicit Bubbles_here_2(const Bubbles_2& b)
    : m_buckets(1., b.size() == 0 ? 1. : b.d[0], b.size() == 0 ? 0. : b.x[0], b.size() == 0 ? 0. : b.y[0], b.size())
  {
    for (std::size_t i = 0; i < b.size(); ++i)
      if (!b.is_gone(i))
        add(b, static_cast<Index>(i));
  }

  void add(const Bubbles_2& b, Index i) { m_buckets.insert(i, b.x[i], b.y[i], b.d[i]); }

  template <class Visitor>
  void find_within(double x, double y, double d, double near, const Visitor& visit) const
  {
    m_buckets.for_each_within(x, y, near * d, [&visit](const auto& e, double) { return visit(e.id), true; });
  }

  template <class Visitor>
  void find_large(double x, double y, double least, double near, const Visitor& visit) const
  {
    m_buckets.for_each_large(x, y, least, near, [&visit](const auto& e, double) { return visit(e.id), true; });
  }

private:
  Bubble_buckets_2 m_buckets;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLES_HERE_2_H
