// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_TRIANGLE_CELLS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_TRIANGLE_CELLS_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Background_cell_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Integration_domain_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The longest side that a cell may have, in units of the size of the nodes around. The triangles of a mesh of
/// the nodes have shorter ones.
constexpr double largest_cell_side = 1.75;

/// a point in the middle that does not depend on the order of both
inline Point middle(const Point& a, const Point& b) { return Point((a.x() + b.x()) / 2, (a.y() + b.y()) / 2); }

/// The most cells that a number of nodes may have, besides given triangles, a thousand for each and a million more:
/// so many are no mesh, but sizes in other units than the coordinates.
inline std::size_t most_cells(std::size_t number_of_nodes) { return 1000 * (number_of_nodes + 1000); }

[[noreturn]] inline void throw_too_many_cells(std::size_t most)
{
  throw std::length_error("Bubble_relaxation_2: parameter nodes: their sizes ask for more than " + std::to_string(most) +
                          " cells of integration: some are too small for the domain, or in another unit");
}

/// Cuts a triangle in two at the middle of its longest side, and the parts again, until they are small against
/// the sizes of the nodes, `size_at(point)`. Longest sides keep the angles of the parts bounded; that the parts
/// do not fit together at their sides does not matter to integrals.
template <class Size_at>
void add_triangle_cells(std::array<Point, 3> t, const Size_at& size_at, std::size_t most,
                        std::vector<Background_cell_2>& cells)
{
  std::vector<std::array<Point, 3>> stack(1, t);
  while (!stack.empty()) {
    if (cells.size() >= most)
      throw_too_many_cells(most);
    t = stack.back();
    stack.pop_back();
    int longest = 0; // opposite to this vertex
    double square[3];
    for (int i = 0; i < 3; ++i) {
      square[i] = CGAL::squared_distance(t[ccw(i)], t[cw(i)]);
      longest = square[i] > square[longest] ? i : longest;
    }
    const Point m = middle(t[ccw(longest)], t[cw(longest)]);
    if (std::sqrt(square[longest]) > largest_cell_side * size_at(m)) {
      stack.push_back({t[longest], m, t[cw(longest)]});
      stack.push_back({t[longest], t[ccw(longest)], m});
    } else {
      cells.push_back(Background_cell_2{t[0].x(), t[0].y(), t[1].x() - t[0].x(), t[1].y() - t[0].y(),
                                        t[2].x() - t[0].x(), t[2].y() - t[0].y(), true});
    }
  }
}

/// The triangles of the domain as cells: those of a mesh as they are, larger ones in parts.
/// \throws std::length_error if there are more than `most` of them and the triangles
template <class Size_at>
std::vector<Background_cell_2> triangle_cells(const Integration_domain_2& domain, const Size_at& size_at,
                                              std::size_t most)
{
  std::vector<Background_cell_2> cells;
  for (const auto& t : domain.triangles)
    add_triangle_cells(t, size_at, most + domain.triangles.size(), cells);
  return cells;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_TRIANGLE_CELLS_H
