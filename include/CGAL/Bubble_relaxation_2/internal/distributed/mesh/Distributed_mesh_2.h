// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/parts/bubble_records.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What a rank has of the one constrained Delaunay triangulation of the bubbles of all ranks. Triangles of the
/// domain with a vertex that this rank owns are the same as on one rank; all others are only what its
/// bubbles, the ghosts that it happens to know and the outline look like from here. When ranks have treated defects,
/// bubbles of others that no final triangle has may not be where they are here.
///
/// Its bubbles are own ones, ghosts, and all of the outline, in the order of their identities.
struct Distributed_mesh_2 : Bubble_mesh_2
{
  std::vector<char> is_final;          ///< per triangle: in the domain, with an own vertex
  std::vector<char> is_owned;          ///< per triangle: each one of the domain on one rank only

  std::size_t number_of_rounds = 0;    ///< of questions to other ranks
  std::size_t number_of_questions = 0;
  std::size_t number_of_answers = 0;   ///< bubbles that were missing
  std::size_t number_of_renewals = 0; ///< while its defects were treated

  /// the vertex of a triangle that decides who owns it: the one with the smallest number
  Index first_vertex(std::size_t t) const
  {
    const std::array<Index, 3>& v = triangles.vertices[t];
    return (std::min)((std::min)(v[0], v[1]), v[2]); // indices follow numbers
  }

  void mark_triangles(int rank)
  {
    const std::size_t n = triangles.number_of_triangles();
    is_final.resize(n);
    is_owned.resize(n);
    for (std::size_t t = 0; t < n; ++t)
      mark_triangle(t, rank);
  }

  /// those that were changed
  void mark_triangles(const std::vector<Index>& changed, int rank)
  {
    for (Index t : changed)
      mark_triangle(static_cast<std::size_t>(t), rank);
  }

private:
  void mark_triangle(std::size_t t, int rank)
  {
    const auto is_own = [&](Index v) { return bubbles.owner[v] == rank; };
    const std::array<Index, 3>& v = triangles.vertices[t];
    is_final[t] = triangles.inside[t] && (is_own(v[0]) || is_own(v[1]) || is_own(v[2]));
    is_owned[t] = is_final[t] && is_own(first_vertex(t));
  }
};

/// Asks d anew where a rank's bubbles are: neither the simulation nor the treatment asks it again for every little
/// displacement.
inline void ask_own_sizes(Distributed_mesh_2& mesh, int rank, const Sizes_2& sizing)
{
  Bubbles_2& known = mesh.bubbles;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known.owner[i] == rank)
      known.d[i] = sizing(known.point(i));
}

/// The same of others' bubbles that triangles with own ones have.
inline void ask_ghost_sizes(Distributed_mesh_2& mesh, int rank, const Sizes_2& sizing)
{
  Bubbles_2& known = mesh.bubbles;
  std::vector<char> is_asked(known.size(), 0);
  for (std::size_t t = 0; t < mesh.is_final.size(); ++t)
    for (int i = 0; i < 3 && mesh.is_final[t]; ++i) {
      const Index v = mesh.triangles.vertices[t][i];
      if (known.owner[v] == rank || is_asked[v])
        continue;
      is_asked[v] = 1;
      known.d[v] = sizing(known.point(static_cast<std::size_t>(v)));
    }
}

/// The bubbles of a mesh that a rank owns, in the order of their numbers.
inline Bubbles_2 own_bubbles(const Distributed_mesh_2& mesh, int rank)
{
  const Bubbles_2& known = mesh.bubbles;
  Bubbles_2 result;
  result.make_room_for(known.size());
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known.owner[i] == rank)
      add_own(result, record(known, i));
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_MESH_DISTRIBUTED_MESH_2_H
