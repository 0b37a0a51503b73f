// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Nodes for a meshless method, with the neighbours of each node. No mesh is kept.

#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/npbs_place_nodes.h>

#include <iostream>
#include <utility>
#include <vector>

int main()
{
  const paper::Domain domain = paper::trunk(1);
  const paper::CDT cdt = paper::triangulate(domain);
  const auto nodes = CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(domain.d));

  std::cout << nodes.size() << " nodes, " << nodes.neighbors.size() / nodes.size()
            << " neighbours each within " << nodes.neighbor_radius << " d\n";

  // the neighbours of one node in the middle
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::size_t middle = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (paper::distance(nodes.points[i], 0, 0.6) < paper::distance(nodes.points[middle], 0, 0.6))
      middle = i;
  for (std::size_t k = nodes.neighbor_offsets[middle]; k < nodes.neighbor_offsets[middle + 1]; ++k) {
    const auto j = static_cast<std::size_t>(nodes.neighbors[k]);
    std::cout << "  node " << middle << " has the neighbour " << j << " at "
              << paper::distance(nodes.points[j], nodes.points[middle].x(), nodes.points[middle].y()) /
                   nodes.sizes[middle]
              << " d\n";
    pairs.emplace_back(middle, j);
  }

  Svg_picture picture;
  picture.add_bubbles(nodes.points, nodes.sizes, pairs, "bubbles, and the neighbours of one");
  picture.write("nodes.svg");
}
