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

  /// takes those of the old outline out of the map
  void forget_old([[maybe_unused]] const Outline_reading_2<Cdt>& reading) const
  {
    if constexpr (Maps::has_markers)
      for (const Outline_segment_2& s : reading.problem.outline.segments)
        forget_if_possible(m_maps.markers(),
                           CGAL::make_sorted_pair(reading.vertex(s.source), reading.vertex(s.target)));
  }

  /// gives each piece that of the segment that it stands for, or none if a rule made it
  void write([[maybe_unused]] const Simplified_outline_2& outline,
             [[maybe_unused]] const Outline_writing_2<Cdt>& written) const
  {
    if constexpr (Maps::has_markers)
      for (const Outline_segment_2& s : outline.segments)
        put(m_maps.markers(), CGAL::make_sorted_pair(written.vertex(s.source), written.vertex(s.target)),
            s.origin == no_index ? Marker() : m_markers[s.origin]);
  }

private:
  Maps m_maps;
  std::vector<Marker> m_markers; // of the old segments
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_MARKERS_2_H
