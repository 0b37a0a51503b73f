// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_SIZE_FROM_ERROR_H
#define BUBBLE_RELAXATION_2_DEMO_SIZE_FROM_ERROR_H

#include "linear_finite_elements.h"

#include <CGAL/Interpolated_sizing_field_2.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

/// Which part of the error shall be the same on all triangles of the next mesh.
enum class Equal_error
{
  GRADIENT, ///< that of the gradient
  VALUE     ///< that of the values, which locally is h times that of the gradient
};

/// The next d, from the errors of the last mesh.
///
/// Let a triangle with sides of length h have the error e of the gradient, in the norm of L2. The integrand is about
/// (h |D2u|)^2, so e is about h^2 |D2u|. Among all d with as many nodes, the integral of 1/d^2, the sum of all e^2,
/// the integral of (d |D2u|)^2, is least if d^4 |D2u|^2 is constant: if e is the same on all triangles. On the next
/// mesh it is the constant c if d = h (c/e)^(1/2) where it was e.
///
/// The best linear function misses the values by about (h^2 |D2u|)^2, integrated: this is least if d^6 |D2u|^2 is
/// constant, d = h (c / (h e))^(1/3). But on domains with inner corners a solution is not the best function: the error
/// of its values is a sum of products with the error of a dual problem (Aubin and Nitsche), whose solution has the
/// singularity of the corner too. Around a corner where u is like the dual solution, the sum is that of e^2 again.
/// So equal errors of gradients are the better choice in both norms there, and by what adaptive_poisson measures.
template <class CDT>
class Size_from_error
{
public:
  using Field = CGAL::Interpolated_sizing_field_2<CDT>;

  Size_from_error(const Triangle_arrays<CDT>& mesh, const std::vector<double>& errors, Equal_error equal)
    : m_mesh(mesh), m_length(mesh.points.size(), 0), m_wanted(mesh.points.size(), 0)
  {
    std::vector<int> count(mesh.points.size(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const double h = std::sqrt(4 / std::sqrt(3.) * mesh.area(t)); // the side of an equilateral one
      const double e = (std::max)(errors[t], smallest_error);
      const double wanted = equal == Equal_error::GRADIENT ? h / std::sqrt(e) : h / std::cbrt(h * e);
      for (const int v : mesh.triangles[t]) {
        m_length[v] += std::log(h);
        m_wanted[v] += std::log(wanted);
        ++count[v];
      }
    }
    for (std::size_t v = 0; v < count.size(); ++v) { // geometric means: errors of neighbours differ by factors
      m_length[v] = std::exp(m_length[v] / count[v]);
      m_wanted[v] = std::exp(m_wanted[v] / count[v]);
    }
  }

  /// The sizes at the vertices of the mesh that ask for about `number_of_nodes`, no less than a quarter and no more
  /// than twice what they are: errors are told from this mesh, and foretell little of one that is much finer. Between
  /// the vertices and in how fast it grows it is limited by `gradation`.
  Field operator()(const CDT& cdt, double number_of_nodes, double gradation) const
  {
    const std::vector<double> d = sizes(number_of_nodes, 0.25, 2);
    std::unordered_map<typename CDT::Vertex_handle, double> of_vertex;
    for (std::size_t v = 0; v < d.size(); ++v)
      of_vertex[m_mesh.vertices[v]] = d[v];
    return Field(cdt, boost::make_assoc_property_map(of_vertex), gradation);
  }

  /// The same at each vertex, not limited in how they grow, within `least` and `most` times what they are.
  std::vector<double> sizes(double number_of_nodes, double least, double most) const
  {
    double scale = 1;
    std::vector<double> d = scaled(scale, least, most);
    for (int turn = 0; turn < 60; ++turn) {
      const double expected = expected_number_of_nodes(d);
      if (std::abs(expected - number_of_nodes) < 1e-3 * number_of_nodes)
        break;
      scale *= std::sqrt(expected / number_of_nodes);
      d = scaled(scale, least, most);
    }
    return d;
  }

private:
  static constexpr double smallest_error = 1e-100;

  std::vector<double> scaled(double scale, double least, double most) const
  {
    std::vector<double> d(m_wanted.size());
    for (std::size_t v = 0; v < d.size(); ++v)
      d[v] = std::clamp(scale * m_wanted[v], m_length[v] * least, m_length[v] * most);
    return d;
  }

  /// the density of the hexagonal lattice; on the boundary half a cell more for each node
  double expected_number_of_nodes(const std::vector<double>& d) const
  {
    double number = 1;
    for (std::size_t t = 0; t < m_mesh.triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const double middle = (d[m_mesh.triangles[t][i]] + d[m_mesh.triangles[t][(i + 1) % 3]]) / 2;
        number += 2 / std::sqrt(3.) * m_mesh.area(t) / (3 * middle * middle);
      }
    for (const auto& side : m_mesh.boundary)
      number += std::sqrt(m_mesh.squared_length(side[0], side[1])) / (d[side[0]] + d[side[1]]);
    return number;
  }

  const Triangle_arrays<CDT>& m_mesh;
  std::vector<double> m_length; ///< of the edges around each vertex
  std::vector<double> m_wanted; ///< the next ones, up to a common factor
};

#endif // BUBBLE_RELAXATION_2_DEMO_SIZE_FROM_ERROR_H
