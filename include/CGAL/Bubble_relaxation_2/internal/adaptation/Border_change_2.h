// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_BORDER_CHANGE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_BORDER_CHANGE_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Face_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Sliver_opening_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/exact_predicates.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Takes vertices out of a constraint at the border of the domain, and puts others in: what becomes of the faces beyond
/// it, which are out of the domain, finite or not. They see the constraint as open sides, with themselves on the left.
template <class Cdt>
class Border_change_2
{
  using Exchange = Face_exchange_2<Cdt>;
  using Vertex_handle = typename Exchange::Vertex_handle;
  using Face_handle = typename Exchange::Face_handle;
  using Side = typename Exchange::Side;
  using Corners = std::vector<Vertex_handle>;

public:
  Border_change_2(const Cdt& cdt, Exchange& exchange)
    : m_cdt(cdt), m_exchange(exchange), m_open_sliver(cdt, exchange)
  {}

  /// takes `w` out, which is between `u` and `v`; returns whether that can be done
  bool remove(Vertex_handle u, Vertex_handle w, Vertex_handle v)
  {
    for (std::size_t turn = 0; open_slivers_around(u, w, v); ++turn)
      if (turn == most_slivers)
        return false; // of roundings that contradict each other: they would be turned to and fro for ever
    m_corners.assign(1, v);
    m_sides.clear();
    Face_handle f = m_exchange.open_side(w, v).face;
    for (;;) { // counterclockwise around w
      if (m_exchange.is_dropped(f))
        return false; // of faces that do not fit together
      const int i = f->index(w);
      m_sides.push_back(m_exchange.side(f, i));
      m_corners.push_back(f->vertex(Cdt::cw(i)));
      m_exchange.drop(f);
      if (m_corners.back() == u)
        break;
      if (f->is_constrained(Cdt::ccw(i)))
        return false; // another constraint ends there
      f = m_exchange.across(f, Cdt::ccw(i));
    }
    m_exchange.forget_open_side(w, v);
    m_exchange.forget_open_side(u, w);
    if (m_corners.size() == 2)
      return open_side(m_sides.front());
    m_corners.push_back(v); // the side from u to v closes the hole
    m_sides.push_back(Side{Face_handle(), 0, true});
    return fill_hole();
  }

  /// puts `p` in between `u` and `v`
  void insert(Vertex_handle u, Vertex_handle p, Vertex_handle v)
  {
    m_open_sliver(m_exchange.open_side(u, v).face);
    const Side open = m_exchange.open_side(u, v);
    const Face_handle f = open.face;
    const int i = open.index;
    const Vertex_handle c = f->vertex(i);
    const Side cu = m_exchange.side(f, Cdt::cw(i)), vc = m_exchange.side(f, Cdt::ccw(i)),
               to_inside{Face_handle(), 0, true};
    m_exchange.drop(f);
    m_exchange.forget_open_side(u, v);
    const Face_handle first = m_exchange.add_face(c, u, p), second = m_exchange.add_face(c, p, v);
    m_exchange.link(first, 0, to_inside);
    m_exchange.link(second, 0, to_inside);
    m_exchange.link(first, 2, cu);
    m_exchange.link(second, 1, vc);
    m_exchange.link(first, 1, Side{second, 2, false});
  }

private:
  static constexpr std::size_t most_slivers = 1000; // at a vertex

  /// Opens slivers at `w`, which is between `u` and `v`; returns whether there is one.
  bool open_slivers_around(Vertex_handle u, Vertex_handle w, Vertex_handle v)
  {
    const Face_handle first = m_exchange.open_side(w, v).face;
    Face_handle f = first;
    do {
      if (m_open_sliver(f))
        return true;
      const int i = f->index(w);
      if (f->vertex(Cdt::cw(i)) == u || f->is_constrained(Cdt::ccw(i)))
        return false;
      f = m_exchange.across(f, Cdt::ccw(i));
    } while (f != first);
    return false;
  }

  /// a single face had a corner there: what is behind it is now at the border
  bool open_side(const Side& s)
  {
    if (s.is_constrained)
      return false; // two constraints would become one
    const Face_handle f = m_exchange.is_new(s.face) ? s.face : m_exchange.copy(s.face);
    m_exchange.link(f, s.index, Side{Face_handle(), 0, true});
    return true;
  }

  /// The hole has the sides `m_sides[k]` from `m_corners[k]` to `m_corners[k + 1]`, counterclockwise, and the last
  /// corner is the first one.
  bool fill_hole()
  {
    const auto infinite = std::find(m_corners.begin(), m_corners.end(), m_cdt.infinite_vertex());
    if (infinite != m_corners.end()) {
      if (std::find(infinite + 1, m_corners.end(), m_cdt.infinite_vertex()) != m_corners.end())
        return false; // slivers meet in a corner only
      fill_from(static_cast<std::size_t>(infinite - m_corners.begin()));
      return true;
    }
    m_corners.pop_back();
    while (m_corners.size() > 3)
      if (!cut_ear())
        return false;
    if (!is_counterclockwise<Cdt>(m_corners[0], m_corners[1], m_corners[2]))
      return false;
    const Face_handle f = m_exchange.add_face(m_corners[0], m_corners[1], m_corners[2]);
    for (int k = 0; k < 3; ++k)
      m_exchange.link(f, Cdt::cw(k), m_sides[static_cast<std::size_t>(k)]);
    return true;
  }

  /// one infinite face beyond each side between finite corners: the hull is made convex later
  void fill_from(std::size_t at)
  {
    const std::size_t n = m_sides.size();
    const Vertex_handle infinite = m_corners[at];
    Side behind = m_sides[at]; // of the side from the infinite vertex to the first corner
    for (std::size_t k = 1; k + 1 < n; ++k) {
      const std::size_t first = (at + k) % n;
      const Face_handle f = m_exchange.add_face(infinite, m_corners[first], m_corners[(first + 1) % n]);
      m_exchange.link(f, 0, m_sides[first]);
      m_exchange.link(f, 2, behind);
      behind = Side{f, 1, false};
    }
    m_exchange.link(behind.face, behind.index, m_sides[(at + n - 1) % n]);
  }

  /// cuts a triangle off the hole that has no other corner in it
  bool cut_ear()
  {
    const std::size_t n = m_corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n, last = (k + 2) % n;
      if (!is_ear(k, next, last))
        continue;
      const Face_handle f = m_exchange.add_face(m_corners[k], m_corners[next], m_corners[last]);
      m_exchange.link(f, 2, m_sides[k]);
      m_exchange.link(f, 0, m_sides[next]);
      m_sides[k] = Side{f, 1, false};
      m_sides.erase(m_sides.begin() + static_cast<std::ptrdiff_t>(next));
      m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(next));
      return true;
    }
    return false;
  }

  bool is_ear(std::size_t k, std::size_t next, std::size_t last) const
  {
    const Vertex_handle a = m_corners[k], b = m_corners[next], c = m_corners[last];
    if (!is_counterclockwise<Cdt>(a, b, c))
      return false;
    return std::none_of(m_corners.begin(), m_corners.end(), [&](Vertex_handle v) {
      return v != a && v != b && v != c && !is_counterclockwise<Cdt>(b, a, v) && !is_counterclockwise<Cdt>(c, b, v) &&
             !is_counterclockwise<Cdt>(a, c, v);
    });
  }

  const Cdt& m_cdt;
  Exchange& m_exchange;
  Sliver_opening_2<Cdt, Exchange> m_open_sliver;
  Corners m_corners;         // of a hole
  std::vector<Side> m_sides; // behind the sides of the hole
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_BORDER_CHANGE_2_H
