// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_OUTLINE_DISTANCE_H
#define BUBBLE_RELAXATION_2_DEMO_OUTLINE_DISTANCE_H

#include "files/domain.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// How far it is from places to the nearest segment, or pinned point, of a domain that has one of some markers, across
/// islands too.
class Outline_distance
{
  using Place = boost::geometry::model::d2::point_xy<double>;
  using Segment = boost::geometry::model::segment<Place>;
  using Tree = boost::geometry::index::rtree<Segment, boost::geometry::index::rstar<16>>;

public:
  /// \param markers all segments count if there are none, and no points
  /// \throws std::runtime_error if there is no segment and no pinned point with one of them
  Outline_distance(const Domain& domain, const std::set<int>& markers)
  {
    std::set<int> missing = markers;
    std::vector<Segment> segments;
    const auto add = [&](const Point& p, const Point& q, int marker) {
      if (!markers.empty() && markers.count(marker) == 0)
        return;
      segments.emplace_back(Place(p.x(), p.y()), Place(q.x(), q.y()));
      missing.erase(marker);
    };
    for (const auto& e : domain.cdt.constrained_edges()) {
      const Point &p = e.first->vertex(CDT::ccw(e.second))->point(), &q = e.first->vertex(CDT::cw(e.second))->point();
      add(p, q, segment_marker(domain, p, q));
    }
    if (!markers.empty()) // segments without length, from which the distance is that from a point
      for (CDT::Vertex_handle v : domain.pinned)
        add(v->point(), v->point(), point_marker(domain, v->point()));
    if (!missing.empty())
      throw std::runtime_error("--distance-to: no segment and no pinned point has the marker " +
                               std::to_string(*missing.begin()));
    m_tree = std::make_shared<const Tree>(segments.begin(), segments.end());
  }

  double operator()(double x, double y) const
  {
    const Place place(x, y);
    return boost::geometry::distance(place, *m_tree->qbegin(boost::geometry::index::nearest(place, 1)));
  }

private:
  std::shared_ptr<const Tree> m_tree;
};

#endif // BUBBLE_RELAXATION_2_DEMO_OUTLINE_DISTANCE_H
