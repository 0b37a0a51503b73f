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

/// Collective. \throws std::invalid_argument on all ranks if there are bubbles on any
inline void refuse_given(const Communicator& comm, const Numbered_bubbles_2& given)
{
  const std::int64_t n = comm.sum(static_cast<std::int64_t>(given.size()));
  if (n == 0)
    return;
  comm.all_throw();
  throw std::invalid_argument("Bubble_relaxation_2: parameter points has " + std::to_string(n) +
                              " points on all ranks together and must be empty");
}

/// The bubbles of a mesh that a rank owns, in the order of their numbers. d is asked anew where they are: neither
/// the simulation nor the treatment asks it again for every little displacement.
template <class Sizing>
Numbered_bubbles_2 own_bubbles(const Distributed_mesh_2& mesh, int rank, const Sizing& sizing)
{
  const Known_bubbles_2& known = mesh.known;
  Numbered_bubbles_2 result;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known.owners[i] == rank) {
      result.add(record(known.bubbles, i, known.numbers[i]));
      result.bubbles.d.back() = sizing(known.bubbles.point(i));
    }
  return result;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H
