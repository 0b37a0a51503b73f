// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Asks d anew where bubbles are: neither the simulation nor the treatment asks it again for every little displacement.
template <class Sizing>
void ask_sizes(Known_bubbles_2& known, const Sizing& sizing)
{
  for (std::size_t i = 0; i < known.size(); ++i)
    known.bubbles.d[i] = sizing(known.bubbles.point(i));
}

/// The bubbles of a mesh that a rank owns, in the order of their numbers.
inline Numbered_bubbles_2 own_bubbles(const Distributed_mesh_2& mesh, int rank)
{
  const Known_bubbles_2& known = mesh.known;
  Numbered_bubbles_2 result;
  result.make_room_for(known.size());
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known.owners[i] == rank)
      result.add(record(known.bubbles, i, known.numbers[i]));
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H
