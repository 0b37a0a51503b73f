// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_SOURCE_SEARCH_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_SOURCE_SEARCH_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Box_tree_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Barycentric_weights.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Face_set_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Overlap_polygon_2.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace CGAL::Bubble_relaxation_2::internal {

/// A place in a triangle.
struct Source_location_2
{
  Index triangle = no_index;
  Weights_3 weights{};
};

/// Finds the source triangles that a place, or a triangle of the target, lies in. Queries change nothing.
class Source_search_2
{
public:
  explicit Source_search_2(const Face_set_2& source) : m_source(source), m_tree(source.boxes()) {}

  const Face_set_2& source() const { return m_source; }

  /// Calls `visit(s, polygon)` for the triangles that overlap a triangle of the target, in increasing order, and what
  /// they have in common with it.
  template <class Visitor>
  void for_each_overlap(const Face_set_2& target, Index t, const Visitor& visit) const
  {
    boost::container::small_vector<Index, 64> found;
    const Bbox_2 box = target.box(t);
    m_tree.for_each_near(box, [&](Index s) {
      if (do_overlap(m_source.box(s), box) && have_common_interior(m_source, s, target, t))
        found.push_back(s);
    });
    std::sort(found.begin(), found.end());
    for (Index s : found) {
      const Overlap_polygon_2 polygon(m_source, s, target, t);
      if (polygon.area() > 0)
        visit(s, polygon);
    }
  }

  /// The triangle that contains a point, of several the first one; else the nearest place in any triangle.
  Source_location_2 locate(const Point& q) const
  {
    Index found = no_index;
    m_tree.for_each_near(q.bbox(), [&](Index s) {
      if ((found == no_index || s < found) && contains(s, q))
        found = s;
    });
    if (found == no_index)
      return nearest(q);
    return Source_location_2{found, barycentric_weights(m_source, found, q)};
  }

private:
  bool contains(Index s, const Point& q) const
  {
    for (int i = 0; i < 3; ++i)
      if (CGAL::orientation(m_source.point(s, i), m_source.point(s, ccw(i)), q) == RIGHT_TURN)
        return false;
    return do_overlap(m_source.box(s), q.bbox()); // of a triangle without area all turns may be collinear
  }

  Source_location_2 nearest(const Point& q) const
  {
    Source_location_2 best;
    double bound = std::numeric_limits<double>::infinity();
    m_tree.for_each_nearer(q, bound, [&](Index s) {
      const Nearest_on_sides n(m_source, s, q);
      if (n.squared_distance > bound || (n.squared_distance == bound && s > best.triangle))
        return bound;
      best = Source_location_2{s, n.weights};
      return n.squared_distance;
    });
    return best;
  }

  const Face_set_2& m_source;
  Box_tree_2 m_tree;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_SOURCE_SEARCH_2_H
