// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_ASSEMBLY_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_ASSEMBLY_2_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Makes one outline of the paths that replace the spans of another one.
class Outline_assembly_2
{
public:
  Outline_assembly_2(const Outline_2& outline, const std::vector<Outline_span_2>& spans,
                     const std::vector<Fitted_path_2>& paths)
    : m_outline(outline), m_spans(spans), m_paths(paths), m_number(outline.points.size(), no_index)
  {}

  Simplified_outline_2 operator()()
  {
    for (std::size_t s = 0; s < m_spans.size(); ++s) {
      m_result.spans.emplace_back();
      add_vertices(m_spans[s], m_paths[s], m_result.spans.back());
      add_origins(m_spans[s], m_result.spans.back());
      add_segments(m_spans[s], m_paths[s], m_result.spans.back());
    }
    return std::move(m_result);
  }

private:
  Index add_vertex(const Fitted_vertex_2& v)
  {
    const Index vertex = v.vertex != no_index ? v.vertex : index_among(m_outline.points, v.point); // it came back to
    if (vertex != no_index && m_number[vertex] != no_index)
      return m_number[vertex];
    const Index number = static_cast<Index>(m_result.points.size());
    m_result.points.push_back(v.point);
    m_result.old_vertices.push_back(vertex == no_index ? no_index : m_outline.given[vertex]);
    if (vertex != no_index)
      m_number[vertex] = number;
    return number;
  }

  void add_vertices(const Outline_span_2& span, const Fitted_path_2& path, Simplified_span_2& result)
  {
    for (std::size_t k = 0; k < path.size(); ++k)
      result.vertices.push_back(span.is_ring && k + 1 == path.size() ? result.vertices.front() : add_vertex(path[k]));
  }

  void add_origins(const Outline_span_2& span, Simplified_span_2& result) const
  {
    for (std::size_t k = 0; k < span.size(); ++k) {
      result.origins.push_back(m_outline.segments[span.segments[k]].origin);
      result.is_forward.push_back(span.vertices[k] < span.vertices[k + 1]);
    }
  }

  /// a piece stands for the segment of the old outline in the middle of its part
  void add_segments(const Outline_span_2& span, const Fitted_path_2& path, const Simplified_span_2& result)
  {
    for (std::size_t k = 1; k < path.size(); ++k) {
      const std::size_t middle = span.place(path[k - 1].segment + (path[k].segment - path[k - 1].segment) / 2);
      m_result.segments.push_back({result.vertices[k - 1], result.vertices[k], span.inside_left, span.inside_right,
                                   result.origins[middle]});
    }
  }

  const Outline_2& m_outline;
  const std::vector<Outline_span_2>& m_spans;
  const std::vector<Fitted_path_2>& m_paths;
  std::vector<Index> m_number; // of the outline's vertices in the result
  Simplified_outline_2 m_result;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_OUTLINE_ASSEMBLY_2_H
