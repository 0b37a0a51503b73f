// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_STATE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_STATE_2_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Simulation_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// all that a simulation knows of a bubble, on its way from one rank to another
struct Bubble_state_2
{
  Bubble_record_2 bubble;
  Bubble_memory_2 memory;

  bool operator<(const Bubble_state_2& s) const { return bubble.number < s.bubble.number; }
};

/// of a bubble that has not been simulated
inline Bubble_state_2 initial_state(const Bubbles_2& b, std::size_t i, std::int64_t number)
{
  return Bubble_state_2{record(b, i, number), Bubble_memory_2{b.x[i], b.y[i], b.d[i], b.x[i], b.y[i], 1, 1}};
}

/// adds a bubble that is a part of all
inline void add(Bubbles_2& bubbles, const Bubble_record_2& r, bool is_foreign)
{
  bubbles.add(Point(r.x, r.y), r.d, static_cast<Bubbles_2::Dimension>(r.dimension), r.place, r.s, r.tag);
  bubbles.vx.back() = r.vx;
  bubbles.vy.back() = r.vy;
  bubbles.number.push_back(r.number);
  bubbles.is_foreign.push_back(is_foreign);
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_BUBBLE_STATE_2_H
