// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_DISCRETIZATION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_DISCRETIZATION_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Integration_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/integration_cells.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/mls/Mls_evaluation_2.h>

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The values of the named parameters of the element-free Galerkin method, checked.
struct Galerkin_options
{
  Moving_least_squares_basis basis = Moving_least_squares_basis::LINEAR;
  double support_factor = 2.5;
  double support_radius = 0;   ///< 0: by the factor
  Dirichlet_condition dirichlet = Dirichlet_condition::NITSCHE;
  double penalty_factor = 0;   ///< 0: by the sizes of the nodes
  double nitsche_factor = 30;
  Integration_cells cells = Integration_cells::TRIANGLES;
  std::size_t nx = 0, ny = 0;  ///< of the grid; 0: by the sizes of the nodes
  std::size_t gauss_points = 0;
  bool consistent = true;
  double residual_tolerance = 1e-12;
  std::function<bool(double)> callback;

  bool is_quadratic() const { return basis == Moving_least_squares_basis::QUADRATIC; }
};

/// `Poisson_problem_2`, whatever the kernel
struct Galerkin_problem
{
  std::function<double(const Point&)> source, dirichlet;
  std::function<double(const Point&, const Direction&)> neumann;
  std::function<bool(const Point&)> is_dirichlet;
};

template <class T>
struct Is_grid_cells_request : std::false_type {};
template <class Count>
struct Is_grid_cells_request<Grid_cells_request<Count>> : std::true_type {};

template <class NamedParameters>
void read_grid_cells(const NamedParameters& np, Galerkin_options& o)
{
  if constexpr (Is_given<NamedParameters, internal_np::grid_cells_t>::value) {
    constexpr std::size_t most = 100000;
    const auto given = parameters::get_parameter(np, internal_np::grid_cells);
    if constexpr (Is_grid_cells_request<std::decay_t<decltype(given)>>::value) {
      o.nx = read_count("grid_cells", given.nx, 1, most);
      o.ny = read_count("grid_cells", given.ny, 1, most);
    } else {
      o.nx = o.ny = read_count("grid_cells", given, 1, most);
    }
  }
}

/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Galerkin_options read_galerkin_options(const NamedParameters& np)
{
  Galerkin_options o;
  take(np, internal_np::mls_basis, o.basis);
  take(np, internal_np::support_factor, o.support_factor);
  check_positive("support_factor", o.support_factor);
  if constexpr (Is_given<NamedParameters, internal_np::support_radius_t>::value) {
    take(np, internal_np::support_radius, o.support_radius);
    check_positive("support_radius", o.support_radius);
  }
  take(np, internal_np::dirichlet_condition, o.dirichlet);
  if constexpr (Is_given<NamedParameters, internal_np::penalty_factor_t>::value) {
    take(np, internal_np::penalty_factor, o.penalty_factor);
    check_positive("penalty_factor", o.penalty_factor);
  }
  take(np, internal_np::nitsche_factor, o.nitsche_factor);
  check_positive("nitsche_factor", o.nitsche_factor);
  take(np, internal_np::integration_cells, o.cells);
  read_grid_cells(np, o);
  // The quadratic basis has order 3 in L2 with 5; with 4 integrals limit it where d is about 0.01 of the domain. More
  // points than 64 gain nothing, and in a rule of hundreds their number is the cells' likely one
  o.gauss_points = o.is_quadratic() ? 5 : 3;
  take_count(np, internal_np::number_of_gauss_points, "number_of_gauss_points", o.gauss_points, 1, 64);
  take(np, internal_np::consistent_integration, o.consistent);
  take(np, internal_np::residual_tolerance, o.residual_tolerance);
  check_positive("residual_tolerance", o.residual_tolerance);
  take(np, internal_np::callback, o.callback);
  return o;
}

/// The shape functions of all nodes that the points of one cell see, and their gradients: a row a point, a
/// column a node. Such blocks are multiplied to the cell's part of the matrix.
struct Shape_block_2
{
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
  Point point(std::size_t q) const { return Point(x[q], y[q]); }

  /// evaluates the shape functions at the points
  void evaluate(const Mls_approximation_2& mls)
  {
    weights.resize(static_cast<Eigen::Index>(size()));
    std::copy(m_weights.begin(), m_weights.end(), weights.data());
    if (!m_query)
      m_query.emplace(mls.query());
    m_shapes.resize((std::max)(m_shapes.size(), size()));
    nodes.clear();
    number_of_enlarged_points = 0;
    largest_enlargement = 1;
    for (std::size_t q = 0; q < size(); ++q) {
      Mls_shapes_2& s = m_shapes[q];
      mls.find_shapes(point(q), 1, *m_query, s);
      nodes.insert(nodes.end(), s.nodes.begin(), s.nodes.end());
      if (s.enlargement > 1)
        ++number_of_enlarged_points;
      largest_enlargement = (std::max)(largest_enlargement, s.enlargement);
    }
    sort_each_once(nodes);
    for (Eigen::MatrixXd* m : {&phi, &dx, &dy})
      m->setZero(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t q = 0; q < size(); ++q)
      spread(m_shapes[q], static_cast<Eigen::Index>(q));
  }

private:
  void spread(const Mls_shapes_2& s, Eigen::Index row)
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
  std::vector<Mls_shapes_2> m_shapes;
  std::optional<Influence_query_2> m_query;
};

/// How many parts `compute_in_order()` computes at once, with so many Gauss points along each side: they hold shape
/// functions for all their points.
inline std::size_t parts_at_once(std::size_t gauss_points)
{
  constexpr std::size_t most = 512, least = 16, points_of_a_part = 25;
  return (std::max)(least, most * points_of_a_part / (std::max)(points_of_a_part, gauss_points * gauss_points));
}

/// Computes `n` parts, `parts_at_once` of them at once, and hands them on in their order, so that sums do not depend
/// on the number of threads: calls `compute(i, place)` for places from 0 to the number of parts that are computed at
/// once, then `take(number)` for the parts in so many places. Of several exceptions that of the first part is the one
/// that is thrown. Stops when `take` returns false, and returns that.
inline bool compute_in_order(const Threads& threads, std::size_t n, std::size_t parts_at_once,
                             const std::function<void(std::size_t i, std::size_t place)>& compute,
                             const std::function<bool(std::size_t number)>& take)
{
  std::vector<std::exception_ptr> errors((std::min)(n, parts_at_once));
  for (std::size_t first = 0; first < n; first += parts_at_once) {
    const std::size_t number = (std::min)(parts_at_once, n - first);
    const auto compute_one = [&](std::size_t place) {
      try {
        compute(first + place, place);
      } catch (...) {
        errors[place] = std::current_exception();
      }
    };
    parallel_for(threads, number, compute_one, 1);
    for (const std::exception_ptr& error : errors)
      if (error)
        std::rethrow_exception(error);
    if (!take(number))
      return false;
  }
  return true;
}

/// The nodes of the element-free Galerkin method in arrays.
struct Galerkin_nodes_2
{
  std::vector<double> x, y;
  std::vector<double> size;   ///< the distance between neighbours
  std::vector<double> radius; ///< of the support

  std::size_t number() const { return x.size(); }

  /// \throws std::invalid_argument
  Galerkin_nodes_2(const std::vector<Point>& points, const std::vector<double>& sizes, const Galerkin_options& o)
    : size(sizes)
  {
    if (points.empty())
      throw std::invalid_argument("Bubble_relaxation_2: parameter nodes has no node");
    if (size.size() != points.size())
      throw std::invalid_argument("Bubble_relaxation_2: parameter nodes has " + std::to_string(size.size()) +
                                  " sizes for " + std::to_string(points.size()) + " points");
    for (std::size_t i = 0; i < size.size(); ++i) {
      x.push_back(points[i].x());
      y.push_back(points[i].y());
      if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
        throw std::invalid_argument("Bubble_relaxation_2: parameter nodes: node " + std::to_string(i) + " at " +
                                    in_words(x[i], y[i]) + " has a coordinate that is not finite");
      radius.push_back(o.support_radius > 0 ? o.support_radius : o.support_factor * size[i]);
    }
    check_numbers("nodes", "size", size, number());
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
class Galerkin_discretization_2
{
public:
  const Galerkin_options options;
  const Galerkin_nodes_2 nodes;
  const Integration_domain_2 domain;
  const std::shared_ptr<const Influence_search_2> search;
  const Mls_approximation_2 mls;
  std::vector<Background_cell_2> cells;
  std::vector<Boundary_segment_2> segments;
  const Cell_quadrature_2 cell_rule;
  const Gauss_rule segment_rule;
  const Threads threads;

  Galerkin_discretization_2(const Galerkin_options& o, Galerkin_nodes_2 n, Integration_domain_2 d,
                            std::shared_ptr<const Influence_search_2> s, const Mls_options& mls_options,
                            const Threads& th)
    : options(o), nodes(std::move(n)), domain(std::move(d)), search(std::move(s)), mls(search, mls_options),
      cell_rule(options.gauss_points), segment_rule(gauss_rule(options.gauss_points)), threads(th)
  {
    make_cells();
  }

  Galerkin_discretization_2(const Galerkin_discretization_2&) = delete;
  Galerkin_discretization_2& operator=(const Galerkin_discretization_2&) = delete;

  /// the size of the nearest node
  double size_at(const Point& p) const
  {
    return nodes.size[search->nearest(p.x(), p.y())];
  }

  const Boundary_edge_2& edge(const Boundary_segment_2& s) const { return domain.boundary[s.edge]; }

  /// the points of a cell with the shape functions
  void evaluate_cell(std::size_t k, const Cell_quadrature_2& rule, Shape_block_2& block) const
  {
    block.clear();
    rule.for_each_point(cells[k], [&](double x, double y, double w) { block.add_point(x, y, w); });
    block.evaluate(mls);
  }

  void evaluate_segment(std::size_t k, Shape_block_2& block) const
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
    std::vector<Point> points;
    const auto add = [&](double x, double y) { points.emplace_back(x, y); };
    for (const Background_cell_2& cell : cells)
      cell_rule.for_each_point(cell, [&](double x, double y, double) { add(x, y); });
    for (const Boundary_segment_2& s : segments)
      for_each_point(edge(s), s, segment_rule, [&](double, double x, double y, double) { add(x, y); });
    mls.evaluate(points, std::vector<double>(nodes.number(), 0.), 0, Threads());
  }

  /// At each point of a block the size of the nodes around, which follows the shape functions.
  Eigen::VectorXd sizes(const Shape_block_2& block) const
  {
    Eigen::VectorXd of_columns(block.phi.cols());
    for (Eigen::Index k = 0; k < of_columns.size(); ++k)
      of_columns[k] = nodes.size[static_cast<std::size_t>(block.nodes[static_cast<std::size_t>(k)])];
    const Eigen::MatrixXd weights = block.phi.cwiseAbs();
    const Eigen::VectorXd total = weights.rowwise().sum();
    Eigen::VectorXd result = weights * of_columns;
    for (Eigen::Index q = 0; q < result.size(); ++q)
      result[q] /= total[q];
    return result;
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

  std::size_t grid_cells(double span) const
  {
    double inverse = 0; // the mean of 1 / d
    for (double d : nodes.size)
      inverse += 1 / d / static_cast<double>(nodes.number());
    return static_cast<std::size_t>((std::min)((std::max)(std::ceil(span * inverse), 1.), 100000.));
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_DISCRETIZATION_2_H
