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
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The faces of a domain: marked in the triangulation, if its faces have marks, else kept here.
template <class Cdt>
class Domain_faces_2
{
public:
  using Face_handle = typename Cdt::Face_handle;

  explicit Domain_faces_2([[maybe_unused]] const Cdt& cdt)
  {
    if constexpr (has_marks) {
      std::size_t number = 0;
      for (Face_handle f : cdt.all_face_handles()) {
        tick(number++);
        f->set_in_domain(false);
      }
    } else
      m_faces.reserve(cdt.number_of_faces());
  }

  bool contains(Face_handle f) const
  {
    if constexpr (has_marks)
      return f->is_in_domain();
    else
      return m_faces.count(&*f) != 0;
  }

  void add(Face_handle f)
  {
    if constexpr (has_marks)
      f->set_in_domain(true);
    else
      m_faces.insert(&*f);
  }

private:
  static constexpr bool has_marks = Domain_marks_2<Cdt>::has_marks;

  std::unordered_set<const void*> m_faces;
};

/// Finds the faces of the domain: those beside its constraints, and all that no constraint separates from them.
/// \param for_each_side `for_each_side(visit)` calls `visit(edge, source, inside_left, inside_right)` for the
/// constraints of the domain: what is on the left, and on the right, seen from the vertex `source`
template <class Cdt, class For_each_side>
Domain_faces_2<Cdt> mark_domain(Cdt& cdt, const For_each_side& for_each_side)
{
  using Face_handle = typename Cdt::Face_handle;
  Domain_faces_2<Cdt> faces(cdt);
  std::vector<void*> stack; // faces
  const auto mark = [&](Face_handle f, bool inside) {
    if (!inside || faces.contains(f))
      return;
    faces.add(f);
    stack.push_back(&*f);
  };
  for_each_side([&](const typename Cdt::Edge& edge, typename Cdt::Vertex_handle source, bool left, bool right) {
    const auto [f, i] = edge;
    const bool f_is_left = f->vertex(Cdt::ccw(i)) == source;
    mark(f, f_is_left ? left : right);
    mark(f->neighbor(i), f_is_left ? right : left);
  });
  for (std::size_t number = 0; !stack.empty(); ++number) {
    const Face_handle f = Handles<Cdt>::face(stack.back());
    stack.pop_back();
    tick(number);
    for (int i = 0; i < 3; ++i)
      if (!f->is_constrained(i))
        mark(f->neighbor(i), true);
  }
  return faces;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_MARK_DOMAIN_H
