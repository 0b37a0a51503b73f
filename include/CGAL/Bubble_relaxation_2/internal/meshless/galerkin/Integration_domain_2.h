// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_DOMAIN_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_DOMAIN_2_H

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/centroid.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// A straight piece of the boundary, with the domain on its left.
struct Boundary_edge_2
{
  Index source, target; ///< indices of vertices
  Point a, b;           ///< their places
  Index part;           ///< of the domain

  double length() const { return std::hypot(b.x() - a.x(), b.y() - a.y()); }
  Direction outer_normal() const { return {(b.y() - a.y()) / length(), -(b.x() - a.x()) / length()}; }
};

/// What integrals are over: the triangles of a triangulation that lie in the domain, and the edges that bound
/// it, those of holes included. An edge with the domain on both sides bounds nothing. All in an order that does
/// not depend on how the triangulation came about.
struct Integration_domain_2
{
  std::vector<std::array<Point, 3>> triangles;
  std::vector<Boundary_edge_2> boundary;
  std::vector<Point> parts; ///< a point in each part of the domain that hangs together across sides
  Bbox_2 bbox;
  double area = 0;

  explicit Integration_domain_2(const Triangulation_copy_2& marks) { read(Sorted_triangulation_2(marks).tr); }

private:
  void read(const Flat_triangulation_2& tr)
  {
    const std::vector<Index> part = find_parts(tr);
    for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
      if (!tr.inside[t])
        continue;
      const Index f = static_cast<Index>(t);
      add_triangle({tr.point(f, 0), tr.point(f, 1), tr.point(f, 2)});
      for (int i = 0; i < 3; ++i) {
        const Index n = tr.neighbors[t][i];
        if (n != no_index && tr.inside[n])
          continue;
        const Boundary_edge_2 edge{tr.vertices[t][ccw(i)], tr.vertices[t][cw(i)], tr.point(f, ccw(i)),
                                   tr.point(f, cw(i)), part[t]};
        if (edge.length() > 0) // the ends of an exact one may be rounded to one place
          boundary.push_back(edge);
      }
    }
  }

  /// the part of each triangle of the domain
  std::vector<Index> find_parts(const Flat_triangulation_2& tr)
  {
    std::vector<Index> part(tr.number_of_triangles(), no_index);
    const auto is_inside = [&tr](Index t) { return tr.inside[t] != 0; };
    for (const std::vector<Index>& those : connected_parts(tr, is_inside, [](Index, int) { return false; })) {
      for (Index t : those)
        part[t] = static_cast<Index>(parts.size());
      const Index f = those.front();
      parts.push_back(CGAL::centroid(tr.point(f, 0), tr.point(f, 1), tr.point(f, 2)));
    }
    return part;
  }

  void add_triangle(const std::array<Point, 3>& t)
  {
    const double twice = (t[1].x() - t[0].x()) * (t[2].y() - t[0].y()) -
                         (t[2].x() - t[0].x()) * (t[1].y() - t[0].y());
    if (!(twice > 0)) // flat when its corners are rounded to double: nothing to integrate
      return;
    triangles.push_back(t);
    area += twice / 2;
    for (const Point& p : t)
      bbox += p.bbox();
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_INTEGRATION_DOMAIN_2_H
