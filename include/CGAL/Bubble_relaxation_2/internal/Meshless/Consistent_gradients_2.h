// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_CONSISTENT_GRADIENTS_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_CONSISTENT_GRADIENTS_2_H

#include <CGAL/Bubble_relaxation_2/internal/Flat_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/in_words.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Variationally consistent integration (Chen, Hillman and Rueter, Int. J. Numer. Meth. Engng. 95, 2013): the
/// gradients of test functions psi_i, and only these, are corrected such that
///   sum over cells w (grad psi_i . grad p + phi_i laplace p) = sum over the boundary w phi_i dp/dn
/// holds exactly for the polynomials p of the basis, as it does for integrals. Then a solution that is such a
/// polynomial is found exactly, whatever the rule. The correction is
///   grad psi_i = grad phi_i + phi_i sum over a (c_ia grad p_a),
/// where p_a are the polynomials without the constant, about node i, so that a node's coefficients c solve a
/// system of Gram's kind with as many equations as there are polynomials: 2 (linear) or 5 (quadratic).
class Consistent_gradients_2
{
public:
  /// \param number of polynomials: 0 (no correction), 2 or 5
  Consistent_gradients_2(std::size_t number_of_nodes, int number)
    : m_number(number), m_coefficients(number, static_cast<Eigen::Index>(number_of_nodes)),
      m_defect(number, static_cast<Eigen::Index>(number_of_nodes)),
      m_gram(number * number, static_cast<Eigen::Index>(number_of_nodes))
  {
    m_coefficients.setZero();
    m_defect.setZero();
    m_gram.setZero();
  }

  bool is_needed() const { return m_number > 0; }

  /// The part of a cell, or of a segment of the boundary, in the sums of its nodes: a column a node, first
  /// what is missing in the condition of each polynomial, then the matrix.
  struct Part
  {
    std::vector<Index> nodes;
    Eigen::MatrixXd sums;
  };

  /// \param nodes about what the polynomials are, and in what unit of length
  template <class Block, class Nodes>
  void compute_in_cell(const Block& block, const Nodes& nodes, Part& part) const
  {
    start(block, part);
    for (Eigen::Index k = 0; k < block.phi.cols(); ++k) {
      auto defect = part.sums.col(k).head(m_number);
      Eigen::Map<Eigen::MatrixXd> gram(part.sums.col(k).data() + m_number, m_number, m_number);
      for (Eigen::Index q = 0; q < block.phi.rows(); ++q) {
        if (block.phi(q, k) == 0)
          continue;
        const Gradients g = gradients(block, nodes, q, k);
        const double w = block.weights[static_cast<std::size_t>(q)], phi = block.phi(q, k);
        defect -= w * (block.dx(q, k) * g.x + block.dy(q, k) * g.y + phi * g.laplacian).head(m_number);
        gram += w * phi * (g.x * g.x.transpose() + g.y * g.y.transpose()).topLeftCorner(m_number, m_number);
      }
    }
  }

  template <class Block, class Nodes>
  void compute_on_boundary(const Block& block, const Nodes& nodes, const Direction& normal,
                           Part& part) const
  {
    start(block, part);
    for (Eigen::Index k = 0; k < block.phi.cols(); ++k)
      for (Eigen::Index q = 0; q < block.phi.rows(); ++q) {
        if (block.phi(q, k) == 0)
          continue;
        const Gradients g = gradients(block, nodes, q, k);
        const double w = block.weights[static_cast<std::size_t>(q)];
        part.sums.col(k).head(m_number) +=
          w * block.phi(q, k) * (normal.x * g.x + normal.y * g.y).head(m_number);
      }
  }

  void add(const Part& part)
  {
    for (std::size_t k = 0; k < part.nodes.size(); ++k) {
      const Eigen::Index i = part.nodes[k], column = static_cast<Eigen::Index>(k);
      m_defect.col(i) += part.sums.col(column).head(m_number);
      m_gram.col(i) += part.sums.col(column).tail(m_number * m_number);
    }
  }

  /// solves for the coefficients, after all parts
  void solve()
  {
    for (Eigen::Index i = 0; i < m_coefficients.cols(); ++i) {
      const Eigen::Map<const Eigen::MatrixXd> gram(m_gram.col(i).data(), m_number, m_number);
      m_coefficients.col(i) = gram.completeOrthogonalDecomposition().solve(m_defect.col(i));
    }
  }

  /// the gradients of the test functions of a block
  template <class Block, class Nodes>
  void correct(const Block& block, const Nodes& nodes, Eigen::MatrixXd& dx, Eigen::MatrixXd& dy) const
  {
    dx = block.dx;
    dy = block.dy;
    if (!is_needed())
      return;
    for (Eigen::Index k = 0; k < dx.cols(); ++k) {
      const auto c = m_coefficients.col(block.nodes[static_cast<std::size_t>(k)]);
      for (Eigen::Index q = 0; q < dx.rows(); ++q) {
        if (block.phi(q, k) == 0)
          continue;
        const Gradients g = gradients(block, nodes, q, k);
        dx(q, k) += block.phi(q, k) * c.dot(g.x.head(m_number));
        dy(q, k) += block.phi(q, k) * c.dot(g.y.head(m_number));
      }
    }
  }

private:
  using Vector = Eigen::Matrix<double, 5, 1>;

  /// of x, y, x^2 / 2, x y, y^2 / 2
  struct Gradients
  {
    Vector x, y, laplacian;
  };

  template <class Block>
  void start(const Block& block, Part& part) const
  {
    part.nodes = block.nodes;
    part.sums.setZero(m_number * (m_number + 1), block.phi.cols());
  }

  template <class Block, class Nodes>
  static Gradients gradients(const Block& block, const Nodes& nodes, Eigen::Index q, Eigen::Index k)
  {
    const auto point = static_cast<std::size_t>(q);
    const auto node = static_cast<std::size_t>(block.nodes[static_cast<std::size_t>(k)]);
    const double r = nodes.radius[node];
    const double x = (block.x[point] - nodes.x[node]) / r, y = (block.y[point] - nodes.y[node]) / r;
    Gradients g;
    g.x << 1, 0, x, y, 0;
    g.y << 0, 1, 0, x, y;
    g.laplacian << 0, 0, 1 / r, 0, 1 / r;
    return g;
  }

  int m_number;
  Eigen::MatrixXd m_coefficients, m_defect, m_gram; // a column a node
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_CONSISTENT_GRADIENTS_2_H
