// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SPAN_REPLACEMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SPAN_REPLACEMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Movable_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Piece_fitting_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Replaces a span of the movable outline by the best pieces that pass nothing else. Pieces take the place of the span
/// one after the other. Where one would touch or pass something, the one is taken that is the best of all others that
/// begin there; in the end segments of the span remain.
class Span_replacement_2
{
public:
  /// \param ids of the segments of the span in the movable outline
  Span_replacement_2(const Outline_2& outline, const Outline_span_2& span, const Outline_demands_2& demands,
                     const std::vector<Index>& ids, Movable_outline_2& movable)
    : m_outline(outline), m_span(span), m_demands(demands), m_old(ids), m_movable(movable)
  {}

  /// the new vertices from the first to the last, which is the first again if the span is a ring
  Fitted_path_2 operator()(const Piece_fitting_2& fitting)
  {
    const std::size_t start = fitting.best_start(), end = start + fitting.number_of_steps();
    const std::vector<double> cost_to_end = fitting.costs_to_end(start);
    Fitted_path_2 path{fitting.vertex(start)};
    bool is_possible = begin(path.front());
    for (std::size_t place = start; place < end && is_possible;) {
      is_possible = false;
      for (std::size_t next : fitting.ends_of_pieces(place, start, cost_to_end)) {
        const Fitted_vertex_2 v = fitting.vertex(next);
        is_possible = place_piece(path.back(), v, next == end);
        if (!is_possible)
          continue;
        path.push_back(v);
        place = next;
        break;
      }
      if (!is_possible) {
        is_possible = keep_segments(fitting, place, place + 1 == end, path);
        ++place;
      }
    }
    if (!is_possible) {
      put_back();
      return path_along(m_outline, m_span);
    }
    return path;
  }

  /// the segments that the span has now
  const std::vector<Index>& ids() const { return m_ids; }

private:
  using Path = Movable_outline_2::Path;

  const Point& old_point(Index k) const { return m_outline.points[m_span.vertex(k)]; }

  /// cuts a ring that starts within a segment there
  bool begin(const Fitted_vertex_2& first)
  {
    m_first = first;
    if (first.vertex != no_index)
      return true;
    const Index k = first.segment;
    const Path from{old_point(k), old_point(k + 1)}, to{from[0], first.point, from[1]};
    if (!replace({m_old[m_span.place(k)]}, from, to, true, m_demands.size[m_span.vertex(k)]))
      return false;
    m_head = m_ids.back();
    m_ids.pop_back();
    return true;
  }

  /// leaves the segments as they are between a place and the next one
  bool keep_segments(const Piece_fitting_2& fitting, std::size_t place, bool is_last, Fitted_path_2& path)
  {
    const Fitted_path_2 between = fitting.vertices_after(place);
    if (between.empty())
      return false; // that was tried
    for (const Fitted_vertex_2& v : between) {
      if (!place_piece(path.back(), v, false))
        return false;
      path.push_back(v);
    }
    path.push_back(fitting.vertex(place + 1));
    return place_piece(path[path.size() - 2], path.back(), is_last);
  }

  /// Puts a piece in the place of the part of the span that belongs to it, if it may be there.
  bool place_piece(const Fitted_vertex_2& a, const Fitted_vertex_2& b, bool is_last)
  {
    std::vector<Index> removed;
    Path from{a.point};
    // the first segment of a ring may be cut at the first vertex: its head comes last
    const Index last_segment = m_first.segment + static_cast<Index>(m_span.size());
    const bool ends_in_head = m_head != no_index && b.segment == last_segment && b.vertex == no_index;
    if (m_rest != no_index)
      removed.push_back(m_rest);
    const Index first = m_rest != no_index ? a.segment + 1 : a.segment;
    const Index end = b.vertex != no_index || ends_in_head ? b.segment : b.segment + 1; // of whole segments
    for (Index k = first; k < end; ++k)
      removed.push_back(m_old[m_span.place(k)]);
    for (Index k = a.segment + 1; k <= end; ++k)
      from.push_back(old_point(k));
    if (ends_in_head) {
      if (first <= last_segment)
        removed.push_back(m_head);
      from.push_back(m_first.point);
    }
    const bool has_rest = b.vertex == no_index && !is_last;
    Path to{a.point, b.point};
    if (has_rest)
      to.push_back(from.back());
    return replace(removed, from, to, has_rest, m_demands.size[m_span.vertex(a.segment)]);
  }

  bool replace(const std::vector<Index>& removed, const Path& from, const Path& to, bool has_rest,
               double size)
  {
    if (from != to && !m_movable.is_free(removed, from, to))
      return false;
    for (Index id : removed)
      m_movable.remove(id);
    for (std::size_t k = 1; k < to.size(); ++k)
      m_ids.push_back(m_movable.insert(to[k - 1], to[k], size));
    m_rest = no_index;
    if (has_rest) {
      m_rest = m_ids.back();
      m_ids.pop_back();
    }
    return true;
  }

  /// the old segments again
  void put_back()
  {
    for (Index id : m_ids)
      m_movable.remove(id);
    for (Index id : {m_rest, m_head})
      if (id != no_index && m_movable.grid().is_there(id))
        m_movable.remove(id);
    for (Index id : m_old)
      if (!m_movable.grid().is_there(id))
        m_movable.put_back(id);
    m_ids = m_old;
  }

  const Outline_2& m_outline;
  const Outline_span_2& m_span;
  const Outline_demands_2& m_demands;
  const std::vector<Index>& m_old;
  Movable_outline_2& m_movable;
  std::vector<Index> m_ids;
  Fitted_vertex_2 m_first;
  Index m_rest = no_index, m_head = no_index; // parts of segments behind the last piece, and before the first
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SPAN_REPLACEMENT_2_H
