// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_DELAUNAY_REPAIR_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_DELAUNAY_REPAIR_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Face_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/exact_predicates.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Makes the new faces of an exchange those of a constrained Delaunay triangulation, by flips.
template <class Cdt>
class Delaunay_repair_2
{
  using Exchange = Face_exchange_2<Cdt>;
  using Vertex_handle = typename Exchange::Vertex_handle;
  using Face_handle = typename Exchange::Face_handle;

public:
  Delaunay_repair_2(const Cdt& cdt, Exchange& exchange) : m_cdt(cdt), m_exchange(exchange) {}

  /// A vertex on an edge of the convex hull may lie beside it by a rounding. What is dented is filled; faces in between
  /// are out of the domain. Returns whether no vertex hangs on the hull then.
  /// \pre faces fit together
  bool make_hull_convex()
  {
    std::vector<Face_handle> doubtful;
    for (Face_handle f : m_exchange.new_faces())
      if (!m_exchange.is_dropped(f) && m_cdt.is_infinite(f))
        doubtful.push_back(f);
    while (!doubtful.empty()) {
      const Face_handle f = doubtful.back();
      doubtful.pop_back();
      if (!m_cdt.is_infinite(f))
        continue;
      const int dent = dented_side(f);
      if (dent == -1)
        continue;
      const Face_handle g = m_exchange.across(f, dent);
      m_exchange.flip(f, dent);
      doubtful.push_back(f);
      doubtful.push_back(g);
    }
    return is_hull_simple();
  }

  /// finite new faces from `first` on, which are not counterclockwise
  std::vector<Face_handle> flat_faces(std::size_t first) const
  {
    std::vector<Face_handle> result;
    for (std::size_t k = first; k < m_exchange.new_faces().size(); ++k) {
      tick(k);
      const Face_handle f = m_exchange.new_faces()[k];
      if (!m_exchange.is_dropped(f) && !m_cdt.is_infinite(f) &&
          !is_counterclockwise<Cdt>(f->vertex(0), f->vertex(1), f->vertex(2)))
        result.push_back(f);
    }
    return result;
  }

  /// flips edges of new faces from `first` on until all are Delaunay that are not constrained; `may_reach_out`: whether
  /// also old faces behind them are to take part
  /// \pre no face is flat
  void flip(std::size_t first, bool may_reach_out)
  {
    std::vector<std::pair<Face_handle, int>> doubtful;
    doubtful.reserve(3 * (m_exchange.new_faces().size() - first));
    for (std::size_t k = first; k < m_exchange.new_faces().size(); ++k) {
      tick(k);
      for (int i = 0; i < 3 && !m_exchange.is_dropped(m_exchange.new_faces()[k]); ++i)
        doubtful.emplace_back(m_exchange.new_faces()[k], i);
    }
    while (!doubtful.empty()) {
      tick(doubtful.size());
      const auto [f, i] = doubtful.back();
      doubtful.pop_back();
      if (f->is_constrained(i) || !(may_reach_out || m_exchange.is_new(f->neighbor(i))) || !is_illegal(f, i))
        continue;
      const Face_handle g = m_exchange.across(f, i);
      m_exchange.flip(f, i);
      make_room_for(6, doubtful);
      for (Face_handle side_of : {f, g})
        for (int k = 0; k < 3; ++k)
          doubtful.emplace_back(side_of, k);
    }
  }

  /// whether the vertex opposite to a side of a new face is in the circle of the face behind that
  bool is_illegal(Face_handle f, int i) const
  {
    const Face_handle n = f->neighbor(i);
    return !m_cdt.is_infinite(f) && !m_cdt.is_infinite(n) &&
           is_in_circle<Cdt>(n->vertex(0), n->vertex(1), n->vertex(2), f->vertex(i));
  }

private:
  /// whether each vertex of the hull has two infinite faces: others may hang on one where slivers were opened
  bool is_hull_simple() const
  {
    std::map<Vertex_handle, int> number;
    for (Face_handle f : m_exchange.new_faces())
      if (!m_exchange.is_dropped(f) && m_cdt.is_infinite(f))
        for (int i = 0; i < 3; ++i)
          ++number[f->vertex(i)];
    return std::all_of(number.begin(), number.end(), [&](const auto& at) {
      return m_cdt.is_infinite(at.first) || at.second + number_of_old_infinite_faces(at.first) == 2;
    });
  }

  /// those that stay
  int number_of_old_infinite_faces(Vertex_handle v) const
  {
    if (v->face() == Face_handle()) // a new vertex
      return 0;
    int result = 0;
    auto f = m_cdt.incident_faces(v), first = f;
    do
      result += m_cdt.is_infinite(f) && !m_exchange.is_taken(f) ? 1 : 0;
    while (++f != first);
    return result;
  }

  /// the side of an infinite face behind which the hull turns to the wrong side, or -1
  int dented_side(Face_handle f) const
  {
    const int i = f->index(m_cdt.infinite_vertex());
    const Vertex_handle a = f->vertex(Cdt::ccw(i)), b = f->vertex(Cdt::cw(i)); // clockwise on the hull
    const Face_handle next = f->neighbor(Cdt::ccw(i)), last = f->neighbor(Cdt::cw(i));
    const Vertex_handle after = next->vertex(Cdt::cw(next->index(m_cdt.infinite_vertex()))),
                        before = last->vertex(Cdt::ccw(last->index(m_cdt.infinite_vertex())));
    if (is_counterclockwise<Cdt>(a, b, after))
      return Cdt::ccw(i);
    return is_counterclockwise<Cdt>(before, a, b) ? Cdt::cw(i) : -1;
  }

  const Cdt& m_cdt;
  Exchange& m_exchange;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_DELAUNAY_REPAIR_2_H
