// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_set>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Finds the vertex and the constraint that are the nearest to a point, no farther than a tolerance, or than some
/// roundings of the coordinates. It goes from face to face over edges that are so near.
template <class Cdt>
class Constraint_search_2
{
  using Face_handle = typename Cdt::Face_handle;
  using Vertex_handle = typename Cdt::Vertex_handle;

public:
  /// \param start the face, infinite perhaps, in which `p` lies
  Constraint_search_2(const Cdt& cdt, const typename Cdt::Point& p, double tolerance, Face_handle start)
    : m_cdt(cdt), m_point(p), m_tolerance(tolerance), m_place(point_in_double<Cdt>(p))
  {
    reach(start);
    while (!m_stack.empty()) {
      const Face_handle f = m_stack.back();
      m_stack.pop_back();
      if (m_cdt.is_infinite(f))
        look_from_outside(f);
      else
        for (int i = 0; i < 3; ++i)
          if (is_near(f, i))
            reach(f->neighbor(i));
    }
  }

  /// the vertex, if there is one
  Vertex_handle vertex() const { return m_vertex; }

  /// the constrained edge beside which the point lies; without a face if there is none
  typename Cdt::Edge edge() const { return m_edge; }

private:
  using Rank = std::array<double, 3>; ///< distance and place: which face is seen first must not matter

  void reach(Face_handle f)
  {
    if (m_reached.insert(&*f).second)
      m_stack.push_back(f);
  }

  /// the hull may be so straight that many of its edges are seen, of which the nearest is looked for
  void look_from_outside(Face_handle f)
  {
    const int k = f->index(m_cdt.infinite_vertex()), a = Cdt::ccw(k), b = Cdt::cw(k);
    const bool near = is_near(f, k);
    if (near)
      reach(f->neighbor(k));
    if (near || m_cdt.geom_traits().orientation_2_object()(f->vertex(a)->point(), f->vertex(b)->point(), m_point) !=
                  RIGHT_TURN)
      for (int i : {a, b})
        reach(f->neighbor(i));
  }

  /// whether a side of a face is near; notes it, and its ends, if it is the nearest
  bool is_near(Face_handle f, int i)
  {
    const Vertex_handle ends[] = {f->vertex(Cdt::ccw(i)), f->vertex(Cdt::cw(i))};
    const Point a = point_in_double<Cdt>(ends[0]->point()), b = point_in_double<Cdt>(ends[1]->point());
    const double dx = b.x() - a.x(), dy = b.y() - a.y(), px = m_place.x() - a.x(), py = m_place.y() - a.y();
    const double length = length_of(dx, dy), along = (px * dx + py * dy) / length;
    if (!is_within_magnitudes(length))
      throw std::invalid_argument("Bubble_relaxation_2: the length " + in_words(length) + " of an edge near to " +
                                  in_words(m_place.x(), m_place.y()) + " must be " + required_of_length(length));
    const bool is_near_source = is_near(ends[0], a), is_near_target = is_near(ends[1], b);
    if (!(along > 0 && along < length))
      return is_near_source || is_near_target;
    const double reach = reach_of((std::max)({magnitude(a), magnitude(b), magnitude(m_place)}));
    const double off = std::abs(px * dy - py * dx) / length;
    const Rank rank{off, a.x() + b.x(), a.y() + b.y()};
    if (off <= reach && f->is_constrained(i) && (m_edge.first == Face_handle() || rank < m_rank_of_edge)) {
      m_rank_of_edge = rank;
      m_edge = {f, i};
    }
    return off <= reach || is_near_source || is_near_target;
  }

  /// whether a vertex is near; notes it if it is the nearest
  bool is_near(Vertex_handle v, const Point& p)
  {
    const double distance = length_of(m_place.x() - p.x(), m_place.y() - p.y());
    if (!(distance <= reach_of((std::max)(magnitude(p), magnitude(m_place)))))
      return false;
    const Rank rank{distance, p.x(), p.y()};
    if (m_vertex == Vertex_handle() || rank < m_rank_of_vertex) {
      m_rank_of_vertex = rank;
      m_vertex = v;
    }
    return true;
  }

  static double magnitude(const Point& p) { return (std::max)(std::abs(p.x()), std::abs(p.y())); }

  double reach_of(double largest_coordinate) const
  {
    return (std::max)(m_tolerance, rounding_of(largest_coordinate));
  }

  const Cdt& m_cdt;
  const typename Cdt::Point& m_point;
  double m_tolerance;
  Point m_place;
  std::unordered_set<const void*> m_reached;
  std::vector<Face_handle> m_stack; // faces to be looked at
  Vertex_handle m_vertex;
  typename Cdt::Edge m_edge{Face_handle(), 0};
  Rank m_rank_of_vertex, m_rank_of_edge;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H
