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

#include <map>
#include <set>
#include <utility>
#include <vector>

/// the pinned vertices, and those at which markers of segments change or that have a marker of their own
inline std::set<CDT::Vertex_handle> vertices_that_stay(const Domain& domain)
{
  std::set<CDT::Vertex_handle> result = domain.pinned;
  if (domain.cdt.dimension() < 2 || (domain.point_markers.empty() && domain.segment_markers.empty()))
    return result;
  std::map<CDT::Vertex_handle, std::set<int>> segments, neighbors;
  for (const CDT::Edge& e : domain.cdt.constrained_edges()) {
    const CDT::Vertex_handle a = e.first->vertex(CDT::cw(e.second)), b = e.first->vertex(CDT::ccw(e.second));
    const int marker = segment_marker(domain, a->point(), b->point());
    for (CDT::Vertex_handle v : {a, b}) {
      segments[v].insert(marker);
      neighbors[v].insert(point_marker(domain, (v == a ? b : a)->point()));
    }
  }
  for (const auto& s : segments) {
    const int marker = point_marker(domain, s.first->point());
    if (s.second.size() > 1 ||
        (marker != 0 && s.second.count(marker) == 0 && neighbors[s.first].count(marker) == 0))
      result.insert(s.first);
  }
  return result;
}

/// Replaces the outline by one within a tolerance; its segments have the markers of those that they stand for.
/// \param parameters sizes, tolerance and rules
template <class Parameters>
CGAL::Outline_simplification_report_2 simplify_domain(Domain& domain, const Parameters& parameters)
{
  const std::set<CDT::Vertex_handle> stay = vertices_that_stay(domain);
  const auto report = CGAL::simplify_outline_2(
    domain.cdt,
    parameters.vertex_is_constrained_map(CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>(stay)));
  const auto point = [](const auto& place) { return Point(place[0], place[1]); };
  std::map<std::pair<Point, Point>, int> markers;
  for (const auto& piece : report.pieces) {
    const int marker = segment_marker(domain, point(piece.old_source), point(piece.old_target));
    if (marker != 0 && !piece.is_new)
      markers[sorted(point(piece.source), point(piece.target))] = marker;
  }
  domain.segment_markers = std::move(markers);
  return report;
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
