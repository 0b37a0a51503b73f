// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SLIVER_OPENING_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SLIVER_OPENING_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/exact_predicates.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Where vertices lie beside an edge by a rounding, slivers fill the dents. They have no room for other vertices on
/// the edge, so their corners are given to the face beyond them, finite or not, which sees them all. What is not
/// Delaunay or convex then is made so later.
///
/// `Faces` changes them: `across(f, i)` is the face behind the side `i`, in a state that may be changed, `flip(f, i)`
/// turns that side.
template <class Cdt, class Faces>
class Sliver_opening_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Face_handle = typename Cdt::Face_handle;

public:
  Sliver_opening_2(const Cdt& cdt, Faces& faces) : m_cdt(cdt), m_faces(faces) {}

  /// opens `f`, if it is a sliver, after those behind it; returns whether anything was turned
  bool operator()(Face_handle f)
  {
    m_entered.clear();
    return open(f);
  }

private:
  static constexpr std::size_t most_slivers = 1000;

  bool open(Face_handle f)
  {
    if (!is_sliver(f) || m_entered.size() == most_slivers)
      return false;
    m_entered.push_back(f);
    bool is_changed = false;
    for (int i : sides_in_order(f))
      if (may_cross(f, i) && is_sliver(f->neighbor(i)))
        is_changed = open(m_faces.across(f, i)) || is_changed;
    for (int i : sides_in_order(f))
      if (may_cross(f, i) && is_seen(f, i)) {
        m_faces.flip(f, i);
        return true;
      }
    return is_changed;
  }

  bool may_cross(Face_handle f, int i) const
  {
    return !f->is_constrained(i) && std::find(m_entered.begin(), m_entered.end(), f->neighbor(i)) == m_entered.end();
  }

  /// by what is opposite to them: the numbers of a face's vertices tell how the triangulation came about
  std::array<int, 3> sides_in_order(Face_handle f) const
  {
    std::array<int, 3> sides{0, 1, 2};
    std::sort(sides.begin(), sides.end(), [&](int i, int j) {
      return m_cdt.compare_xy(f->vertex(i)->point(), f->vertex(j)->point()) == CGAL::SMALLER;
    });
    return sides;
  }

  /// whether the face behind the side `i` of a sliver is none, and sees all its corners
  bool is_seen(Face_handle sliver, int i) const
  {
    const Face_handle n = sliver->neighbor(i);
    if (m_cdt.is_infinite(n))
      return true;
    const Vertex_handle p = sliver->vertex(i), u = sliver->vertex(Cdt::ccw(i)), v = sliver->vertex(Cdt::cw(i)),
                        q = n->vertex(Cdt::ccw(n->index(u)));
    return !is_sliver(n) && is_counterclockwise<Cdt>(p, u, q) && is_counterclockwise<Cdt>(p, q, v);
  }

  /// whether a face is finite and flat up to some roundings
  bool is_sliver(Face_handle f) const
  {
    constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
    if (m_cdt.is_infinite(f))
      return false;
    const std::array<int, 3> order = sides_in_order(f);
    const Point p = point_in_double<Cdt>(f->vertex(order[0])->point()),
                q = point_in_double<Cdt>(f->vertex(order[1])->point()),
                r = point_in_double<Cdt>(f->vertex(order[2])->point());
    const Kernel::Vector_2 u = q - p, v = r - p;
    const double largest = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(q.x()), std::abs(q.y()),
                                       std::abs(r.x()), std::abs(r.y())}),
                 length = std::abs(u.x()) + std::abs(u.y()) + std::abs(v.x()) + std::abs(v.y());
    return std::abs(u.x() * v.y() - u.y() * v.x()) <= roundings * largest * length;
  }

  const Cdt& m_cdt;
  Faces& m_faces;
  std::vector<Face_handle> m_entered; // slivers, each once
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_SLIVER_OPENING_2_H
