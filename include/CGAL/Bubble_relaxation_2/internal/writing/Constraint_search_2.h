// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/reproducible_math.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
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
  using Plane = Plane_2<Cdt>;

public:
  /// \param start the face, infinite perhaps, in which `p` lies
  Constraint_search_2(const Cdt& cdt, const typename Cdt::Point& p, double tolerance, Face_handle start)
    : m_cdt(cdt), m_point(p), m_tolerance(tolerance), m_place(place(p))
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
  using Place = std::array<double, 2>;

  static Place place(const typename Cdt::Point& p)
  {
    return {CGAL::to_double(Plane::x(p)), CGAL::to_double(Plane::y(p))};
  }

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
    const Place a = place(ends[0]->point()), b = place(ends[1]->point());
    const double dx = b[0] - a[0], dy = b[1] - a[1], px = m_place[0] - a[0], py = m_place[1] - a[1];
    const double length = length_of(dx, dy), along = (px * dx + py * dy) / length;
    const double to_ends[] = {length_of(px, py), length_of(m_place[0] - b[0], m_place[1] - b[1])};
    const double largest = (std::max)({std::abs(a[0]), std::abs(a[1]), std::abs(b[0]), std::abs(b[1]),
                                       std::abs(m_place[0]), std::abs(m_place[1])});
    constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
    const double reach = (std::max)(m_tolerance, roundings * largest);
    for (int k : {0, 1})
      if (to_ends[k] <= reach && to_ends[k] < m_to_vertex) {
        m_to_vertex = to_ends[k];
        m_vertex = ends[k];
      }
    if (!(along > 0 && along < length))
      return (std::min)(to_ends[0], to_ends[1]) <= reach;
    const double off = std::abs(px * dy - py * dx) / length;
    const auto rank = std::make_tuple(off, a[0] + b[0], a[1] + b[1]); // which face is seen first must not matter
    if (off <= reach && f->is_constrained(i) && (m_edge.first == Face_handle() || rank < m_rank)) {
      m_rank = rank;
      m_edge = {f, i};
    }
    return off <= reach;
  }

  const Cdt& m_cdt;
  const typename Cdt::Point& m_point;
  double m_tolerance;
  Place m_place;
  std::unordered_set<const void*> m_reached;
  std::vector<Face_handle> m_stack; // faces to be looked at
  Vertex_handle m_vertex;
  double m_to_vertex = std::numeric_limits<double>::infinity();
  typename Cdt::Edge m_edge{Face_handle(), 0};
  std::tuple<double, double, double> m_rank; // of the edge
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_WRITING_CONSTRAINT_SEARCH_2_H
