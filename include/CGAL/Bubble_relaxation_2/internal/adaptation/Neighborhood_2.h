// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_NEIGHBORHOOD_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_NEIGHBORHOOD_2_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_growth_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Squares of a grid that some boxes meet.
class Grid_squares_2
{
public:
  /// \pre no side of a box is longer than `side`, the length of the squares
  Grid_squares_2(const std::vector<Bbox_2>& boxes, double side) : m_side(side)
  {
    for (const Bbox_2& b : boxes)
      for (double y : {number(b.ymin()), number(b.ymax())})
        for (double x : {number(b.xmin()), number(b.xmax())})
          m_squares.push_back(Square{y, x});
    sort_each_once(m_squares);
  }

  /// these squares, and all that touch them
  Grid_squares_2 with_neighbors() const
  {
    Grid_squares_2 result(*this);
    for (const Square& s : m_squares)
      for (double y : {s.first - 1, s.first, s.first + 1})
        for (double x : {s.second - 1, s.second, s.second + 1})
          result.m_squares.push_back(Square{y, x});
    sort_each_once(result.m_squares);
    return result;
  }

  /// whether a box meets one of the squares
  bool meet(const Bbox_2& b) const
  {
    if (m_squares.empty())
      return false;
    const double top = (std::min)(number(b.ymax()), m_squares.back().first);
    for (double y = (std::max)(number(b.ymin()), m_squares.front().first); y <= top; ++y) {
      const auto found = std::lower_bound(m_squares.begin(), m_squares.end(), Square{y, number(b.xmin())});
      if (found != m_squares.end() && found->first == y && found->second <= number(b.xmax()))
        return true;
    }
    return false;
  }

  /// whether the squares cover a box
  bool cover(const Bbox_2& b) const
  {
    const double left = number(b.xmin()), right = number(b.xmax());
    for (double y = number(b.ymin()); y <= number(b.ymax()); ++y) {
      const auto found = std::lower_bound(m_squares.begin(), m_squares.end(), Square{y, left});
      if (static_cast<double>(m_squares.end() - found) <= right - left ||
          found[static_cast<std::ptrdiff_t>(right - left)] != Square{y, right})
        return false;
    }
    return true;
  }

private:
  using Square = std::pair<double, double>; // row and column: whole numbers, which no integer type need hold

  /// of the row or column of a coordinate
  double number(double coordinate) const { return std::floor(coordinate / m_side); }

  double m_side;
  std::vector<Square> m_squares; // sorted
};

/// Faces of a triangulation, and all that squares around them meet, in the domain and out of it. They are found from each
/// other, in no time that grows with the triangulation.
template <class Cdt, class Is_inside>
Part_growth_2<Cdt, Is_inside> neighborhood(const Cdt& cdt, const Is_inside& is_in_domain,
                                           const std::vector<typename Cdt::Face_handle>& faces,
                                           const Grid_squares_2& squares)
{
  Part_growth_2<Cdt, Is_inside> near(cdt, is_in_domain, {});
  for (typename Cdt::Face_handle f : faces)
    near.add(f);
  for (std::size_t k = 0; k < near.faces().size(); ++k) {
    tick(k);
    for (int i = 0; i < 3; ++i) {
      const typename Cdt::Face_handle n = near.faces()[k]->neighbor(i);
      if (!near.contains(n) && !cdt.is_infinite(n) && squares.meet(box_of<Cdt>(n)))
        near.add(n);
    }
  }
  return near;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_NEIGHBORHOOD_2_H
