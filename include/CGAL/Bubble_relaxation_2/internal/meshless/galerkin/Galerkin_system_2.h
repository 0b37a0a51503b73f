// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_SYSTEM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_SYSTEM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Consistent_gradients_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_discretization_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Multiplier_space_2.h>
#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Sparse_solver.h>

#include <CGAL/Element_free_Galerkin_report_2.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

// Matrices in few types: every type of an expression takes long to compile.

/// the product of each element
inline Eigen::VectorXd products(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  Eigen::VectorXd result(a.size());
  for (Eigen::Index k = 0; k < a.size(); ++k)
    result[k] = a[k] * b[k];
  return result;
}

/// `a` + `factor` `b`, in the place of `a`
inline void add(Eigen::MatrixXd& a, double factor, const Eigen::MatrixXd& b)
{
  for (Eigen::Index k = 0; k < a.size(); ++k)
    a.data()[k] += factor * b.data()[k];
}

/// the vector of sums over rows q of a(q, i) weights(q)
inline Eigen::VectorXd weighted_sums(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights)
{
  return a.transpose() * weights;
}

/// the matrix of sums over rows q of a(q, i) weights(q) b(q, j)
inline Eigen::MatrixXd weighted_sums(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights, Eigen::MatrixXd b)
{
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index q = 0; q < b.rows(); ++q)
      b(q, j) *= weights[q];
  return a.transpose() * b;
}

/// Assembles the equations of a Poisson problem: first the integrals over the cells, then those over the
/// segments of the boundary. The unknowns are the coefficients of the nodes, then the multipliers.
class Galerkin_system_2
{
  using Discretization = Galerkin_discretization_2;
  using Block = Shape_block_2;

public:
  Galerkin_system_2(const Discretization& discretization, const Galerkin_problem& problem, Progress& progress,
                    Element_free_Galerkin_report_2& report)
    : m(discretization), m_problem(problem), m_progress(progress), m_report(report),
      m_gradients(m.nodes.number(), number_of_polynomials())
  {
    find_dirichlet_part();
  }

  /// returns false if the user wants to stop
  bool assemble()
  {
    const std::size_t number = m.cells.size() + m.segments.size();
    const std::size_t at_once = parts_at_once(m.options.gauss_points);
    m_parts.resize((std::min)(number, at_once));
    std::size_t done = 0;
    const auto add_sums = [&](std::size_t n) {
      for (std::size_t k = 0; k < n; ++k)
        m_gradients.add(m_parts[k].sums);
      return report_progress(0, done += n, number);
    };
    if (m_gradients.is_needed()) {
      const auto compute = [&](std::size_t i, std::size_t k) { correct(i, m_parts[k]); };
      if (!compute_in_order(m.threads, number, at_once, compute, add_sums))
        return false;
      m_gradients.solve();
    }
    done = 0;
    m_rows = std::make_unique<Sparse_rows>(number_of_unknowns());
    const auto add_rows = [&](std::size_t n) {
      m_rows->add(m.threads, m_parts, n);
      for (std::size_t k = 0; k < n; ++k)
        count(m_parts[k]);
      return report_progress(m_gradients.is_needed() ? 0.5 : 0, done += n, number);
    };
    const auto compute = [&](std::size_t i, std::size_t k) { integrate(i, m_parts[k]); };
    const bool all = compute_in_order(m.threads, number, at_once, compute, add_rows);
    m_parts.clear();
    if (all) {
      check_rows();
      check_data();
    }
    return all;
  }

  Eigen::SparseMatrix<double> matrix() const { return m_rows->matrix(); }
  const Eigen::VectorXd& load() const { return m_rows->load(); }

  /// whether the matrix is symmetric and definite but for what consistent integration adds
  bool is_nearly_definite() const { return number_of_unknowns() == m.nodes.number(); }

private:
  struct Galerkin_cell : Galerkin_part
  {
    Block block;
    Consistent_gradients_2::Part sums;
    Eigen::MatrixXd dx, dy; // of the test functions
    double total = 0, total_size = 0; // of the integrals of the data of a Neumann problem
  };

  int number_of_polynomials() const
  {
    if (!m.options.consistent || m.options.basis == Moving_least_squares_basis::CONSTANT)
      return 0;
    return m.options.is_quadratic() ? 5 : 2;
  }

  bool is_multiplied() const { return m.options.dirichlet == Dirichlet_condition::LAGRANGE_MULTIPLIERS; }

  std::size_t number_of_unknowns() const
  {
    return m.nodes.number() + (m_multipliers ? m_multipliers->size() : 0) + (m_is_neumann_problem ? 1 : 0);
  }

  void find_dirichlet_part()
  {
    for (const Boundary_edge_2& e : m.domain.boundary) {
      m_is_dirichlet.push_back(!m_problem.is_dirichlet || m_problem.is_dirichlet(middle(e.a, e.b)));
    }
    m_is_neumann_problem = std::find(m_is_dirichlet.begin(), m_is_dirichlet.end(), 1) == m_is_dirichlet.end();
    check_parts();
    if (is_multiplied() && !m_is_neumann_problem) {
      std::vector<double> lengths(m.domain.boundary.size(), 0); // in units of the size of the nodes
      for (const Boundary_segment_2& s : m.segments)
        lengths[s.edge] += (s.end - s.begin) * m.edge(s).length() /
                           m.size_at(point_on(m.edge(s), (s.begin + s.end) / 2));
      m_multipliers = std::make_unique<Multiplier_space_2>(m.domain.boundary, m_is_dirichlet, lengths);
      m_report.number_of_multipliers = m_multipliers->size();
    }
  }

  /// A part of the domain without given values has no single solution. What the parts' supports have in common would
  /// only hide that.
  void check_parts() const
  {
    std::vector<char> has_values(m.domain.parts.size(), m_is_neumann_problem && m.domain.parts.size() == 1);
    for (std::size_t e = 0; e < m_is_dirichlet.size(); ++e)
      if (m_is_dirichlet[e])
        has_values[static_cast<std::size_t>(m.domain.boundary[e].part)] = 1;
    const auto without = std::find(has_values.begin(), has_values.end(), 0);
    if (without == has_values.end())
      return;
    const Point& p = m.domain.parts[static_cast<std::size_t>(without - has_values.begin())];
    throw std::invalid_argument("Bubble_relaxation_2: the Poisson_problem_2 has no Dirichlet boundary in the part of "
                                "the domain around " + in_words(p.x(), p.y()) + ", and the domain has " +
                                std::to_string(has_values.size()) + " parts");
  }

  bool report_progress(double begin, std::size_t done, std::size_t number)
  {
    constexpr double share_of_assembly = 0.7; // the rest is the solution
    const double fraction = begin + (1 - begin) * static_cast<double>(done) / static_cast<double>(number);
    return m_progress.report(share_of_assembly * (m_gradients.is_needed() && begin == 0 ? fraction / 2 : fraction));
  }

  /// the part in the sums for the gradients of test functions
  void correct(std::size_t k, Galerkin_cell& part) const
  {
    if (k < m.cells.size()) {
      m.evaluate_cell(k, m.cell_rule, part.block);
      m_gradients.compute_in_cell(part.block, m.nodes, part.sums);
    } else {
      const std::size_t s = k - m.cells.size();
      m.evaluate_segment(s, part.block);
      m_gradients.compute_on_boundary(part.block, m.nodes, m.edge(m.segments[s]).outer_normal(), part.sums);
    }
  }

  /// the part in the equations
  void integrate(std::size_t k, Galerkin_cell& part) const
  {
    part.total = part.total_size = 0;
    if (k < m.cells.size()) {
      m.evaluate_cell(k, m.cell_rule, part.block);
      integrate_cell(part);
      return;
    }
    const Boundary_segment_2& segment = m.segments[k - m.cells.size()];
    m.evaluate_segment(k - m.cells.size(), part.block);
    if (!m_is_dirichlet[segment.edge])
      integrate_neumann(m.edge(segment), part);
    else if (is_multiplied())
      integrate_multipliers(segment, part);
    else
      integrate_dirichlet(m.edge(segment), part);
  }

  /// the values of a function of the data at the points of a block, 0 if it is not given
  static Eigen::VectorXd values(const Block& block, const char* name, const std::function<double(const Point&)>& f)
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(block.size()));
    for (std::size_t q = 0; q < block.size(); ++q) {
      const double value = f ? f(block.point(q)) : 0;
      if (!std::isfinite(value))
        throw std::invalid_argument(std::string("Bubble_relaxation_2: the function ") + name +
                                    " of the Poisson_problem_2 is " + in_words(value) + " at " +
                                    in_words(block.x[q], block.y[q]) + " and must be finite");
      result[static_cast<Eigen::Index>(q)] = value;
    }
    return result;
  }

  /// the integrals of grad u . grad v and f v
  void integrate_cell(Galerkin_cell& part) const
  {
    const Block& b = part.block;
    m_gradients.correct(b, m.nodes, part.dx, part.dy);
    part.unknowns = b.nodes;
    part.matrix = weighted_sums(part.dx, b.weights, b.dx);
    add(part.matrix, 1, weighted_sums(part.dy, b.weights, b.dy));
    add_load(part, "source", m_problem.source);
    if (m_is_neumann_problem) // the mean of u is zero
      border(part, weighted_sums(b.phi, b.weights), std::sqrt(double(m.nodes.number())) / m.domain.area);
  }

  void add_load(Galerkin_cell& part, const char* name, const std::function<double(const Point&)>& f) const
  {
    const Block& b = part.block;
    part.load = Eigen::VectorXd::Zero(b.phi.cols());
    if (!f)
      return;
    Eigen::VectorXd weighted = products(b.weights, values(b, name, f));
    part.load = weighted_sums(b.phi, weighted);
    part.total = weighted.sum();
    for (double& w : weighted)
      w = std::abs(w);
    part.total_size = weighted.sum();
  }

  /// Adds the last unknown with a row and a column. Over the area and times the root of their number, the integrals of
  /// shape functions are a vector of about length 1 in any unit, as it becomes the other equations.
  void border(Galerkin_cell& part, const Eigen::VectorXd& integrals, double factor) const
  {
    const Eigen::Index n = integrals.size();
    const Eigen::MatrixXd matrix = part.matrix;
    const Eigen::VectorXd load = part.load;
    part.unknowns.push_back(static_cast<Index>(number_of_unknowns() - 1));
    part.matrix.setZero(n + 1, n + 1);
    part.load.setZero(n + 1);
    for (Eigen::Index k = 0; k < n; ++k) {
      part.load[k] = load[k];
      part.matrix(n, k) = part.matrix(k, n) = factor * integrals[k];
      for (Eigen::Index i = 0; i < n; ++i)
        part.matrix(i, k) = matrix(i, k);
    }
  }

  void integrate_neumann(const Boundary_edge_2& edge, Galerkin_cell& part) const
  {
    const Direction normal = edge.outer_normal();
    part.unknowns = part.block.nodes;
    part.matrix.setZero(part.block.phi.cols(), part.block.phi.cols());
    std::function<double(const Point&)> flow;
    if (m_problem.neumann)
      flow = [&](const Point& p) { return m_problem.neumann(p, normal); };
    add_load(part, "neumann", flow);
  }

  /// Penalty: the integral of alpha (u - g) v. Nitsche's method adds - du/dn v, which makes it consistent, and
  /// - (u - g) dv/dn, which makes it symmetric.
  void integrate_dirichlet(const Boundary_edge_2& edge, Galerkin_cell& part) const
  {
    const Block& b = part.block;
    const Eigen::VectorXd g = values(b, "dirichlet", m_problem.dirichlet), factor = products(penalty(b), b.weights);
    part.unknowns = b.nodes;
    part.matrix = weighted_sums(b.phi, factor, b.phi);
    part.load = weighted_sums(b.phi, products(factor, g));
    if (m.options.dirichlet == Dirichlet_condition::PENALTY)
      return;
    const Direction n = edge.outer_normal();
    Eigen::MatrixXd normal(b.dx.rows(), b.dx.cols());
    for (Eigen::Index k = 0; k < normal.size(); ++k)
      normal.data()[k] = n.x * b.dx.data()[k] + n.y * b.dy.data()[k];
    add(part.matrix, -1, weighted_sums(b.phi, b.weights, normal));
    add(part.matrix, -1, weighted_sums(normal, b.weights, b.phi));
    part.load -= weighted_sums(normal, products(b.weights, g));
  }

  /// the factor of the penalty at each point
  Eigen::VectorXd penalty(const Block& b) const
  {
    Eigen::VectorXd result = m.sizes(b);
    for (double& h : result) {
      if (m.options.dirichlet == Dirichlet_condition::NITSCHE)
        h = m.options.nitsche_factor * (1 / h);
      else if (m.options.penalty_factor > 0)
        h = m.options.penalty_factor;
      else // on the unit square with h = 1/11 this is about 10^4, in the middle of the range where errors are small
        h = 80 * std::sqrt(m.domain.area) * (1 / (h * h));
    }
    return result;
  }

  /// the integrals of lambda v and mu (u - g), for multipliers lambda and their test functions mu, over the mean
  /// distance of nodes: so they are about as large as other entries in any unit
  void integrate_multipliers(const Boundary_segment_2& segment, Galerkin_cell& part) const
  {
    const Block& b = part.block;
    std::vector<std::size_t> hats; // ascending, as unknowns must be
    const auto for_each_hat = [&](const auto& visit) {
      Eigen::Index q = 0;
      for_each_point(m.edge(segment), segment, m.segment_rule, [&](double s, double, double, double) {
        for (const Multiplier_space_2::Hat& hat : m_multipliers->hats(segment.edge, s))
          visit(q, hat);
        ++q;
      });
    };
    for_each_hat([&](Eigen::Index, const Multiplier_space_2::Hat& hat) { hats.push_back(hat.index); });
    sort_each_once(hats);
    Eigen::MatrixXd mu =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(b.size()), static_cast<Eigen::Index>(hats.size()));
    for_each_hat([&](Eigen::Index q, const Multiplier_space_2::Hat& hat) {
      mu(q, std::lower_bound(hats.begin(), hats.end(), hat.index) - hats.begin()) += hat.value;
    });
    const Eigen::Index n = b.phi.cols(), all = n + mu.cols();
    Eigen::VectorXd weights = b.weights;
    for (double& w : weights)
      w /= std::sqrt(m.domain.area / double(m.nodes.number()));
    const Eigen::MatrixXd coupling = weighted_sums(b.phi, weights, mu);
    part.matrix.setZero(all, all);
    part.load.setZero(all);
    const Eigen::VectorXd g = values(b, "dirichlet", m_problem.dirichlet);
    const Eigen::VectorXd load = weighted_sums(mu, products(weights, g));
    for (Eigen::Index k = 0; k < mu.cols(); ++k) {
      part.load[n + k] = load[k];
      for (Eigen::Index i = 0; i < n; ++i)
        part.matrix(i, n + k) = part.matrix(n + k, i) = coupling(i, k);
    }
    part.unknowns = b.nodes;
    for (std::size_t hat : hats)
      part.unknowns.push_back(static_cast<Index>(m.nodes.number() + hat));
  }

  void count(const Galerkin_cell& part)
  {
    m_report.number_of_enlarged_points += part.block.number_of_enlarged_points;
    m_report.largest_enlargement = (std::max)(m_report.largest_enlargement, part.block.largest_enlargement);
    m_total += part.total;
    m_total_size += part.total_size;
  }

  void check_rows() const
  {
    for (std::size_t i = 0; i < m.nodes.number(); ++i)
      if (m_rows->diagonal(i) == 0)
        throw std::runtime_error("Bubble_relaxation_2: no Gauss point lies in the support of " + m.nodes.place(i) +
                                 ", of radius " + in_words(m.nodes.radius[i]) +
                                 ": more Gauss points are needed, or the node lies far outside of the domain");
  }

  /// without given values on the boundary, what flows in must have its source
  void check_data() const
  {
    constexpr double largest_share = 1e-3; // what is less may be an error of integration
    if (m_is_neumann_problem && !(std::abs(m_total) <= largest_share * m_total_size))
      throw std::invalid_argument(
        "Bubble_relaxation_2: the Poisson_problem_2 has no Dirichlet boundary, and the integrals of source and "
        "neumann add up to " + in_words(m_total) + ", not to 0, so it has no solution");
  }

  const Discretization& m;
  const Galerkin_problem& m_problem;
  Progress& m_progress;
  Element_free_Galerkin_report_2& m_report;
  std::vector<char> m_is_dirichlet; // of each edge of the boundary
  bool m_is_neumann_problem = false;
  std::unique_ptr<Multiplier_space_2> m_multipliers;
  Consistent_gradients_2 m_gradients;
  std::vector<Galerkin_cell> m_parts;
  std::unique_ptr<Sparse_rows> m_rows;
  double m_total = 0, m_total_size = 0;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_SYSTEM_2_H
