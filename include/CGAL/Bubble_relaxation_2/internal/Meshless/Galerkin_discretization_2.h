// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_DISCRETIZATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_DISCRETIZATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/Meshless/Background_cell_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Boundary_segment_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Galerkin_options.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Grid_cells_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Integration_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/Shape_block_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/compute_in_order.h>
#include <CGAL/Bubble_relaxation_2/internal/Meshless/triangle_cells.h>
#include <CGAL/Bubble_relaxation_2/internal/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/parallel_for.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Influence_domain_2.h>
#include <CGAL/Moving_least_squares_2.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The nodes of the element-free Galerkin method in arrays.
struct Galerkin_nodes_2
{
  std::vector<double> x, y;
  std::vector<double> size;   ///< the distance between neighbours
  std::vector<double> radius; ///< of the support

  std::size_t number() const { return x.size(); }

  /// \throws std::invalid_argument
  template <class Node_set>
  Galerkin_nodes_2(const Node_set& nodes, const Galerkin_options& o) : size(nodes.sizes)
  {
    if (nodes.points.empty())
      throw std::invalid_argument("Bubble_relaxation_2: parameter nodes has no node");
    if (size.size() != nodes.points.size())
      throw std::invalid_argument("Bubble_relaxation_2: parameter nodes has " + std::to_string(size.size()) +
                                  " sizes for " + std::to_string(nodes.points.size()) + " points");
    for (std::size_t i = 0; i < size.size(); ++i) {
      x.push_back(CGAL::to_double(nodes.points[i].x()));
      y.push_back(CGAL::to_double(nodes.points[i].y()));
      if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
        throw std::invalid_argument("Bubble_relaxation_2: parameter nodes: node " + std::to_string(i) + " at " +
                                    in_words(x[i], y[i]) + " has a coordinate that is not finite");
      if (!(size[i] > 0) || !std::isfinite(size[i]))
        throw std::invalid_argument("Bubble_relaxation_2: parameter nodes: the size " + in_words(size[i]) +
                                    " of node " + std::to_string(i) + " must be positive and finite");
      radius.push_back(o.support_radius > 0 ? o.support_radius : o.support_factor * size[i]);
    }
    check_places();
  }

  std::string place(std::size_t i) const { return "node " + std::to_string(i) + " at " + in_words(x[i], y[i]); }

private:
  /// two nodes in one place with the same radius have the same shape function, and no single solution
  void check_places() const
  {
    std::vector<std::size_t> order(number());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto key = [this](std::size_t i) { return std::tie(x[i], y[i], radius[i]); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      return key(i) != key(j) ? key(i) < key(j) : i < j;
    });
    const auto twin = std::adjacent_find(order.begin(), order.end(),
                                         [&](std::size_t i, std::size_t j) { return key(i) == key(j); });
    if (twin != order.end())
      throw std::invalid_argument("Bubble_relaxation_2: parameter nodes: node " + std::to_string(*twin) + " and " +
                                  place(*(twin + 1)) + " are in one place and have the same support");
  }
};

/// What the element-free Galerkin method needs of a domain and its nodes, whatever the equation: shape functions
/// and where integrals are summed. It does not change; solutions share it.
template <class Kernel_>
class Galerkin_discretization_2
{
public:
  using Kernel = Kernel_;
  using Moving_least_squares = Moving_least_squares_2<Kernel>;
  using Block = Shape_block_2<Moving_least_squares>;

  const Galerkin_options options;
  const Galerkin_nodes_2 nodes;
  const Integration_domain_2 domain;
  const Influence_domain_2<Kernel> influence;
  const Moving_least_squares mls;
  std::vector<Background_cell_2> cells;
  std::vector<Boundary_segment_2> segments;
  const Cell_quadrature_2 cell_rule;
  const Gauss_rule segment_rule;
  Parallel_loop parallel;

  template <class Cdt, class Node_set, class NamedParameters>
  Galerkin_discretization_2(const Cdt& cdt, const Node_set& node_set, const NamedParameters& np)
    : options(read_galerkin_options(np)), nodes(node_set, options), domain(cdt, np),
      influence(node_set, nodes.radius, np), mls(influence, np), cell_rule(options.gauss_points),
      segment_rule(gauss_rule(options.gauss_points)), parallel(make_parallel_loop<NamedParameters>())
  {
    make_cells();
  }

  Galerkin_discretization_2(const Galerkin_discretization_2&) = delete;
  Galerkin_discretization_2& operator=(const Galerkin_discretization_2&) = delete;
  /// the size of the nearest node
  double size_at(const Point& p) const
  {
    return nodes.size[influence.nearest_node(typename Kernel::Point_2(p.x(), p.y()))];
  }

  const Boundary_edge_2& edge(const Boundary_segment_2& s) const { return domain.boundary[s.edge]; }

  /// the points of a cell with the shape functions
  void evaluate_cell(std::size_t k, Block& block) const
  {
    block.clear();
    cell_rule.for_each_point(cells[k], [&](double x, double y, double w) { block.add_point(x, y, w); });
    block.evaluate(mls);
  }

  void evaluate_segment(std::size_t k, Block& block) const
  {
    block.clear();
    for_each_point(edge(segments[k]), segments[k], segment_rule,
                   [&](double, double x, double y, double w) { block.add_point(x, y, w); });
    block.evaluate(mls);
  }

  /// When nodes were found not to suffice at one point of integration: looks at all others too.
  /// \throws Deficient_support_error_2 about all of them
  void report_deficient_points() const
  {
    std::vector<typename Kernel::Point_2> points;
    const auto add = [&](double x, double y) { points.emplace_back(x, y); };
    for (const Background_cell_2& cell : cells)
      cell_rule.for_each_point(cell, [&](double x, double y, double) { add(x, y); });
    for (const Boundary_segment_2& s : segments)
      for_each_point(edge(s), s, segment_rule, [&](double, double x, double y, double) { add(x, y); });
    mls.evaluate(points, std::vector<double>(nodes.number(), 0.));
  }

  /// At each point of a block the size of the nodes around, which follows the shape functions.
  Eigen::VectorXd sizes(const Block& block) const
  {
    Eigen::VectorXd of_columns(block.phi.cols());
    for (Eigen::Index k = 0; k < of_columns.size(); ++k)
      of_columns[k] = nodes.size[static_cast<std::size_t>(block.nodes[static_cast<std::size_t>(k)])];
    const Eigen::MatrixXd weights = block.phi.cwiseAbs();
    return (weights * of_columns).cwiseQuotient(weights.rowwise().sum());
  }

private:
  void make_cells()
  {
    const std::size_t most = most_cells(nodes.number());
    if (options.cells == Integration_cells::GRID) {
      const std::size_t nx = options.nx > 0 ? options.nx : grid_cells(domain.bbox.x_span());
      const std::size_t ny = options.ny > 0 ? options.ny : grid_cells(domain.bbox.y_span());
      if (nx > most / ny)
        throw_too_many_cells_of_grid(nx, ny, most);
      const Grid_cells_2 grid(domain, nx, ny);
      cells = grid.cells();
      segments = cut_boundary(domain, grid);
    } else {
      const auto size_at = [this](const Point& p) { return this->size_at(p); };
      cells = triangle_cells(domain, size_at, most);
      segments = halved_boundary(domain, size_at, most);
    }
  }

  [[noreturn]] void throw_too_many_cells_of_grid(std::size_t nx, std::size_t ny, std::size_t most) const
  {
    if (options.nx == 0)
      throw_too_many_cells(most);
    throw std::length_error("Bubble_relaxation_2: parameter grid_cells = " + std::to_string(nx) + " x " +
                            std::to_string(ny) + " are more than " + std::to_string(most) +
                            " cells, which are enough for " + std::to_string(nodes.number()) + " nodes");
  }

  /// the tag is known here only; a solver's type does not tell it
  template <class NamedParameters>
  static Parallel_loop make_parallel_loop()
  {
    return [](std::size_t n, const std::function<void(std::size_t)>& f) {
      parallel_for<Concurrency<NamedParameters>>(n, f, 1);
    };
  }

  std::size_t grid_cells(double span) const
  {
    double inverse = 0; // the mean of 1 / d
    for (double d : nodes.size)
      inverse += 1 / d / static_cast<double>(nodes.number());
    return static_cast<std::size_t>((std::min)((std::max)(std::ceil(span * inverse), 1.), 100000.));
  }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_DISCRETIZATION_2_H
