// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FLOOD_FACES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FLOOD_FACES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>

#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Calls `visit(face)` for the faces of a triangulation, not reached before, that no constraint separates from one of
/// them. `reached`: their addresses
template <class Face_handle, class Visit>
void flood_faces(Face_handle first, std::unordered_set<const void*>& reached, const Visit& visit)
{
  if (!reached.insert(&*first).second)
    return;
  for (std::vector<Face_handle> stack{first}; !stack.empty();) {
    const Face_handle f = stack.back();
    stack.pop_back();
    tick(reached.size());
    visit(f);
    for (int i = 0; i < 3; ++i)
      if (!f->is_constrained(i) && reached.insert(&*f->neighbor(i)).second)
        stack.push_back(f->neighbor(i));
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_FLOOD_FACES_H
