// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_FORGET_LEVELS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_FORGET_LEVELS_H

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <class Triangulation>
class Triangulation_hierarchy_2;

namespace Bubble_relaxation_2::internal {

template <class Base>
Triangulation_hierarchy_2<Base>& levels_of(Triangulation_hierarchy_2<Base>& triangulation)
{
  return triangulation;
}

/// whether a triangulation is a `Triangulation_hierarchy_2`: some vertices are in upper levels, too
template <class Triangulation, class = void>
struct Has_levels : std::false_type {};

template <class Triangulation>
struct Has_levels<Triangulation, std::void_t<decltype(levels_of(std::declval<Triangulation&>()))>> : std::true_type {};

/// Puts all of the lowest level aside while it exists, and a vertex in its place. Only `remove()` reaches the upper
/// levels.
template <class Base>
class Stand_in
{
  using Vertex_handle = typename Base::Vertex_handle;

public:
  Stand_in(Triangulation_hierarchy_2<Base>& hierarchy, Vertex_handle replaced)
    : m_lowest(hierarchy), m_other(hierarchy.geom_traits()), m_vertex(m_other.insert(replaced->point()))
  {
    m_vertex->set_up(replaced->up());
    m_lowest.swap(m_other);
  }

  Stand_in(const Stand_in&) = delete;
  Stand_in& operator=(const Stand_in&) = delete;
  ~Stand_in() { m_lowest.swap(m_other); }

  Vertex_handle vertex() const { return m_vertex; }

private:
  Base &m_lowest, m_other;
  Vertex_handle m_vertex;
};

/// Takes vertices out of the upper levels of a hierarchy, and leaves them in the lowest one, whose faces are the user's.
template <class Base>
void forget_levels(Triangulation_hierarchy_2<Base>& hierarchy, const std::vector<typename Base::Vertex_handle>& vertices)
{
  for (typename Base::Vertex_handle v : vertices)
    if (v->up() != typename Base::Vertex_handle()) {
      const Stand_in<Base> stand_in(hierarchy, v);
      hierarchy.remove(stand_in.vertex());
      v->set_up(typename Base::Vertex_handle());
    }
}

} // namespace Bubble_relaxation_2::internal
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_FORGET_LEVELS_H
