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
#include <vector>

/// How far it is from places to the nearest segment of a domain that has one of some markers, across islands too.
class Outline_distance
{
  using Place = boost::geometry::model::d2::point_xy<double>;
  using Segment = boost::geometry::model::segment<Place>;
  using Tree = boost::geometry::index::rtree<Segment, boost::geometry::index::rstar<16>>;

public:
  /// \param markers all segments count if there are none
  /// \throws std::runtime_error if no segment has one of them
  Outline_distance(const Domain& domain, const std::set<int>& markers)
  {
    check_markers(domain, "--distance-to", markers);
    std::vector<Segment> segments;
    for (const auto& e : domain.cdt.constrained_edges()) {
      const Point &p = e.first->vertex(CDT::ccw(e.second))->point(), &q = e.first->vertex(CDT::cw(e.second))->point();
      const int marker = segment_marker(domain, p, q);
      if (markers.empty() || markers.count(marker) > 0)
        segments.emplace_back(Place(p.x(), p.y()), Place(q.x(), q.y()));
    }
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
