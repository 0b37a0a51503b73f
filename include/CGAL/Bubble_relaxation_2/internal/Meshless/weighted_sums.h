// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_SUMS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_SUMS_H

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

// Sums over the points of a block, in few types: every type of an expression of matrices takes long to compile.

/// the matrix of sums over rows q of a(q, i) weights(q) b(q, j)
inline Eigen::MatrixXd weighted_sums(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights,
                                     const Eigen::MatrixXd& b)
{
  const Eigen::MatrixXd weighted = b.array().colwise() * weights.array();
  return a.transpose() * weighted;
}

/// the vector of sums over rows q of a(q, i) weights(q)
inline Eigen::VectorXd weighted_sums(const Eigen::MatrixXd& a, const Eigen::VectorXd& weights)
{
  return a.transpose() * weights;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_WEIGHTED_SUMS_H
