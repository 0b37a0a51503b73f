// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_BUBBLE_STATE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_BUBBLE_STATE_2_H

#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/simulation/Simulation_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// all that a simulation knows of a bubble, on its way from one rank to another
struct Bubble_state_2
{
  Bubble_record_2 bubble;
  Bubble_memory_2 memory;

  bool operator<(const Bubble_state_2& s) const { return bubble.id < s.bubble.id; }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_CHECKPOINT_BUBBLE_STATE_2_H
