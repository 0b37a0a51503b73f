// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_LINEAR_FINITE_ELEMENTS_H
#define BUBBLE_RELAXATION_2_DEMO_LINEAR_FINITE_ELEMENTS_H

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/squared_distance_2.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <unordered_map>
#include <vector>

/// The triangles of the domain in arrays.
template <class CDT>
struct Triangle_arrays
{
  using Point_2 = typename CDT::Geom_traits::Point_2;
  using Vertex_handle = typename CDT::Vertex_handle;

  explicit Triangle_arrays(const CDT& cdt)
  {
    std::unordered_map<Vertex_handle, int> index;
    for (const Vertex_handle v : vertices_in_domain(cdt)) {
      index[v] = static_cast<int>(points.size());
      vertices.push_back(v);
      points.push_back(v->point());
    }
    is_on_boundary.assign(points.size(), 0);
    for (auto f : cdt.finite_face_handles()) {
      if (!f->is_in_domain())
        continue;
      triangles.push_back({index[f->vertex(0)], index[f->vertex(1)], index[f->vertex(2)]});
      for (int i = 0; i < 3; ++i)
        if (!f->neighbor(i)->is_in_domain())
          boundary.push_back({index[f->vertex(cdt.ccw(i))], index[f->vertex(cdt.cw(i))]});
    }
    for (const auto& side : boundary)
      is_on_boundary[side[0]] = is_on_boundary[side[1]] = 1;
  }

  const Point_2& point(std::size_t t, int i) const { return points[triangles[t][i]]; }

  double squared_length(int v, int w) const { return CGAL::squared_distance(points[v], points[w]); }

  double area(std::size_t t) const
  {
    const Point_2 &p = point(t, 0), &q = point(t, 1), &r = point(t, 2);
    return 0.5 * ((q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
  }

  /// the gradients of the three hat functions on a triangle
  Eigen::Matrix<double, 2, 3> hat_gradients(std::size_t t) const
  {
    Eigen::Matrix<double, 2, 3> result;
    const double twice_area = 2 * area(t);
    for (int i = 0; i < 3; ++i) {
      const Point_2 &a = point(t, (i + 1) % 3), &b = point(t, (i + 2) % 3); // the side opposite to corner i
      result.col(i) << (a.y() - b.y()) / twice_area, (b.x() - a.x()) / twice_area;
    }
    return result;
  }

  Eigen::Vector3d values(std::size_t t, const Eigen::VectorXd& u) const
  {
    return {u[triangles[t][0]], u[triangles[t][1]], u[triangles[t][2]]};
  }

  std::vector<Vertex_handle> vertices;
  std::vector<Point_2> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> boundary; ///< the sides of triangles that bound the domain
  std::vector<char> is_on_boundary;         ///< per vertex

private:
  /// those of the triangulation in its order: near ones have near indices
  static std::vector<Vertex_handle> vertices_in_domain(const CDT& cdt)
  {
    std::vector<Vertex_handle> result;
    for (auto v : cdt.finite_vertex_handles()) {
      auto f = cdt.incident_faces(v), begin = f;
      bool is_in_domain = false;
      do
        is_in_domain = is_in_domain || f->is_in_domain();
      while (++f != begin);
      if (is_in_domain)
        result.push_back(v);
    }
    return result;
  }
};

/// The equations of linear finite elements for -div grad u = f with u = g on the boundary.
template <class CDT>
class Linear_element_system
{
public:
  template <class Problem>
  Linear_element_system(const Triangle_arrays<CDT>& mesh, const Problem& problem)
    : m_mesh(mesh), m_known(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size()))),
      m_row(mesh.points.size(), -1)
  {
    int unknowns = 0;
    for (std::size_t v = 0; v < m_row.size(); ++v)
      if (mesh.is_on_boundary[v])
        m_known[static_cast<Eigen::Index>(v)] = problem.dirichlet(mesh.points[v]);
      else
        m_row[v] = unknowns++;
    m_right = Eigen::VectorXd::Zero(unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      add_triangle(t, problem, entries);
    m_matrix.resize(unknowns, unknowns);
    m_matrix.setFromTriplets(entries.begin(), entries.end());
  }

  /// adds `rate` (u - before), with a mass at each vertex: a step of the implicit Euler method
  void add_mass(double rate, const Eigen::VectorXd& before)
  {
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
      for (const int v : m_mesh.triangles[t])
        if (const int r = m_row[v]; r >= 0) {
          m_matrix.coeffRef(r, r) += rate * m_mesh.area(t) / 3;
          m_right[r] += rate * m_mesh.area(t) / 3 * before[v];
        }
  }

  /// the values at the vertices
  /// \throws std::runtime_error if the system is singular
  Eigen::VectorXd solve() const
  {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(m_matrix);
    if (solver.info() != Eigen::Success)
      throw std::runtime_error("the stiffness matrix is singular");
    return with_known(solver.solve(m_right));
  }

  /// The same by conjugate gradients, from values that are near; `iterations` is set to their number.
  /// \throws std::runtime_error if the relative residual does not get down to `tolerance`
  Eigen::VectorXd solve(const Eigen::VectorXd& start, double tolerance, Eigen::Index& iterations) const
  {
    Eigen::VectorXd guess(m_right.size());
    for (std::size_t v = 0; v < m_row.size(); ++v)
      if (m_row[v] >= 0)
        guess[m_row[v]] = start[static_cast<Eigen::Index>(v)];
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver(m_matrix);
    solver.setTolerance(tolerance);
    const Eigen::VectorXd solution = solver.solveWithGuess(m_right, guess);
    if (solver.info() != Eigen::Success)
      throw std::runtime_error("conjugate gradients do not converge");
    iterations = solver.iterations();
    return with_known(solution);
  }

private:
  template <class Problem>
  void add_triangle(std::size_t t, const Problem& problem, std::vector<Eigen::Triplet<double>>& entries)
  {
    const double area = m_mesh.area(t);
    const auto gradients = m_mesh.hat_gradients(t);
    const Eigen::Matrix3d stiffness = area * gradients.transpose() * gradients;
    Eigen::Vector3d load = Eigen::Vector3d::Zero();
    if (problem.source)
      for (int i = 0; i < 3; ++i) { // the midpoints of sides are exact for quadratic functions
        const double f = problem.source(CGAL::midpoint(m_mesh.point(t, (i + 1) % 3), m_mesh.point(t, (i + 2) % 3)));
        load[(i + 1) % 3] += area / 6 * f;
        load[(i + 2) % 3] += area / 6 * f;
      }
    load -= stiffness * m_mesh.values(t, m_known); // unknown ones are 0
    for (int i = 0; i < 3; ++i) {
      const int r = m_row[m_mesh.triangles[t][i]];
      if (r < 0)
        continue;
      m_right[r] += load[i];
      for (int j = 0; j < 3; ++j)
        if (const int c = m_row[m_mesh.triangles[t][j]]; c >= 0 && c <= r)
          entries.emplace_back(r, c, stiffness(i, j));
    }
  }

  Eigen::VectorXd with_known(const Eigen::VectorXd& solution) const
  {
    Eigen::VectorXd u = m_known;
    for (std::size_t v = 0; v < m_row.size(); ++v)
      if (m_row[v] >= 0)
        u[static_cast<Eigen::Index>(v)] = solution[m_row[v]];
    return u;
  }

  const Triangle_arrays<CDT>& m_mesh;
  Eigen::VectorXd m_known; ///< on the boundary, 0 elsewhere
  std::vector<int> m_row;  ///< of the unknown at each vertex, -1 on the boundary
  Eigen::SparseMatrix<double> m_matrix; ///< its lower half
  Eigen::VectorXd m_right;
};

/// Solves -div grad u = f with u = g on the boundary by linear finite elements, and returns the values at the
/// vertices.
/// \throws std::runtime_error if the system is singular
template <class CDT, class Problem>
Eigen::VectorXd solve_by_linear_elements(const Triangle_arrays<CDT>& mesh, const Problem& problem)
{
  return Linear_element_system<CDT>(mesh, problem).solve();
}

#endif // BUBBLE_RELAXATION_2_DEMO_LINEAR_FINITE_ELEMENTS_H
