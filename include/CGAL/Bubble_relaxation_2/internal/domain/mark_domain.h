// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MARK_DOMAIN_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MARK_DOMAIN_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Marks the faces of the domain in a user's triangulation, if it has marks: those beside constraints that are inside,
/// and all that no constraint separates from them.
/// \param for_each_side `for_each_side(visit)` calls `visit(edge, source, inside_left, inside_right)` for the
/// constraints of the domain: what is on the left, and on the right, seen from the vertex `source`
template <class Cdt, class For_each_side>
void mark_domain(Cdt& cdt, const For_each_side& for_each_side)
{
  if constexpr (Domain_marks_2<Cdt>::has_marks) {
    using Face_handle = typename Cdt::Face_handle;
    std::size_t number = 0;
    for (Face_handle f : cdt.all_face_handles()) {
      tick(number++);
      f->set_in_domain(false);
    }
    std::vector<void*> stack; // faces
    const auto mark = [&stack](Face_handle f, bool inside) {
      if (!inside || f->is_in_domain())
        return;
      f->set_in_domain(true);
      stack.push_back(&*f);
    };
    for_each_side([&](const typename Cdt::Edge& edge, typename Cdt::Vertex_handle source, bool left, bool right) {
      const auto [f, i] = edge;
      const bool f_is_left = f->vertex(Cdt::ccw(i)) == source;
      mark(f, f_is_left ? left : right);
      mark(f->neighbor(i), f_is_left ? right : left);
    });
    while (!stack.empty()) {
      const Face_handle f = Handles<Cdt>::face(stack.back());
      stack.pop_back();
      tick(number++);
      for (int i = 0; i < 3; ++i)
        if (!f->is_constrained(i))
          mark(f->neighbor(i), true);
    }
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MARK_DOMAIN_H
