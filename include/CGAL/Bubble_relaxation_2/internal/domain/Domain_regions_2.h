// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_REGIONS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_REGIONS_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The regions into which its edges part a domain, numbered: on all ranks alike that have the same domain.
class Domain_regions_2
{
public:
  explicit Domain_regions_2(const Domain_2& domain)
    : m_domain(domain), m_region(domain.triangulation().number_of_triangles(), no_index),
      m_left(domain.edges().size(), no_index), m_right(m_left)
  {
    for (std::size_t t = 0; t < m_region.size(); ++t)
      if (domain.is_inside(static_cast<Index>(t)) && m_region[t] == no_index)
        flood(static_cast<Index>(t));
    const Flat_triangulation_2& tr = domain.triangulation();
    for (std::size_t t = 0; t < m_region.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Index e = domain.edge(static_cast<Index>(t), i);
        if (e != no_index)
          (tr.vertices[t][ccw(i)] == domain.edges()[e].source ? m_left : m_right)[e] = m_region[t];
      }
  }

  Index number_of_regions() const { return m_number; }

  /// beside an edge, seen from its source; `no_index` outside of the domain
  Index left(Index edge) const { return m_left[edge]; }
  Index right(Index edge) const { return m_right[edge]; }

  /// where a point lies; `no_index` outside of the domain. \param hint where the search begins, and ended
  Index operator()(const Point& p, Index& hint) const
  {
    const Index t = m_domain.locate_inside(p, hint);
    return t == no_index ? no_index : m_region[t];
  }

private:
  void flood(Index first)
  {
    m_region[first] = m_number;
    std::vector<Index> stack{first};
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Index n = m_domain.triangulation().neighbors[t][i];
        if (n == no_index || m_region[n] != no_index || m_domain.edge(t, i) != no_index)
          continue;
        m_region[n] = m_number;
        stack.push_back(n);
      }
    }
    ++m_number;
  }

  const Domain_2& m_domain;
  std::vector<Index> m_region; // of the domain's triangles
  std::vector<Index> m_left, m_right;
  Index m_number = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_REGIONS_2_H
