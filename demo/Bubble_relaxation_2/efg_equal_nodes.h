// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_EFG_EQUAL_NODES_H
#define BUBBLE_RELAXATION_2_DEMO_EFG_EQUAL_NODES_H

#include "efg_node_sets.h"

#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace efg {

/// Sets of as many nodes as a given one, with the same nodes on the boundary; those inside are placed otherwise.
class Equal_nodes
{
public:
  /// \param given nodes with their dimensions, at about `distance` from each other
  Equal_nodes(const std::vector<paper::Outline>& outlines, const Nodes& given, double distance)
    : m_outlines(outlines), m_distance(distance)
  {
    for (const paper::Outline& o : outlines)
      for (const Point& p : o)
        m_box += p.bbox();
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given.dimensions[i] < 2)
        m_on_boundary.push_back(given.points[i]);
    m_inside = given.size() - m_on_boundary.size();
  }

  Nodes random(std::uint64_t seed) const
  {
    Random_points random(seed);
    return with_boundary(take([&random](std::size_t) { return random(); }));
  }

  /// the sequence of Halton with the bases 2 and 3
  Nodes halton() const
  {
    return with_boundary(
      take([](std::size_t k) { return Point(radical_inverse(k + 1, 2), radical_inverse(k + 1, 3)); }));
  }

  /// a square grid; none of its nodes is nearer to the boundary than half of its width
  Nodes grid() const { return with_boundary(grid_points(m_inside, 0.5)); }

  /// a square grid without nodes on the boundary but by chance
  Nodes bare_grid() const { return bare_nodes(grid_points(m_inside + m_on_boundary.size(), 0), m_distance); }

private:
  static double radical_inverse(std::size_t k, std::size_t base)
  {
    double value = 0, weight = 1;
    for (; k > 0; k /= base)
      value += (weight /= static_cast<double>(base)) * static_cast<double>(k % base);
    return value;
  }

  bool is_inside(const Point& p) const
  {
    std::size_t around = 0;
    for (const paper::Outline& o : m_outlines)
      around += CGAL::bounded_side_2(o.begin(), o.end(), p, paper::K()) == CGAL::ON_BOUNDED_SIDE;
    return around % 2 == 1;
  }

  double squared_distance_to_boundary(const Point& p) const
  {
    double least = (std::numeric_limits<double>::max)();
    for (const paper::Outline& o : m_outlines)
      for (std::size_t i = 0; i < o.size(); ++i)
        least = (std::min)(least, CGAL::squared_distance(p, paper::K::Segment_2(o[i], o[(i + 1) % o.size()])));
    return least;
  }

  /// the first of the points of a sequence in the unit square, stretched over the box, that lie inside
  template <class Sequence>
  std::vector<Point> take(const Sequence& sequence) const
  {
    std::vector<Point> points;
    for (std::size_t k = 0; points.size() < m_inside; ++k) {
      const Point q = sequence(k);
      const Point p(m_box.xmin() + q.x() * m_box.x_span(), m_box.ymin() + q.y() * m_box.y_span());
      if (is_inside(p))
        points.push_back(p);
    }
    return points;
  }

  /// the points of the widest grid that has `n` of them inside, farther from the boundary than `margin` widths; what
  /// it has more than that is left out where it is nearest to the boundary
  std::vector<Point> grid_points(std::size_t n, double margin) const
  {
    double width = 2 * m_distance, narrow = 0.25 * m_distance;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (narrow + width);
      (grid_inside(middle, margin).size() < n ? width : narrow) = middle;
    }
    std::vector<std::pair<double, Point>> points = grid_inside(narrow, margin);
    std::sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.first > q.first; });
    std::vector<Point> result;
    for (std::size_t k = 0; k < n; ++k)
      result.push_back(points[k].second);
    return result;
  }

  /// points of a grid, with their squared distances from the boundary
  std::vector<std::pair<double, Point>> grid_inside(double width, double margin) const
  {
    std::vector<std::pair<double, Point>> points;
    for (double x = m_box.xmin() + 0.5 * width; x < m_box.xmax(); x += width)
      for (double y = m_box.ymin() + 0.5 * width; y < m_box.ymax(); y += width) {
        const Point p(x, y);
        const double squared = is_inside(p) ? squared_distance_to_boundary(p) : 0;
        if (squared > margin * margin * width * width)
          points.emplace_back(squared, p);
      }
    return points;
  }

  Nodes with_boundary(std::vector<Point> points) const
  {
    points.insert(points.end(), m_on_boundary.begin(), m_on_boundary.end());
    return bare_nodes(points, m_distance);
  }

  const std::vector<paper::Outline>& m_outlines;
  double m_distance;
  CGAL::Bbox_2 m_box;
  std::vector<Point> m_on_boundary;
  std::size_t m_inside = 0;
};

/// A mesh of the unit square by `npbs_relax()` with as many vertices as asked for: a size is looked for that gives
/// them. If none is found, the one with the nearest number.
inline CDT square_mesh(std::size_t n)
{
  const double parts = std::sqrt(static_cast<double>(n)) - 1; // of a side, by a square grid
  CDT best;
  double least_difference = (std::numeric_limits<double>::max)();
  for (int k = 0; k < 80 && least_difference > 0; ++k) {
    const double d = (1.07 + 0.001 * (k % 2 == 0 ? k / 2 : -(k / 2) - 1)) / parts;
    CDT mesh = paper::triangulate({square_outline()});
    CGAL::npbs_relax(mesh, CGAL::parameters::sizing_function(d));
    const double difference = std::abs(static_cast<double>(mesh.number_of_vertices()) - static_cast<double>(n));
    if (difference < least_difference) {
      least_difference = difference;
      best.swap(mesh);
    }
  }
  return best;
}

} // namespace efg

#endif // BUBBLE_RELAXATION_2_DEMO_EFG_EQUAL_NODES_H
