// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WRITE_OUTLINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WRITE_OUTLINE_H

#include <CGAL/Bubble_relaxation_2/internal/domain/mark_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/locate_straight.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/read_outline.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Writes an outline into the triangulation that it was made from: constraints go unless they are of the new outline
/// too, then vertices come and go, then the new constraints are inserted and the domain is marked. Vertices that stay
/// are not touched.
template <class Cdt>
class Outline_writing_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;
  using Cdt_point = typename Cdt::Point;
  static constexpr bool has_hierarchy = Has_constraint_hierarchy<Cdt>::value;

public:
  Outline_writing_2(Cdt& cdt, const Outline_reading_2<Cdt>& reading, const Simplified_outline_2& outline)
    : m_cdt(cdt), m_reading(reading), m_outline(outline), m_span_of_origin(reading.problem.outline.segments.size())
  {}

  void operator()()
  {
    remove(m_reading.free);
    if constexpr (has_hierarchy) {
      std::vector<std::pair<typename Cdt::Constraint_id, std::vector<Index>>> lines; // of constraints
      find_spans_of_origins();
      take_constraints(lines);
      insert_vertices();
      remove_vertices();
      give_constraints(lines);
    } else {
      remove_segments();
      insert_vertices();
      remove_vertices();
      for (const Outline_segment_2& s : m_outline.segments)
        insert_segment(s.source, s.target);
    }
    check();
    check_sides(mark_domain(m_cdt, [this](const auto& visit) {
      this->for_each_segment([&](const auto& edge, Vertex_handle source, const Outline_segment_2& s) {
        visit(edge, source, s.inside_left, s.inside_right);
      });
    }));
  }

  /// a vertex of the new outline, once it is written
  Vertex_handle vertex(Index v) const { return Handles<Cdt>::vertex(m_vertices[v]); }

private:
  struct Place_in_span
  {
    Index span = no_index;
    bool is_forward = true;
  };

  void remove_segments()
  {
    std::set<std::pair<Index, Index>> stay;
    for (const Outline_segment_2& s : m_outline.segments) {
      const Index a = m_outline.old_vertices[s.source], b = m_outline.old_vertices[s.target];
      stay.insert({(std::min)(a, b), (std::max)(a, b)});
    }
    for (const Outline_segment_2& s : m_reading.problem.outline.segments)
      if (stay.count({s.source, s.target}) == 0) {
        Face_handle f;
        int i = 0;
        m_cdt.is_edge(m_reading.vertex(s.source), m_reading.vertex(s.target), f, i);
        m_cdt.remove_constrained_edge(f, i);
      }
  }

  /// whether a segment is there as a whole
  bool is_there(Index a, Index b) const
  {
    Face_handle f;
    int i = 0;
    return m_cdt.is_edge(vertex(a), vertex(b), f, i) && f->is_constrained(i);
  }

  /// inserts segments, of which some may cross others when rounded
  /// \throws std::runtime_error for what CGAL throws then, depending on its tag
  template <class Insertion>
  auto insert_line(const std::vector<Index>& line, const Insertion& insert) const
  {
    try {
      return insert();
    } catch (const typename Cdt::Intersection_of_constraints_exception&) {
      for (std::size_t k = 1; k < line.size(); ++k)
        if (!is_there(line[k - 1], line[k]))
          throw_too_coarse(line[k - 1], line[k]);
      throw;
    }
  }

  /// if it is not there: CGAL may take what is inserted again for a crossing
  void insert_segment(Index a, Index b)
  {
    if (!is_there(a, b))
      insert_line({a, b}, [&] { m_cdt.insert_constraint(vertex(a), vertex(b)); });
  }

  /// Each between two that are there: in the order of the outline the points of one straight side would pass those of
  /// another from triangle to triangle, which takes the square of their number.
  /// \throws std::runtime_error if two of them become one
  void insert_vertices()
  {
    m_vertices.resize(m_outline.points.size());
    Vertex_handle near = m_cdt.finite_vertices_begin();
    for (Index v : in_rounds(indices_below(m_outline.points.size()))) {
      insert_vertex(static_cast<std::size_t>(v), near);
      near = vertex(v);
    }
  }

  void insert_vertex(std::size_t v, Vertex_handle near)
  {
    const Index old = m_outline.old_vertices[v];
    const Point& p = m_outline.points[v];
    const Vertex_handle handle =
      old != no_index ? m_reading.vertex(old) : insert_straight(m_cdt, Cdt_point(p.x(), p.y()), near);
    m_vertices[v] = &*handle;
    if (!m_taken.insert(m_vertices[v]).second)
      throw_too_coarse(static_cast<Index>(v), static_cast<Index>(v));
  }

  /// what was only of the old outline; not where a new vertex has come into the place of one that a rule took away
  void remove_vertices()
  {
    const Outline_2& old = m_reading.problem.outline;
    std::vector<char> goes(old.points.size(), 0);
    for (const Outline_segment_2& s : old.segments)
      goes[s.source] = goes[s.target] = 1;
    for (std::size_t v = 0; v < goes.size(); ++v)
      if (old.is_fixed[v])
        goes[v] = 0;
    for (Index v : m_outline.old_vertices)
      if (v != no_index)
        goes[v] = 0;
    std::vector<void*> gone;
    for (std::size_t v = 0; v < goes.size(); ++v) {
      void* const vertex = &*m_reading.vertex(static_cast<Index>(v));
      if (goes[v] && m_taken.count(vertex) == 0)
        gone.push_back(vertex);
    }
    remove(gone);
  }

  /// In no order along anything: of a straight side, each one's neighbours would be all that are left there.
  void remove(const std::vector<void*>& vertices)
  {
    std::vector<std::pair<std::uint64_t, void*>> scattered;
    for (void* v : vertices) {
      const Point p = point_in_double<Cdt>(Handles<Cdt>::vertex(v)->point());
      scattered.emplace_back(hash_of_place(p.x(), p.y()), v);
    }
    std::stable_sort(scattered.begin(), scattered.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [hash, v] : scattered)
      m_cdt.remove(Handles<Cdt>::vertex(v));
  }

  /// \throws std::runtime_error if a segment is not there as a whole
  void check() const
  {
    for (const Outline_segment_2& s : m_outline.segments)
      if (!is_there(s.source, s.target))
        throw_too_coarse(s.source, s.target);
  }

  /// for a segment, or for a vertex if both ends are the same
  [[noreturn]] void throw_too_coarse(Index source, Index target) const
  {
    const Point &a = m_outline.points[source], &b = m_outline.points[target];
    const std::string where =
      source == target ? "vertex " + in_words(a.x(), a.y()) + ", where there is another one,"
                       : "segment from " + in_words(a.x(), a.y()) + " to " + in_words(b.x(), b.y());
    throw std::runtime_error("Bubble_relaxation_2: the new outline cannot be written: at the " + where +
                             " the numbers of the kernel are too coarse");
  }

  /// \throws std::runtime_error if the domain is on another side of a segment: old vertices are where the kernel has
  /// them, not where they are in `double`, so others may be beyond segments at them
  void check_sides(const Domain_faces_2<Cdt>& faces) const
  {
    for_each_segment([&](const auto& edge, Vertex_handle source, const Outline_segment_2& s) {
      const auto [f, i] = edge;
      const bool f_is_left = f->vertex(Cdt::ccw(i)) == source;
      if (faces.contains(f) != (f_is_left ? s.inside_left : s.inside_right) ||
          faces.contains(f->neighbor(i)) != (f_is_left ? s.inside_right : s.inside_left))
        throw_too_coarse(s.source, s.target);
    });
  }

  /// calls `visit(edge, source, segment)`
  template <class Visit>
  void for_each_segment(const Visit& visit) const
  {
    for (const Outline_segment_2& s : m_outline.segments) {
      Face_handle f;
      int i = 0;
      m_cdt.is_edge(vertex(s.source), vertex(s.target), f, i);
      visit(typename Cdt::Edge(f, i), vertex(s.source), s);
    }
  }

  // Constraints of a `Constrained_triangulation_plus_2` keep their identifiers: while the old outline is gone and the
  // new one is not there yet, they stand for an edge beside the triangulation.

  void find_spans_of_origins()
  {
    for (std::size_t s = 0; s < m_outline.spans.size(); ++s) {
      const Simplified_span_2& span = m_outline.spans[s];
      bool is_whole = true; // no rule made a part of it
      for (Index origin : span.origins)
        is_whole &= origin != no_index;
      for (std::size_t k = 0; k < span.origins.size() && is_whole; ++k)
        m_span_of_origin[span.origins[k]] = {static_cast<Index>(s), span.is_forward[k] != 0};
    }
  }

  /// the places of the segments of a constraint in the spans; none if a rule took a part of it
  template <class Constraint_id>
  std::vector<Place_in_span> places(Constraint_id id) const
  {
    const auto& segments = m_reading.problem.outline.segments;
    std::vector<Place_in_span> result;
    auto v = m_cdt.vertices_in_constraint_begin(id), end = m_cdt.vertices_in_constraint_end(id);
    for (auto u = v++; v != end; u = v++) {
      const Index a = m_reading.number(*u), b = m_reading.number(*v);
      const auto found =
        std::lower_bound(segments.begin(), segments.end(), std::make_pair((std::min)(a, b), (std::max)(a, b)),
                         [](const Outline_segment_2& s, const std::pair<Index, Index>& e) {
                           return s.source != e.first ? s.source < e.first : s.target < e.second;
                         });
      Place_in_span place = m_span_of_origin[static_cast<std::size_t>(found - segments.begin())];
      if (place.span == no_index)
        return {};
      place.is_forward = place.is_forward == (a < b);
      result.push_back(place);
    }
    return result;
  }

  template <class Constraint_id>
  bool is_closed(Constraint_id id) const
  {
    auto last = m_cdt.vertices_in_constraint_end(id);
    return *--last == *m_cdt.vertices_in_constraint_begin(id);
  }

  template <class Lines>
  void take_constraints(Lines& lines)
  {
    const std::vector<Point>& old = m_reading.problem.outline.points;
    const Bbox_2 box = bbox_2(old.begin(), old.end());
    const double size = (std::max)(box.x_span(), box.y_span()), x = box.xmax() + size;
    m_beside[0] = &*m_cdt.insert(Cdt_point(x, box.ymin()));
    m_beside[1] = &*m_cdt.insert(Cdt_point(x, box.ymin() + size));
    std::vector<typename Cdt::Constraint_id> ids(m_cdt.constraints_begin(), m_cdt.constraints_end());
    for (auto id : ids) {
      lines.emplace_back(id, line(places(id), is_closed(id)));
      if (lines.back().second.empty()) {
        lines.pop_back();
        remove_constraint(id);
        continue;
      }
      exchange(id, m_cdt.insert_constraint(Handles<Cdt>::vertex(m_beside[0]), Handles<Cdt>::vertex(m_beside[1])));
    }
  }

  /// gives a constraint the polyline of another one, which goes
  template <class Constraint_id>
  void exchange(Constraint_id id, Constraint_id other)
  {
    m_cdt.hierarchy_ref().swap(id, other);
    remove_constraint(other);
  }

  /// As CGAL does it, but for a constraint that passes an edge twice: it is none any more the second time.
  template <class Constraint_id>
  void remove_constraint(Constraint_id id)
  {
    const std::vector<Vertex_handle> vertices(m_cdt.vertices_in_constraint_begin(id),
                                              m_cdt.vertices_in_constraint_end(id));
    m_cdt.hierarchy_ref().remove_constraint(id);
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      typename Cdt::Face_handle f;
      int i = 0;
      if (!m_cdt.is_subconstraint(vertices[k - 1], vertices[k]) && m_cdt.is_edge(vertices[k - 1], vertices[k], f, i) &&
          f->is_constrained(i))
        static_cast<typename Cdt::Triangulation&>(m_cdt).remove_constrained_edge(f, i);
    }
  }

  /// the vertices of the new outline along places in spans; a closed line that starts within a span comes back to it
  std::vector<Index> line(std::vector<Place_in_span> parts, bool is_closed) const
  {
    const auto are_same = [](const Place_in_span& p, const Place_in_span& q) {
      return p.span == q.span && p.is_forward == q.is_forward;
    };
    parts.erase(std::unique(parts.begin(), parts.end(), are_same), parts.end());
    if (is_closed && parts.size() > 1 && are_same(parts.front(), parts.back()))
      parts.pop_back();
    std::vector<Index> result;
    for (const Place_in_span& p : parts) {
      std::vector<Index> part = m_outline.spans[p.span].vertices;
      if (!p.is_forward)
        std::reverse(part.begin(), part.end());
      result.insert(result.end(), part.begin() + (result.empty() ? 0 : 1), part.end());
    }
    return result;
  }

  template <class Lines>
  void give_constraints(const Lines& lines)
  {
    for (auto l = lines.rbegin(); l != lines.rend(); ++l) { // CGAL finds the one that was taken last at once
      std::vector<Cdt_point> points;
      for (Index v : l->second)
        points.push_back(vertex(v)->point());
      exchange(l->first,
               insert_line(l->second, [&] { return m_cdt.insert_constraint(points.begin(), points.end()); }));
    }
    for (const Simplified_span_2& span : m_outline.spans) // what a rule made is of no constraint yet
      for (std::size_t k = 1; k < span.vertices.size(); ++k)
        insert_segment(span.vertices[k - 1], span.vertices[k]);
    for (void* v : m_beside)
      m_cdt.remove(Handles<Cdt>::vertex(v));
  }

  Cdt& m_cdt;
  const Outline_reading_2<Cdt>& m_reading;
  const Simplified_outline_2& m_outline;
  std::vector<void*> m_vertices; // of the new outline
  std::set<void*> m_taken;       // the same
  std::vector<Place_in_span> m_span_of_origin;
  void* m_beside[2] = {nullptr, nullptr}; // an edge beside the triangulation
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_WRITE_OUTLINE_H
