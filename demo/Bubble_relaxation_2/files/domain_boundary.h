// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_DOMAIN_BOUNDARY_H
#define BUBBLE_RELAXATION_2_DEMO_DOMAIN_BOUNDARY_H

#include "domain.h"

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>

#include <utility>
#include <vector>

/// The ends of the segments between a domain, on their left, and what is outside, whether its faces are marked or told by
/// nesting.
/// \throws std::invalid_argument if there is no domain
inline std::vector<std::pair<Point, Point>> boundary_segments(const Domain& domain)
{
  using Marks = CGAL::Bubble_relaxation_2::internal::Domain_marks_2<CDT>;
  const Marks is_in_domain(domain.cdt, CGAL::parameters::default_values());
  std::vector<std::pair<Point, Point>> segments;
  for (const CDT::Edge& e : domain.cdt.constrained_edges())
    if (is_in_domain(e.first) != is_in_domain(e.first->neighbor(e.second))) {
      segments.emplace_back(e.first->vertex(CDT::ccw(e.second))->point(), e.first->vertex(CDT::cw(e.second))->point());
      if (!is_in_domain(e.first))
        std::swap(segments.back().first, segments.back().second);
    }
  return segments;
}

#endif // BUBBLE_RELAXATION_2_DEMO_DOMAIN_BOUNDARY_H
