// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_ERROR_ESTIMATE_H
#define BUBBLE_RELAXATION_2_DEMO_ERROR_ESTIMATE_H

#include "linear_finite_elements.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// What a solution by linear elements tells of its own error, by superconvergent patch recovery (Zienkiewicz and Zhu
/// 1992): around each vertex a linear function is fitted to the gradients in the centres of the triangles. It is
/// nearer to the true gradient than that of the triangles, so the difference estimates the error.
template <class CDT>
class Error_estimate
{
public:
  Error_estimate(const Triangle_arrays<CDT>& mesh, const Eigen::VectorXd& u) : m_mesh(mesh)
  {
    index_triangles();
    const std::size_t triangles = mesh.triangles.size();
    m_gradients.resize(triangles);
    for (std::size_t t = 0; t < triangles; ++t)
      m_gradients[t] = mesh.hat_gradients(t) * mesh.values(t, u);
    std::vector<Eigen::Vector2d> recovered(mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      recovered[v] = recover(v);
    m_errors.resize(triangles);
    for (std::size_t t = 0; t < triangles; ++t)
      m_errors[t] = difference(t, recovered);
  }

  /// the estimated error of the gradient on each triangle, in the norm of L2
  const std::vector<double>& of_triangles() const { return m_errors; }

  /// the estimated error of the gradient on the whole domain
  double total() const
  {
    double sum = 0;
    for (const double e : m_errors)
      sum += e * e;
    return std::sqrt(sum);
  }

private:
  /// the triangles around each vertex
  void index_triangles()
  {
    m_begin.assign(m_mesh.points.size() + 1, 0);
    for (const auto& triangle : m_mesh.triangles)
      for (const int v : triangle)
        ++m_begin[v + 1];
    for (std::size_t v = 0; v < m_mesh.points.size(); ++v)
      m_begin[v + 1] += m_begin[v];
    m_around.resize(m_begin.back());
    std::vector<std::size_t> next(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
      for (const int v : m_mesh.triangles[t])
        m_around[next[v]++] = t;
  }

  std::vector<std::size_t> patch(std::size_t v) const
  {
    std::vector<std::size_t> triangles(m_around.begin() + m_begin[v], m_around.begin() + m_begin[v + 1]);
    if (!m_mesh.is_on_boundary[v])
      return triangles;
    // on the boundary there are too few, and all on one side: those of the neighbours as well
    std::vector<std::size_t> wider;
    for (const std::size_t t : triangles)
      for (const int w : m_mesh.triangles[t])
        wider.insert(wider.end(), m_around.begin() + m_begin[w], m_around.begin() + m_begin[w + 1]);
    std::sort(wider.begin(), wider.end());
    wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
    return wider;
  }

  /// the gradient in a vertex, from a linear fit over its patch
  Eigen::Vector2d recover(std::size_t v) const
  {
    const std::vector<std::size_t> triangles = patch(v);
    std::vector<Eigen::Vector2d> from_vertex; // to the centres of triangles
    double radius = 0;
    for (const std::size_t t : triangles) {
      const auto c = CGAL::centroid(m_mesh.point(t, 0), m_mesh.point(t, 1), m_mesh.point(t, 2));
      from_vertex.emplace_back(c.x() - m_mesh.points[v].x(), c.y() - m_mesh.points[v].y());
      radius = (std::max)(radius, from_vertex.back().norm());
    }
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Vector2d mean(0, 0);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const Eigen::Vector3d basis(1, from_vertex[k][0] / radius, from_vertex[k][1] / radius);
      matrix += basis * basis.transpose();
      right += basis * m_gradients[triangles[k]].transpose();
      mean += m_gradients[triangles[k]] / static_cast<double>(triangles.size());
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(matrix);
    if (solver.rcond() < 1e-3) // too few triangles, in a corner of a coarse mesh
      return mean;
    return solver.solve(right).row(0).transpose();
  }

  /// The L2 norm of the difference of the recovered gradient, linear between vertices, from that of the triangle.
  double difference(std::size_t t, const std::vector<Eigen::Vector2d>& recovered) const
  {
    double sum = 0;
    for (int i = 0; i < 3; ++i) { // the midpoints of sides are exact for squares of linear functions
      const auto& triangle = m_mesh.triangles[t];
      sum += ((recovered[triangle[(i + 1) % 3]] + recovered[triangle[(i + 2) % 3]]) / 2 - m_gradients[t])
               .squaredNorm();
    }
    return std::sqrt(m_mesh.area(t) * sum / 3);
  }

  const Triangle_arrays<CDT>& m_mesh;
  std::vector<std::size_t> m_begin, m_around;
  std::vector<Eigen::Vector2d> m_gradients; // per triangle
  std::vector<double> m_errors;             // per triangle
};

#endif // BUBBLE_RELAXATION_2_DEMO_ERROR_ESTIMATE_H
