// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_RHOMBIC_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_RHOMBIC_H

#include <CGAL/Bubble_relaxation_2/internal/core/Bubbles_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Team.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Hole_choice_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The initial bubbles of the faces after section 2.1.2 of the paper: a rhombus with angles of 60 and
/// 120 degrees around the domain is cut in four until a cell is as small as d asks, and gets a bubble
/// in its centre. Where d is constant this is the hexagonal lattice.
class Rhombic_placement
{
public:
  Rhombic_placement(const Domain_2& domain, const Sizes_2& sizing, Bubbles_2& bubbles, Team& team)
    : m_domain(domain), m_sizing(sizing), m_bubbles(bubbles), m_team(team)
  {}

  void operator()()
  {
    // the rhombus spanned by (1, 0) and (1/2, sqrt(3)/2) whose side is a power of two times d in some
    // place of the domain, so that a constant d is met exactly
    const Bbox_2& box = m_domain.bbox();
    const double width = box.x_span(), height = box.y_span();
    const double needed = (std::max)(width + height / std::sqrt(3.), height * 2 / std::sqrt(3.));
    double side = *std::min_element(m_bubbles.d.begin(), m_bubbles.d.end());
    while (side < needed)
      side *= 2;
    m_x0 = box.xmin() - height / std::sqrt(3.);
    m_y0 = box.ymin();

    subdivide(Cell{0, 0, side, 0, 1, 0, Share_of_disc::SOME}, indices_below(m_bubbles.size()));
    fill_holes_beside(m_centers, least_distance, m_team, Threads(), m_bubbles);
  }

private:
  /// bubbles of the faces start no nearer to others than this, in units of the mean size
  static constexpr double least_distance = 0.6;

  Point point(double u, double v) const
  {
    return Point(m_x0 + u + 0.5 * v, m_y0 + 0.5 * std::sqrt(3.) * v);
  }

  /// a rhombus
  struct Cell
  {
    double u, v, side;
    double rank, share; ///< its centre comes after those of cells of a smaller rank; all in it are below their sum
    Index hint;         ///< a triangle near by
    Share_of_disc ours; ///< no more of it than this

    Cell quarter(int k, Index triangle) const
    {
      return Cell{u + 0.5 * side * (k & 1), v + 0.5 * side * (k >> 1), 0.5 * side,
                  rank + 0.25 * share * k, 0.25 * share, triangle == no_index ? hint : triangle, ours};
    }
  };

  /// Whether the centres of a cell's quarters differ from its own in both coordinates. Else they round to the same
  /// places: where d is smaller than the rounding in x, but not in y, cells would be cut without end.
  static bool has_quarters(const Point& center, double side)
  {
    const double step = 0.125 * side; // the least of what they differ by in x, the height of a quarter in y
    return center.x() + step != center.x() && center.y() + step != center.y();
  }

  /// `boundary`: the bubbles of vertices and edges in the cell
  void subdivide(Cell cell, const std::vector<Index>& boundary)
  {
    constexpr double half_diagonal = 0.8661; // of the side
    tick(++m_number_of_cells);
    const double side = cell.side;
    const Point center = point(cell.u + 0.5 * side, cell.v + 0.5 * side);
    if (cell.ours != Share_of_disc::ALL)
      cell.ours = m_team.share_of(center, half_diagonal * side);
    if (cell.ours == Share_of_disc::NONE)
      return;
    const Index triangle = m_domain.locate(center, cell.hint);
    const bool is_inside = triangle != no_index && m_domain.is_inside(triangle);
    // the domain misses a cell with neither boundary nor centre in it, up to bits smaller than a cell
    if (!is_inside && boundary.empty())
      return;
    const double d = is_inside ? m_sizing(center) : 0;
    double smallest = is_inside ? d : m_bubbles.d[boundary.front()];
    if (side > 2 * smallest || !is_inside)
      for (Index i : boundary)
        smallest = (std::min)(smallest, m_bubbles.d[i]);
    if (side > std::sqrt(2.) * smallest && has_quarters(center, side)) {
      std::vector<Index> part[4];
      for (Index i : boundary) {
        const double bv = (m_bubbles.y[i] - m_y0) / (0.5 * std::sqrt(3.));
        const double bu = m_bubbles.x[i] - m_x0 - 0.5 * bv;
        part[(bu >= cell.u + 0.5 * side) + 2 * (bv >= cell.v + 0.5 * side)].push_back(i);
      }
      for (int k = 0; k < 4; ++k)
        subdivide(cell.quarter(k, triangle), part[k]);
      return;
    }
    if (is_inside && m_team.owns_place(center))
      m_centers.push_back(Hole_2{cell.rank, center.x(), center.y(), d, triangle});
  }

  const Domain_2& m_domain;
  const Sizes_2& m_sizing;
  Bubbles_2& m_bubbles;
  Team& m_team;
  std::vector<Hole_2> m_centers; // of cells
  double m_x0 = 0, m_y0 = 0;
  std::size_t m_number_of_cells = 0; // that were looked at
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_PLACEMENT_PLACE_RHOMBIC_H
