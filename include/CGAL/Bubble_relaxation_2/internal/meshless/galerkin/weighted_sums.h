// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_WEIGHTED_SUMS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_WEIGHTED_SUMS_H

#include <Eigen/Core>

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

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_WEIGHTED_SUMS_H
