// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SHAPE_BLOCK_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SHAPE_BLOCK_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The shape functions of all nodes that the points of one cell see, and their gradients: a row a point, a
/// column a node. Such blocks are multiplied to the cell's part of the matrix.
template <class Moving_least_squares>
struct Shape_block_2
{
  using Point_2 = typename Moving_least_squares::Point_2;
  using Shape_functions = typename Moving_least_squares::Shape_functions;

  std::vector<double> x, y;      ///< of the points
  Eigen::VectorXd weights;       ///< of integration, of each point
  std::vector<Index> nodes;      ///< of each column, ascending
  Eigen::MatrixXd phi, dx, dy;
  std::size_t number_of_enlarged_points = 0;
  double largest_enlargement = 1;

  void clear()
  {
    x.clear();
    y.clear();
    m_weights.clear();
  }

  void add_point(double px, double py, double weight)
  {
    x.push_back(px);
    y.push_back(py);
    m_weights.push_back(weight);
  }

  std::size_t size() const { return x.size(); }
  Point_2 point(std::size_t q) const { return Point_2(x[q], y[q]); }

  /// evaluates the shape functions at the points
  void evaluate(const Moving_least_squares& mls)
  {
    weights = Eigen::Map<const Eigen::VectorXd>(m_weights.data(), static_cast<Eigen::Index>(size()));
    if (!m_query)
      m_query.emplace(mls.influence());
    m_shapes.resize((std::max)(m_shapes.size(), size()));
    nodes.clear();
    number_of_enlarged_points = 0;
    largest_enlargement = 1;
    for (std::size_t q = 0; q < size(); ++q) {
      Shape_functions& s = m_shapes[q];
      mls(point(q), 1, *m_query, s);
      nodes.insert(nodes.end(), s.nodes.begin(), s.nodes.end());
      if (s.enlargement > 1)
        ++number_of_enlarged_points;
      largest_enlargement = (std::max)(largest_enlargement, s.enlargement);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (Eigen::MatrixXd* m : {&phi, &dx, &dy})
      m->setZero(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t q = 0; q < size(); ++q)
      spread(m_shapes[q], static_cast<Eigen::Index>(q));
  }

private:
  void spread(const Shape_functions& s, Eigen::Index row)
  {
    auto column = nodes.begin();
    for (std::size_t k = 0; k < s.nodes.size(); ++k) {
      column = std::lower_bound(column, nodes.end(), s.nodes[k]);
      const Eigen::Index c = column - nodes.begin();
      phi(row, c) = s.values[k];
      dx(row, c) = s.dx[k];
      dy(row, c) = s.dy[k];
    }
  }

  std::vector<double> m_weights;
  std::vector<Shape_functions> m_shapes;
  std::optional<typename Moving_least_squares::Query> m_query;
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_SHAPE_BLOCK_2_H
