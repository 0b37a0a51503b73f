// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_TRIANGULATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_TRIANGULATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_2.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The triangles of an outline and their regions, for rules that change it: triangles are taken out of the domain or
/// into it, and what bounds the domain then is the new outline.
class Outline_triangulation_2
{
public:
  /// \param gap the least width that the outline is cut for
  /// \throws std::invalid_argument if rounded segments cross, or what they are cut in is no more than roundings
  Outline_triangulation_2(const Outline_2& outline, double gap) : m_outline(outline)
  {
    const Ordered_outline_2 ordered = along_curve(outline);
    const Marking_error error = mark_triangulation(ordered.points, ordered.edges, m_marked);
    if (error == Marking_error::POINTS_COINCIDE)
      throw std::invalid_argument("Bubble_relaxation_2: parameter minimum_gap = " + in_words(gap) +
                                  " is no more than roundings of the coordinates: parts of constraints coincide");
    if (error != Marking_error::NONE)
      throw std::invalid_argument("Bubble_relaxation_2: constraints of the triangulation lie so near to each other "
                                  "that they, or the parts that they are cut in for minimum_gap = " + in_words(gap) +
                                  ", cross when rounded to double");
    m_marked.points = outline.points;
    for (auto& triangle : m_marked.vertices)
      for (Index& v : triangle)
        v = ordered.order[v];
    m_was_inside = m_marked.inside;
  }

  const Flat_triangulation_2& tr() const { return m_marked; }
  std::size_t size() const { return m_marked.inside.size(); }

  bool is_inside(Index t) const { return t != no_index && m_marked.inside[t]; }
  bool was_inside(Index t) const { return t != no_index && m_was_inside[t]; }
  void set_inside(Index t, bool inside) { m_marked.inside[t] = inside; }

  /// the segment on a side of a triangle, `no_index` if there is none
  Index segment(Index t, int i) const { return m_marked.edges[t][i]; }
  Index neighbor(Index t, int i) const { return tr().neighbors[t][i]; }

  double area(Index t) const { return CGAL::area(tr().point(t, 0), tr().point(t, 1), tr().point(t, 2)); }

  double area(const std::vector<Index>& triangles) const
  {
    double sum = 0;
    for (Index t : triangles)
      sum += area(t);
    return sum;
  }

  /// The triangles with a property, in sets that are connected over sides without a segment.
  template <class Property>
  std::vector<std::vector<Index>> regions(const Property& has_property) const
  {
    return connected_parts(m_marked, has_property, [this](Index t, int i) { return segment(t, i) != no_index; });
  }

  /// What bounds the domain now, and the segments within it and outside of it that are no boundary.
  Outline_2 new_outline() const
  {
    Outline_2 result = m_outline;
    result.segments.clear();
    for (std::size_t k = 0; k < size(); ++k)
      for (int i = 0; i < 3; ++i)
        add_side(static_cast<Index>(k), i, result);
    result.sort_segments();
    return without_idle_vertices(result);
  }

private:
  void add_side(Index t, int i, Outline_2& outline) const
  {
    const Index n = neighbor(t, i), e = segment(t, i);
    if (n != no_index && n < t)
      return; // was seen from there
    const bool left = is_inside(t), right = is_inside(n);
    const bool is_kept = e != no_index && ((left && right) || !(was_inside(t) || was_inside(n)));
    if (left == right && !is_kept)
      return;
    const Index origin = e == no_index ? no_index : m_outline.segments[e].origin;
    outline.add({tr().vertices[t][ccw(i)], tr().vertices[t][cw(i)], left, right, origin});
  }

  const Outline_2& m_outline;
  Marked_triangulation_2 m_marked;
  std::vector<char> m_was_inside;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_TRIANGULATION_2_H
