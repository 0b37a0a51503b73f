// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Figure 18 of the paper: influence domains, for two of its examples. Each node has a radius of two of its own
// distances d. For a few points the nodes are shown that have a say there. It fails if the paper's way to find them
// finds others.

#include "svg_picture.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/npbs_place_nodes.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Points = std::vector<Point>;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
using Influence_domain = CGAL::Influence_domain_2<K>;

/// returns whether both ways to search agree
bool show(const std::string& name, const std::vector<Points>& outlines, const std::function<double(const Point&)>& d,
          const Points& places, Svg_picture& picture)
{
  CDT cdt;
  for (const Points& outline : outlines)
    cdt.insert_constraint(outline.begin(), outline.end(), true);
  const auto nodes = CGAL::npbs_place_nodes(cdt, CGAL::parameters::sizing_function(d));
  const auto two_sizes = CGAL::parameters::support_factor(2.);
  const Influence_domain influence(nodes, two_sizes);
  // the paper's way, from the neighbour sets
  const Influence_domain by_expansion(nodes, two_sizes.influence_search(CGAL::Influence_search::EXPANSION));

  picture.add_points(cdt, nodes.points, name + ": influence domains of radius 2 d");
  std::cout << name << ": " << nodes.size() << " nodes\n";
  Influence_domain::Query query(influence), expansion(by_expansion);
  std::vector<std::int32_t> found, expanded;
  int number = 0;
  bool is_same = true;
  for (const Point& p : places) {
    query(p, 1, found);
    const std::size_t fallbacks = expansion.number_of_fallbacks();
    expansion(p, 1, expanded);
    is_same = is_same && expanded == found;
    std::cout << "  (" << p << ") lies in the influence domains of " << found.size() << " nodes; by expansion: "
              << (expanded == found ? "the same" : "others")
              << (expansion.number_of_fallbacks() > fallbacks ? ", after all from the lists\n" : "\n");
    Points points;
    for (std::int32_t i : found)
      points.push_back(influence.point(i));
    picture.add_star(p, points, nodes.size(), number++);
  }
  return is_same;
}

int main()
{
  const Points square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  Points circle;
  for (int i = 0; i < 50; ++i)
    circle.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / 50), 0.5 * std::sin(2 * CGAL_PI * i / 50)));
  const Points bent{{0, 0}, {2, 0}, {2, 1}, {1.2, 1}, {1, 1.6}, {0.4, 1.6}, {0, 1}};
  const Points window{{0.5, 0.4}, {0.9, 0.4}, {0.9, 0.8}, {0.5, 0.8}};

  Svg_picture picture;
  const bool is_same_in_square = show(
    "square with hole", {square, circle}, [](const Point& p) { return std::hypot(p.x(), p.y()) / 8; },
    {{0.56, 0.1}, {-0.75, 0.7}, {0, -0.8}, {-0.6, -0.2}}, picture);
  const bool is_same_in_non_convex = show(
    "non-convex with hole", {bent, window}, [](const Point&) { return 0.05; },
    {{0.92, 0.6}, {0.3, 0.3}, {1.13, 1.05}, {1.6, 0.5}, {0.7, 1.3}}, picture);
  picture.write("influence_domains.svg");
  return is_same_in_square && is_same_in_non_convex ? EXIT_SUCCESS : EXIT_FAILURE;
}
