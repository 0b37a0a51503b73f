// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Nodes for a meshless method, with the neighbours of each node. No mesh is kept.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_place_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;

int main()
{
  // the trunk of Fig. 9
  const std::vector<Point> trunk{{-0.3, 0}, {0.3, 0}, {0.25, 0.6}, {0.8, 1.1}, {0.7, 1.2}, {0.2, 0.85},
                                 {0.15, 1.5}, {-0.1, 1.5}, {-0.15, 0.9}, {-0.7, 1.3}, {-0.8, 1.2}, {-0.25, 0.65}};
  CDT cdt;
  cdt.insert_constraint(trunk.begin(), trunk.end(), true);
  const auto nodes = CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(0.05));
  std::cout << nodes.size() << " nodes, " << nodes.neighbors.size() / nodes.size()
            << " neighbours each within " << nodes.neighbor_radius << " d\n";

  // the neighbours of one node in the middle
  const auto is_nearer = [](const Point& p, const Point& q) {
    return CGAL::has_smaller_distance_to_point(Point(0, 0.6), p, q);
  };
  const auto middle = static_cast<std::size_t>(
    std::min_element(nodes.points.begin(), nodes.points.end(), is_nearer) - nodes.points.begin());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = nodes.neighbor_offsets[middle]; k < nodes.neighbor_offsets[middle + 1]; ++k) {
    const auto j = static_cast<std::size_t>(nodes.neighbors[k]);
    const double distance = std::sqrt(CGAL::squared_distance(nodes.points[j], nodes.points[middle]));
    std::cout << "  node " << middle << " has the neighbour " << j << " at "
              << distance / nodes.sizes[middle] << " d\n";
    pairs.emplace_back(middle, j);
  }

  Svg_picture picture;
  picture.add_bubbles(nodes.points, nodes.sizes, pairs, "bubbles, and the neighbours of one");
  picture.write("nodes.svg");
}
