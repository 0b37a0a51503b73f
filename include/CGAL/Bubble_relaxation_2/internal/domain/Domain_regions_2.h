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
    : m_domain(domain), m_region(domain.triangulation().number_of_triangles(), no_index)
  {
    const auto is_inside = [&](Index t) { return domain.is_inside(t); };
    for (const std::vector<Index>& region : connected_parts(domain.triangulation(), is_inside, domain.is_wall())) {
      for (Index t : region)
        m_region[t] = m_number;
      ++m_number;
    }
  }

  Index number_of_regions() const { return m_number; }

  /// beside an edge, seen from its source; `no_index` outside of the domain
  Index left(Index edge) const { return region(m_domain.left(edge)); }
  Index right(Index edge) const { return region(m_domain.right(edge)); }

  /// where a point lies; `no_index` outside of the domain. \param hint where the search begins, and ended
  Index operator()(const Point& p, Index& hint) const
  {
    return region(m_domain.locate_inside(p, hint));
  }

private:
  Index region(Index t) const { return t == no_index ? no_index : m_region[t]; }

  const Domain_2& m_domain;
  std::vector<Index> m_region; // of the domain's triangles
  Index m_number = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_DOMAIN_REGIONS_2_H
