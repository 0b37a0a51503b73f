// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_GROWTH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_GROWTH_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Adds faces to a part of a triangulation.
template <class Cdt, class Is_inside>
class Part_growth_2
{
public:
  using Face_handle = typename Cdt::Face_handle;
  using Vertex_handle = typename Cdt::Vertex_handle;

  /// \pre no face comes twice
  Part_growth_2(const Cdt& cdt, const Is_inside& is_in_domain, std::vector<Face_handle> part)
    : m_cdt(cdt), m_is_in_domain(is_in_domain), m_part(std::move(part)), m_numbers(sizeof(typename Cdt::Face))
  {
    std::size_t number = 0;
    for (Face_handle f : m_part) {
      tick(number++);
      m_numbers.add(&*f);
    }
  }

  const std::vector<Face_handle>& faces() const { return m_part; }
  bool contains(Face_handle f) const { return m_numbers(&*f) != no_index; }

  /// adds so many times all faces around the vertices of the part
  void add_rings(std::size_t number)
  {
    for (std::size_t ring = 0, first = 0; ring < number; ++ring) {
      const std::size_t last = m_part.size();
      for (; first < last; ++first) {
        tick(first);
        for (int i = 0; i < 3; ++i)
          add_star(m_part[first]->vertex(i));
      }
    }
  }

  void add_star(Vertex_handle v)
  {
    auto f = m_cdt.incident_faces(v), start = f;
    do
      if (!m_cdt.is_infinite(f) && m_is_in_domain(f))
        add(f);
    while (++f != start);
  }

  void add(Face_handle f)
  {
    if (contains(f))
      return;
    m_numbers.add(&*f);
    m_part.push_back(f);
  }

private:
  const Cdt& m_cdt;
  const Is_inside& m_is_in_domain;
  std::vector<Face_handle> m_part;
  Address_numbers m_numbers;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_PART_GROWTH_2_H
