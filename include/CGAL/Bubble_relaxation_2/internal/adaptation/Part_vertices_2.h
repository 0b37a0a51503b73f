// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_VERTICES_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_VERTICES_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Face_exchange_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_reading_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/outline.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The vertices of a part before and after: those of bubbles that lie where a vertex was are that vertex, others are
/// new.
template <class Cdt>
class Part_vertices_2
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  using Plane = Plane_2<Cdt>;

public:
  Part_vertices_2(const Part_reading_2<Cdt>& reading, const Bubbles_2& bubbles, const Elevations<Cdt>& elevations,
                  Face_exchange_2<Cdt>& exchange)
    : m_reading(reading), m_bubbles(bubbles), m_elevations(elevations), m_exchange(exchange),
      m_of_bubble(bubbles.size()), m_bubble_numbers(sizeof(typename Cdt::Vertex)), m_is_known(bubbles.size(), 0)
  {
    std::vector<Old_vertex> old = vertices_in_order();
    for (std::size_t i = 0; i < bubbles.size(); ++i) {
      tick(i);
      if (bubbles.is_corner(i))
        set(i, vertex_of_corner(reading, bubbles, i));
      else
        keep(i, old);
    }
    for (const Old_vertex& v : old)
      if (!v.stays)
        m_removed.push_back(reading.vertex(v.vertex));
  }

  /// of a bubble; it is made if there is none
  Vertex_handle operator()(Index bubble)
  {
    const std::size_t i = static_cast<std::size_t>(bubble);
    if (!m_is_known[i])
      set(i, m_exchange.add_vertex(point_of_vertex<Cdt>(m_reading, m_bubbles, m_elevations, i)));
    return m_of_bubble[i];
  }

  /// the bubble of a vertex, `no_index` if it has none
  Index bubble(Vertex_handle v) const
  {
    const Index known = m_bubble_numbers(&*v);
    return known == no_index ? no_index : m_bubbles_in_order[known];
  }

  const std::vector<Vertex_handle>& removed() const { return m_removed; }

private:
  /// one that goes unless a bubble lies there
  struct Old_vertex
  {
    std::pair<double, double> place;
    Index vertex;
    bool stays = false;

    bool operator<(const Old_vertex& v) const { return std::tie(place, vertex) < std::tie(v.place, v.vertex); }
  };

  Old_vertex old_vertex(Index v) const
  {
    const Point p = point_in_double<Cdt>(m_reading.vertex(v)->point());
    return {{p.x(), p.y()}, v};
  }

  /// all that may go, in the order of their places
  std::vector<Old_vertex> vertices_in_order() const
  {
    std::vector<Old_vertex> old;
    for (Index v : m_reading.free) {
      tick(old.size());
      old.push_back(old_vertex(v));
    }
    for (const auto& chain : m_reading.graph->chains())
      for (Index v : chain.splits)
        old.push_back(old_vertex(v));
    std::sort(old.begin(), old.end());
    return old;
  }

  void set(std::size_t i, Vertex_handle v)
  {
    m_of_bubble[i] = v;
    m_is_known[i] = 1;
    m_bubble_numbers.add(&*v);
    m_bubbles_in_order.push_back(static_cast<Index>(i));
  }

  /// Takes the vertex that is there already. What was free must be free, what split a constraint must be on it.
  void keep(std::size_t i, std::vector<Old_vertex>& old)
  {
    const Old_vertex here{{m_bubbles.x[i], m_bubbles.y[i]}, no_index};
    const auto found = std::lower_bound(old.begin(), old.end(), here);
    if (found == old.end() || found->place != here.place || found->stays)
      return;
    const Vertex_handle v = m_reading.vertex(found->vertex);
    if (m_bubbles.is_on_edge(i) != m_reading.graph->contains(found->vertex) ||
        (m_bubbles.is_in_face(i) && Plane::place(v->point()) != Place_2<Cdt>(m_bubbles.x[i], m_bubbles.y[i])))
      return; // in an exact kernel it is near by
    set(i, v);
    found->stays = true;
  }

  const Part_reading_2<Cdt>& m_reading;
  const Bubbles_2& m_bubbles;
  const Elevations<Cdt>& m_elevations;
  Face_exchange_2<Cdt>& m_exchange;
  std::vector<Vertex_handle> m_of_bubble;
  Address_numbers m_bubble_numbers; // of vertices in the order in which they became known
  std::vector<Index> m_bubbles_in_order;
  std::vector<char> m_is_known;
  std::vector<Vertex_handle> m_removed;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_VERTICES_2_H
