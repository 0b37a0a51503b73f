// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H
#define BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H

#include "domain.h"
#include "file_names.h"

#include <CGAL/property_map.h>
#include <CGAL/simplify_outline_2.h>

#include <ostream>
#include <set>
#include <string>

/// Replaces the outline by one within a tolerance; its segments have the markers of those that they stand for.
/// \param parameters sizes, tolerance and rules
template <class Parameters>
CGAL::Outline_simplification_report_2 simplify_domain(Domain& domain, const Parameters& parameters)
{
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  return CGAL::simplify_outline_2(
    domain.cdt,
    parameters.vertex_is_constrained_map(Pinned(domain.pinned)).edge_marker_map(Segment_marker_map{&domain}));
}

/// Writes where the rules took islands and narrows away: a line each, with its area.
/// \throws std::runtime_error with the name and the system's reason
inline void write_simplification(const std::string& name, const CGAL::Outline_simplification_report_2& report)
{
  write_file(name, [&report](std::ostream& out) {
    out.precision(17);
    out << "# what x y area\n";
    for (const auto& island : report.dropped_islands)
      out << "island " << island.place[0] << ' ' << island.place[1] << ' ' << island.area << '\n';
    for (const auto& gap : report.filled_gaps)
      out << "gap " << gap.place[0] << ' ' << gap.place[1] << ' ' << gap.area << '\n';
  });
}

#endif // BUBBLE_RELAXATION_2_DEMO_SIMPLIFY_DOMAIN_H
