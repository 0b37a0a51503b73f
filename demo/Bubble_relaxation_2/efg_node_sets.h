// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_NODE_SETS_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_NODE_SETS_H

#include "paper_domains.h"

#include <CGAL/npbs_place_nodes.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

/// The node sets of section 3.1 of the paper: 144 nodes of the unit square, moved by bubble simulation.
namespace efg {

using Point = paper::Point;
using CDT = paper::CDT;
using Nodes = CGAL::Node_set_2<Point>;

/// So many steps with sizes of so many times the natural distance.
struct Stage
{
  double factor;
  std::size_t steps;
};

/// what bubbles of a fixed number have to be larger than their natural distance: with less they are under tension
/// somewhere and tear, with much more they are pressed against the boundary
inline std::vector<Stage> constant_size(std::size_t steps) { return {{1.12, steps}}; }

/// first so large that all holes close, then nearly the natural size
inline std::vector<Stage> large_then_less(std::size_t steps)
{
  constexpr std::size_t large = 250;
  return steps <= large ? std::vector<Stage>{{1.25, steps}} : std::vector<Stage>{{1.25, large}, {1.08, steps - large}};
}

/// random numbers in (0, 1), the same ones with all standard libraries
class Random_points
{
public:
  explicit Random_points(std::uint64_t seed) : m_random(seed) {}

  Point operator()()
  {
    const double x = number();
    return Point(x, number());
  }

private:
  double number() { return (static_cast<double>(m_random() >> 11) + 0.5) / 9007199254740992.; }

  std::mt19937_64 m_random;
};

/// the outline of the unit square, in so many equal parts a side
inline std::vector<Point> square_outline(int parts = 1)
{
  std::vector<Point> points;
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      const Point on_sides[] = {Point(s, 0), Point(1, s), Point(1 - s, 1), Point(0, 1 - s)};
      points.push_back(on_sides[side]);
    }
  return points;
}

/// The distance of neighbours in a hexagonal packing of the unit square: a cell is sqrt(3)/2 d^2, of which a node
/// inside owns all, one on an edge half, and one in a corner a quarter.
inline double natural_distance(std::size_t inside, std::size_t on_edges)
{
  const double cells = static_cast<double>(inside) + 0.5 * static_cast<double>(on_edges) + 4 * 0.25;
  return std::sqrt(2 / (std::sqrt(3.) * cells));
}

/// nodes as they are, without neighbour sets
inline Nodes bare_nodes(const std::vector<Point>& points, double distance)
{
  Nodes nodes;
  nodes.points = points;
  nodes.sizes.assign(points.size(), distance);
  nodes.dimensions.assign(points.size(), 2);
  nodes.neighbor_offsets.assign(points.size() + 1, 0);
  return nodes;
}

/// One simulation with the paper's parameters, but for the number of bubbles, which stays: those on the outline are
/// pinned, those inside free.
inline Nodes simulate(const std::vector<Point>& outline, const std::vector<Point>& inside, double d, std::size_t steps)
{
  CDT cdt = paper::triangulate({outline});
  std::set<CDT::Vertex_handle> on_outline;
  for (CDT::Vertex_handle v : cdt.finite_vertex_handles())
    on_outline.insert(v);
  cdt.insert(inside.begin(), inside.end());
  const CGAL::Boolean_property_map<std::set<CDT::Vertex_handle>> is_pinned(on_outline);
  return CGAL::npbs_place_nodes(cdt, CGAL::npbs_paper_parameters()
                                       .initial_placement(CGAL::Bubble_placement::KEEP)
                                       .population_control(CGAL::Bubble_population::NONE)
                                       .number_of_rounds(1)
                                       .number_of_iterations(steps)
                                       .sizing_function(d)
                                       .vertex_is_constrained_map(is_pinned));
}

/// 12 nodes on each side of the square and 100 at random inside, after the simulation of one stage after another.
/// Their sizes are the natural distance.
inline Nodes paper_nodes(std::uint64_t seed, const std::vector<Stage>& stages)
{
  const std::vector<Point> outline = square_outline(11);
  std::vector<Point> inside(100);
  Random_points random(seed);
  for (Point& p : inside)
    p = random();
  const double distance = natural_distance(inside.size(), outline.size() - 4);
  Nodes nodes;
  for (const Stage& stage : stages) {
    nodes = simulate(outline, inside, stage.factor * distance, stage.steps);
    inside.clear();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes.dimensions[i] == 2)
        inside.push_back(nodes.points[i]);
    nodes.neighbor_radius *= stage.factor; // in units of the sizes, which are smaller now
  }
  nodes.sizes.assign(nodes.size(), distance);
  return nodes;
}

/// so many nodes at random, none of them on the boundary but by chance
inline Nodes random_nodes(std::uint64_t seed, std::size_t n)
{
  std::vector<Point> points(n);
  Random_points random(seed);
  for (Point& p : points)
    p = random();
  return bare_nodes(points, natural_distance(n, 0));
}

/// a square grid with as many nodes on each side
inline Nodes grid_nodes(int on_a_side)
{
  std::vector<Point> points;
  for (int i = 0; i < on_a_side; ++i)
    for (int j = 0; j < on_a_side; ++j)
      points.push_back(Point(static_cast<double>(i) / (on_a_side - 1), static_cast<double>(j) / (on_a_side - 1)));
  return bare_nodes(points, 1. / (on_a_side - 1));
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_NODE_SETS_H
