// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_MARKERS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_MARKERS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/read_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/write_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/utility.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The user's markers of the segments of an outline, for the pieces that stand for them.
template <class Cdt, class NamedParameters>
class Outline_markers_2
{
  using Maps = Tag_maps<NamedParameters>;
  using Marker = Tag_type<NamedParameters, internal_np::edge_marker_t>;

public:
  /// Vertices at which markers change are ends in `reading`.
  Outline_markers_2(const NamedParameters& np, [[maybe_unused]] Outline_reading_2<Cdt>& reading) : m_maps(np)
  {
    if constexpr (Maps::has_markers) {
      std::vector<std::optional<Marker>> first(reading.problem.outline.points.size()); // around each vertex
      for (const Outline_segment_2& s : reading.problem.outline.segments) {
        m_markers.push_back(
          get(m_maps.markers(), CGAL::make_sorted_pair(reading.vertex(s.source), reading.vertex(s.target))));
        for (Index v : {s.source, s.target})
          if (!first[v])
            first[v] = m_markers.back();
          else if (!(*first[v] == m_markers.back()))
            reading.problem.is_end[v] = 1;
      }
    }
  }

  /// the old outline: `visit(key, marker)`
  template <class Visit>
  void visit_old([[maybe_unused]] const Outline_reading_2<Cdt>& reading, [[maybe_unused]] const Visit& visit) const
  {
    if constexpr (Maps::has_markers)
      for (std::size_t k = 0; k < m_markers.size(); ++k) {
        const Outline_segment_2& s = reading.problem.outline.segments[k];
        visit(CGAL::make_sorted_pair(reading.vertex(s.source), reading.vertex(s.target)), m_markers[k]);
      }
  }

  /// takes those of the old outline out of the map
  void forget_old(const Outline_reading_2<Cdt>& reading) const
  {
    visit_old(reading, [this](const auto& edge, const Marker&) { forget_if_possible(m_maps.markers(), edge); });
  }

  /// gives each piece that of the segment that it stands for, or of the nearest one if a rule made it
  void write([[maybe_unused]] const Simplified_outline_2& outline,
             [[maybe_unused]] const Outline_writing_2<Cdt>& written) const
  {
    if constexpr (Maps::has_markers) {
      const std::vector<Index> origins = nearest_origins(outline);
      for (std::size_t k = 0; k < origins.size(); ++k) {
        const Outline_segment_2& s = outline.segments[k];
        put(m_maps.markers(), CGAL::make_sorted_pair(written.vertex(s.source), written.vertex(s.target)),
            origins[k] == no_index ? Marker() : m_markers[origins[k]]);
      }
    }
  }

private:
  /// Of each piece the old segment that it stands for, or the nearest one that does along the boundary, in pieces.
  static std::vector<Index> nearest_origins(const Simplified_outline_2& outline)
  {
    const std::vector<Outline_segment_2>& pieces = outline.segments;
    std::vector<std::vector<Index>> at(outline.points.size()); // boundary pieces
    std::vector<Index> origins, queue;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      origins.push_back(pieces[k].origin);
      if (pieces[k].inside_left == pieces[k].inside_right)
        continue; // rules make no such ones
      if (pieces[k].origin != no_index)
        queue.push_back(static_cast<Index>(k));
      for (Index v : {pieces[k].source, pieces[k].target})
        at[v].push_back(static_cast<Index>(k));
    }
    for (std::size_t first = 0; first < queue.size(); ++first)
      for (Index v : {pieces[queue[first]].source, pieces[queue[first]].target})
        for (Index k : at[v])
          if (origins[k] == no_index) {
            origins[k] = origins[queue[first]];
            queue.push_back(k);
          }
    return origins;
  }

  Maps m_maps;
  std::vector<Marker> m_markers; // of the old segments
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_MARKERS_2_H
