// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_OWN_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/Distributed/Distributed_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Distributed/Numbered_bubbles_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Asks d anew where a rank's bubbles are: neither the simulation nor the treatment asks it again for every little
/// displacement.
template <class Sizing>
void ask_own_sizes(Distributed_mesh_2& mesh, int rank, const Sizing& sizing)
{
  Known_bubbles_2& known = mesh.known;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known.owners[i] == rank)
      known.bubbles.d[i] = sizing(known.bubbles.point(i));
}

/// The same of others' bubbles that triangles with own ones have.
template <class Sizing>
void ask_ghost_sizes(Distributed_mesh_2& mesh, int rank, const Sizing& sizing)
{
  Known_bubbles_2& known = mesh.known;
  std::vector<char> is_asked(known.size(), 0);
  for (std::size_t t = 0; t < mesh.is_final.size(); ++t)
    for (int i = 0; i < 3 && mesh.is_final[t]; ++i) {
      const Index v = mesh.triangulation.tr.vertices[t][i];
      if (known.owners[v] == rank || is_asked[v])
        continue;
      is_asked[v] = 1;
      known.bubbles.d[v] = sizing(known.bubbles.point(static_cast<std::size_t>(v)));
    }
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
