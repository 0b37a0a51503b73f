// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CONSTRAINT_HIERARCHY_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CONSTRAINT_HIERARCHY_H

#include <CGAL/Unique_hash_map.h>
#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// whether a triangulation is a `Constrained_triangulation_plus_2`, which knows its constraints whole
template <class Cdt, class = void>
struct Has_constraint_hierarchy : std::false_type {};

template <class Cdt>
struct Has_constraint_hierarchy<Cdt, std::void_t<typename Cdt::Constraint_hierarchy_tag>>
  : std::is_same<typename Cdt::Constraint_hierarchy_tag, Tag_true> {};

/// Which vertices may only split a constraint. A plain triangulation cannot tell: all that look so.
template <class Cdt, bool = Has_constraint_hierarchy<Cdt>::value>
class Splitting_vertices
{
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  explicit Splitting_vertices(const Cdt&) {}

  bool operator()(Vertex_handle, Vertex_handle, Vertex_handle) const { return true; }
};

/// With a hierarchy: the vertices that were not given as points of a constraint, on pieces that belong
/// to one constraint only.
template <class Cdt>
class Splitting_vertices<Cdt, true>
{
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  explicit Splitting_vertices(const Cdt& cdt) : m_cdt(cdt), m_is_input(false)
  {
    for (auto c = cdt.constraints_begin(); c != cdt.constraints_end(); ++c) {
      const auto first = cdt.vertices_in_constraint_begin(*c);
      const auto end = cdt.vertices_in_constraint_end(*c);
      Vertex_handle last = *first;
      for (auto v = first; v != end; ++v) {
        last = *v;
        if (v == first || v.input())
          m_is_input[*v] = true;
      }
      m_is_input[last] = true;
    }
  }

  bool operator()(Vertex_handle before, Vertex_handle v, Vertex_handle after) const
  {
    return !m_is_input[v] && m_cdt.number_of_enclosing_constraints(before, v) == 1 &&
           m_cdt.number_of_enclosing_constraints(v, after) == 1;
  }

private:
  const Cdt& m_cdt;
  Unique_hash_map<Vertex_handle, bool> m_is_input;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CONSTRAINT_HIERARCHY_H
