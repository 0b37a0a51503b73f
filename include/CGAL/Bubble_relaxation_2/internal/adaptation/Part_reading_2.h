// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_READING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_READING_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/iterator.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What is read from a part of a triangulation of a certain type. Vertices of the rim are corners.
template <class Cdt>
class Part_reading_2 : public Read_domain_2
{
public:
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// with the pins and the tags of the user's
  template <class NamedParameters>
  Part_reading_2(const Cdt& cdt, const Marked_copy_2& copy, const NamedParameters& np)
    : Read_domain_2(copy, Vertex_order<Cdt>::is_before())
  {
    const auto is_pinned = internal::is_pinned<Cdt>(np);
    check_regions<Cdt>(np, copy);
    Said_of_constraints<NamedParameters>{np}(m_edges, [this](Index v) { return vertex(v); }, m_is_given);
    for (std::size_t v = 0; v < m_is_pinned.size(); ++v)
      m_is_pinned[v] = is_pinned(vertex(static_cast<Index>(v)));
    keep_ends_of_others(cdt);
    if constexpr (Has_constraint_hierarchy<Cdt>::value)
      read_hierarchy(cdt);
    build();
  }

  Vertex_handle vertex(Index v) const { return Handles<Cdt>::vertex(m_vertices.addresses[v]); }

private:
  /// constraints that do not belong to the part may end at its vertices
  void keep_ends_of_others(const Cdt& cdt)
  {
    std::vector<int> degree(m_is_given.size(), 0);
    for (const Constrained_edge_2& e : m_edges)
      for (Index v : {e.source, e.target})
        ++degree[v];
    for (std::size_t v = 0; v < degree.size(); ++v) {
      tick(v);
      if (degree[v] == 2 && !m_is_given[v]) {
        std::size_t all = 0;
        cdt.incident_constraints(vertex(static_cast<Index>(v)), CGAL::Counting_output_iterator(&all));
        m_is_given[v] = all != 2;
      }
    }
  }

  /// Only vertices that were not given as points of a constraint, on pieces that belong to one constraint only, may
  /// merely split it.
  void read_hierarchy(const Cdt& cdt)
  {
    for (Constrained_edge_2& e : m_edges) {
      if (e.kind != Edge_kind::TAKES_BUBBLES)
        continue;
      const Vertex_handle u = vertex(e.source), v = vertex(e.target);
      check_is_of_constraint(cdt, u, v);
      e.is_of_one_constraint = cdt.number_of_enclosing_constraints(u, v) == 1;
      const auto context = *cdt.contexts_begin(u, v);
      auto first = context.current(), second = first;
      ++second;
      const bool is_forward = *first == u;
      if (first == context.vertices_begin() || first.input())
        m_is_given[is_forward ? e.source : e.target] = 1;
      const bool is_input = second.input();
      if (is_input || ++second == context.vertices_end())
        m_is_given[is_forward ? e.target : e.source] = 1;
    }
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_READING_2_H
