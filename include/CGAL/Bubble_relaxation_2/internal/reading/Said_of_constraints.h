// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_SAID_OF_CONSTRAINTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_SAID_OF_CONSTRAINTS_H

#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Constraint_graph_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Tags_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/property_map.h>
#include <CGAL/utility.h>

#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// What the user says of constraints of the domain: which ones are to stay as they are, and what markers they have.
template <class NamedParameters>
struct Said_of_constraints
{
  const NamedParameters& np;

  /// \param vertex `vertex(i)`: the handle of a vertex
  /// \param stays set for the ends of edges that stay, and where markers change: these are no mere splits of a line
  template <class Vertex>
  void operator()(std::vector<Constrained_edge_2>& edges, const Vertex& vertex, std::vector<char>& stays) const
  {
    protect(edges, vertex, stays);
    find_changes(edges, vertex, stays);
  }

private:
  /// a rim stays as it is
  static bool is_told_of(const Constrained_edge_2& e) { return e.is_in_domain() && e.kind != Edge_kind::RIM; }

  /// a constrained edge as a key of the user's maps
  template <class Vertex>
  static auto key(const Constrained_edge_2& e, const Vertex& vertex)
  {
    return CGAL::make_sorted_pair(vertex(e.source), vertex(e.target));
  }

  template <class Vertex>
  void protect([[maybe_unused]] std::vector<Constrained_edge_2>& edges, [[maybe_unused]] const Vertex& vertex,
               [[maybe_unused]] std::vector<char>& stays) const
  {
    using Value = Value_of<NamedParameters, internal_np::protect_constraints_t>;
    if constexpr (!is_missing<Value>) {
      const auto is_protected = parameters::get_parameter(np, internal_np::protect_constraints);
      for (Constrained_edge_2& e : edges) {
        if (!is_told_of(e))
          continue;
        bool is_kept = false;
        if constexpr (std::is_same<Value, bool>::value)
          is_kept = is_protected;
        else
          is_kept = static_cast<bool>(get(is_protected, key(e, vertex)));
        if (is_kept) {
          e.kind = Edge_kind::PROTECTED;
          stays[e.source] = stays[e.target] = 1;
        }
      }
    }
  }

  template <class Vertex>
  void find_changes([[maybe_unused]] const std::vector<Constrained_edge_2>& edges,
                    [[maybe_unused]] const Vertex& vertex, [[maybe_unused]] std::vector<char>& stays) const
  {
    if constexpr (Tag_maps<NamedParameters>::has_markers) {
      const auto map = Tag_maps<NamedParameters>(np).markers();
      using Marker = Tag_type<NamedParameters, internal_np::edge_marker_t>;
      std::vector<std::optional<Marker>> first(stays.size()); // around each vertex
      for (const Constrained_edge_2& e : edges) {
        if (!is_told_of(e))
          continue;
        const auto marker = get(map, key(e, vertex));
        for (Index v : {e.source, e.target})
          if (!first[v])
            first[v] = marker;
          else if (!(*first[v] == marker))
            stays[v] = 1;
      }
    }
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_SAID_OF_CONSTRAINTS_H
