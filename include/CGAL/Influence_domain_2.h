// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_INFLUENCE_DOMAIN_2_H
#define CGAL_INFLUENCE_DOMAIN_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/Bubble_buckets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/in_words.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

template <class Point_2>
struct Node_set_2;

/*!
\ingroup PkgBubbleRelaxation2Meshless

The nodes in whose influence domain a point lies. The influence domain of a node is the open disc of its radius.
*/
template <class Kernel_>
class Influence_domain_2
{
  using Buckets = Bubble_relaxation_2::internal::Bubble_buckets_2;

public:
  using Kernel = Kernel_;
  using Point_2 = typename Kernel::Point_2;
  using Node = std::int32_t; ///< the index of a node

  class Query;

  template <class NamedParameters = parameters::Default_named_parameters>
  Influence_domain_2(const Node_set_2<Point_2>& nodes, double radius,
                     const NamedParameters& = parameters::default_values())
    : Influence_domain_2(nodes.points, radius)
  {}

  template <class NamedParameters = parameters::Default_named_parameters>
  Influence_domain_2(const Node_set_2<Point_2>& nodes, std::vector<double> radii,
                     const NamedParameters& = parameters::default_values())
    : Influence_domain_2(nodes.points, std::move(radii))
  {}

  Influence_domain_2(std::vector<Point_2> points, double radius)
    : Influence_domain_2(points, std::vector<double>(points.size(), radius))
  {}

  Influence_domain_2(std::vector<Point_2> points, std::vector<double> radii)
    : m_points(std::move(points)), m_radii(std::move(radii)),
      m_buckets(1, m_radii.empty() ? 1 : m_radii[0], 0, 0, m_points.size())
  {
    if (m_radii.size() != m_points.size())
      throw std::invalid_argument("Bubble_relaxation_2: parameter radii has " + std::to_string(m_radii.size()) +
                                  " numbers for " + std::to_string(m_points.size()) + " nodes");
    for (double r : m_radii)
      Bubble_relaxation_2::internal::check_positive("radii", r);
    for (std::size_t i = 0; i < m_points.size(); ++i)
      m_buckets.insert(static_cast<Node>(i), CGAL::to_double(m_points[i].x()), CGAL::to_double(m_points[i].y()),
                       m_radii[i]);
  }

  std::size_t size() const { return m_points.size(); }
  const Point_2& point(Node i) const { return m_points[static_cast<std::size_t>(i)]; }
  double radius(Node i) const { return m_radii[static_cast<std::size_t>(i)]; }

  /// the nodes in ascending order
  template <class OutputIterator>
  OutputIterator nodes_at(const Point_2& p, OutputIterator out, double factor = 1) const
  {
    std::vector<Node> result;
    Query(*this)(p, factor, result);
    return std::copy(result.begin(), result.end(), out);
  }

  Node nearest_node(const Point_2& p) const
  {
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
    Node nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size(); ++i) {
      const double dx = CGAL::to_double(m_points[i].x()) - x, dy = CGAL::to_double(m_points[i].y()) - y;
      if (dx * dx + dy * dy < least) {
        least = dx * dx + dy * dy;
        nearest = static_cast<Node>(i);
      }
    }
    return nearest;
  }

private:
  std::vector<Point_2> m_points;
  std::vector<double> m_radii;
  Buckets m_buckets;
};

/// A sequence of queries, one a thread, which is fastest if each point is near the last.
template <class Kernel_>
class Influence_domain_2<Kernel_>::Query
{
public:
  explicit Query(const Influence_domain_2& influence) : m_influence(influence) {}

  /// the nodes in ascending order, in place of what `result` had
  void operator()(const Point_2& p, double factor, std::vector<Node>& result)
  {
    result.clear();
    m_influence.m_buckets.for_each_large(CGAL::to_double(p.x()), CGAL::to_double(p.y()), 0, factor,
                                         [&result](const auto& entry, double) {
                                           result.push_back(entry.id);
                                           return true;
                                         });
    std::sort(result.begin(), result.end());
  }

private:
  const Influence_domain_2& m_influence;
};

} // namespace CGAL

#endif // CGAL_INFLUENCE_DOMAIN_2_H
