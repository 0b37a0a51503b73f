// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_BOUNDARY_SEGMENT_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_BOUNDARY_SEGMENT_2_H

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Integration_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/integration_cells.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// A cell of integration on the boundary: the part from `begin` to `end`, in [0, 1], of an edge.
struct Boundary_segment_2
{
  std::size_t edge;
  double begin, end;
};

/// the point that divides an edge at `s` in [0, 1]
inline Point point_on(const Boundary_edge_2& e, double s)
{
  return Point(e.a.x() + s * (e.b.x() - e.a.x()), e.a.y() + s * (e.b.y() - e.a.y()));
}

/// The edges of the boundary, halved until the parts are small against the sizes of the nodes.
/// \throws std::length_error if there are more than `most` of them and the edges
template <class Size_at>
std::vector<Boundary_segment_2> halved_boundary(const Integration_domain_2& domain, const Size_at& size_at,
                                                std::size_t most)
{
  std::vector<Boundary_segment_2> segments, stack;
  for (std::size_t e = 0; e < domain.boundary.size(); ++e) {
    const Boundary_edge_2& edge = domain.boundary[e];
    stack.push_back(Boundary_segment_2{e, 0, 1});
    while (!stack.empty()) {
      if (segments.size() >= most + domain.boundary.size())
        throw_too_many_cells(most);
      const Boundary_segment_2 s = stack.back();
      stack.pop_back();
      const double m = (s.begin + s.end) / 2;
      if ((s.end - s.begin) * edge.length() > largest_cell_side * size_at(point_on(edge, m))) {
        stack.push_back(Boundary_segment_2{e, m, s.end});
        stack.push_back(Boundary_segment_2{e, s.begin, m});
      } else {
        segments.push_back(s);
      }
    }
  }
  return segments;
}

/// The edges of the boundary, cut where lines of the grid cross them.
inline std::vector<Boundary_segment_2> cut_boundary(const Integration_domain_2& domain, const Grid_cells_2& grid)
{
  constexpr double shortest = 1e-10; // of an edge: below are roundings of one crossing
  std::vector<Boundary_segment_2> segments;
  std::vector<double> places;
  for (std::size_t e = 0; e < domain.boundary.size(); ++e) {
    places.clear();
    grid.crossings(domain.boundary[e].a, domain.boundary[e].b, places);
    double last = 0;
    for (double s : places)
      if (s - last > shortest && 1 - s > shortest) {
        segments.push_back(Boundary_segment_2{e, last, s});
        last = s;
      }
    segments.push_back(Boundary_segment_2{e, last, 1});
  }
  return segments;
}

/// calls `visit(s, x, y, weight)` for the points of Gauss's rule on a segment, where s in [0, 1] is the place on
/// the edge
template <class Visitor>
void for_each_point(const Boundary_edge_2& edge, const Boundary_segment_2& segment, const Gauss_rule& rule,
                    const Visitor& visit)
{
  const double part = segment.end - segment.begin, length = part * edge.length();
  for (std::size_t k = 0; k < rule.size(); ++k) {
    const double s = segment.begin + part * rule.points[k];
    const Point p = point_on(edge, s);
    visit(s, p.x(), p.y(), length * rule.weights[k]);
  }
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_BOUNDARY_SEGMENT_2_H
