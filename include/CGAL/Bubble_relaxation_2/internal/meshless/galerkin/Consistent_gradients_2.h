// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_CONSISTENT_GRADIENTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_CONSISTENT_GRADIENTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/geometry/Flat_triangulation_2.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Variationally consistent integration (Chen, Hillman and Rueter, Int. J. Numer. Meth. Engng. 95, 2013): the
/// gradients of test functions psi_i, and only these, are corrected such that
///   sum over cells w (grad psi_i . grad p + phi_i laplace p) = sum over the boundary w phi_i dp/dn
/// holds exactly for the polynomials p of the basis, as it does for integrals. Then a solution that is such a
/// polynomial is found exactly, whatever the rule. The correction is
///   grad psi_i = grad phi_i + b_i sum over a (c_ia grad p_a),
/// where p_a are the polynomials without the constant, about node i, and b_i is a bump, (1 - q^2)^2, over its support.
/// So a node's coefficients c solve a system with Gram's matrix: 2 equations (linear) or 5 (quadratic). The source has
/// phi_i for b_i, which does as well with the linear basis; with the quadratic one phi_i changes its sign, and near
/// singular systems made the error worse than without correction.
class Consistent_gradients_2
{
public:
  /// \param number of polynomials: 0 (no correction), 2 or 5
  Consistent_gradients_2(std::size_t number_of_nodes, int number)
    : m_number(number), m_sums(number > 0 ? number_of_nodes : 0), m_coefficients(m_sums.size())
  {}

  bool is_needed() const { return m_number > 0; }

  /// the sums of a node: what is missing in the condition of each polynomial, and the matrix
  struct Sums
  {
    std::array<double, 5> defect{};
    std::array<std::array<double, 5>, 5> gram{};
  };

  /// the part of a cell, or of a segment of the boundary, in the sums of its nodes
  struct Part
  {
    std::vector<Index> nodes;
    std::vector<Sums> sums;
  };

  /// \param nodes about what the polynomials are, and in what unit of length
  template <class Block, class Nodes>
  void compute_in_cell(const Block& block, const Nodes& nodes, Part& part) const
  {
    for_each_pair(block, nodes, part, [&](Eigen::Index q, Eigen::Index k, const Gradients& g, Sums& sums) {
      const double w = block.weights[q], phi = block.phi(q, k);
      for (int a = 0; a < m_number; ++a) {
        sums.defect[a] -= w * (block.dx(q, k) * g.x[a] + block.dy(q, k) * g.y[a] + phi * g.laplacian[a]);
        for (int b = 0; b < m_number; ++b)
          sums.gram[a][b] += w * g.bump * (g.x[a] * g.x[b] + g.y[a] * g.y[b]);
      }
    });
  }

  template <class Block, class Nodes>
  void compute_on_boundary(const Block& block, const Nodes& nodes, const Direction& normal, Part& part) const
  {
    for_each_pair(block, nodes, part, [&](Eigen::Index q, Eigen::Index k, const Gradients& g, Sums& sums) {
      for (int a = 0; a < m_number; ++a)
        sums.defect[a] += block.weights[q] * block.phi(q, k) * (normal.x * g.x[a] + normal.y * g.y[a]);
    });
  }

  void add(const Part& part)
  {
    for (std::size_t k = 0; k < part.nodes.size(); ++k) {
      Sums& sums = m_sums[static_cast<std::size_t>(part.nodes[k])];
      for (int a = 0; a < m_number; ++a) {
        sums.defect[a] += part.sums[k].defect[a];
        for (int b = 0; b < m_number; ++b)
          sums.gram[a][b] += part.sums[k].gram[a][b];
      }
    }
  }

  /// solves for the coefficients, after all parts
  void solve()
  {
    Eigen::MatrixXd gram(m_number, m_number);
    Eigen::VectorXd defect(m_number);
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
      for (int a = 0; a < m_number; ++a) {
        defect[a] = m_sums[i].defect[a];
        for (int b = 0; b < m_number; ++b)
          gram(a, b) = m_sums[i].gram[a][b];
      }
      const Eigen::VectorXd c = gram.fullPivLu().solve(defect);
      for (int a = 0; a < m_number; ++a)
        m_coefficients[i][a] = c[a];
    }
    m_sums.clear();
  }

  /// computes the gradients of the test functions of a block
  template <class Block, class Nodes>
  void correct(const Block& block, const Nodes& nodes, Eigen::MatrixXd& dx, Eigen::MatrixXd& dy) const
  {
    dx = block.dx;
    dy = block.dy;
    if (!is_needed())
      return;
    for (Eigen::Index k = 0; k < dx.cols(); ++k) {
      const Index node = block.nodes[static_cast<std::size_t>(k)];
      const std::array<double, 5>& c = m_coefficients[static_cast<std::size_t>(node)];
      for (Eigen::Index q = 0; q < dx.rows(); ++q) {
        const Gradients g = gradients(block, nodes, q, node);
        for (int a = 0; a < m_number; ++a) {
          dx(q, k) += g.bump * c[a] * g.x[a];
          dy(q, k) += g.bump * c[a] * g.y[a];
        }
      }
    }
  }

private:
  /// of x, y, x^2 / 2, x y, y^2 / 2
  struct Gradients
  {
    std::array<double, 5> x, y, laplacian;
    double bump; // of the node
  };

  /// calls `add(point, column, gradients, sums)` for the points and nodes of a block
  template <class Block, class Nodes, class Add>
  void for_each_pair(const Block& block, const Nodes& nodes, Part& part, const Add& add) const
  {
    part.nodes = block.nodes;
    part.sums.assign(block.nodes.size(), Sums());
    for (Eigen::Index k = 0; k < block.phi.cols(); ++k)
      for (Eigen::Index q = 0; q < block.phi.rows(); ++q)
        if (block.phi(q, k) != 0 || block.dx(q, k) != 0 || block.dy(q, k) != 0)
          add(q, k, gradients(block, nodes, q, block.nodes[static_cast<std::size_t>(k)]),
              part.sums[static_cast<std::size_t>(k)]);
  }

  template <class Block, class Nodes>
  static Gradients gradients(const Block& block, const Nodes& nodes, Eigen::Index q, Index i)
  {
    const auto point = static_cast<std::size_t>(q), node = static_cast<std::size_t>(i);
    const double r = nodes.radius[node];
    const double x = (block.x[point] - nodes.x[node]) / r, y = (block.y[point] - nodes.y[node]) / r;
    const double inside = (std::max)(0., 1 - x * x - y * y);
    return Gradients{{1, 0, x, y, 0}, {0, 1, 0, x, y}, {0, 0, 1 / r, 0, 1 / r}, inside * inside};
  }

  int m_number;
  std::vector<Sums> m_sums;                            // of each node
  std::vector<std::array<double, 5>> m_coefficients; // of each node
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_CONSISTENT_GRADIENTS_2_H
