// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_PROJECTION_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_PROJECTION_2_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Compensated_sum.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Mass_matrix_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Vertex_shares_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/limit_antidiffusion.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The function of the target that is the nearest to the source's in the mean square, u, from M (u - u<sub>I</sub>) =
/// r, where u<sub>I</sub> interpolates and r are the shares of the triangles. Solving for the difference has three
/// effects: where the source does not reach, the field is u<sub>I</sub>, the nearest value, and M is that of whole
/// triangles, so it is never near to singular; what the target can represent comes out exactly; and roundings are those
/// of a correction. The integral of u is that of the source over the overlap and of u<sub>I</sub> over the rest.
class Vertex_projection_2
{
public:
  /// \param mass of the target
  Vertex_projection_2(const Transfer_problem_2& problem, const Mass_matrix_2& mass,
                      const std::vector<double>& interpolated, const std::vector<Vertex_share_2>& shares,
                      double source_integral)
    : m_problem(problem), m_mass(mass), m_interpolated(interpolated), m_shares(shares),
      m_residual(interpolated.size(), 0), m_is_free(interpolated.size(), 1)
  {
    for (std::size_t i = 0; i < m_is_free.size(); ++i)
      if (m_mass.lumped()[i] == 0 || (!problem.is_fixed.empty() && problem.is_fixed[i]))
        m_is_free[i] = 0;
    Compensated_sum integral;
    integral += m_mass.integral(interpolated);
    for (std::size_t t = 0; t < shares.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        m_residual[problem.target.triangles[t][k]] += shares[t].moments[k];
        integral += shares[t].moments[k];
      }
    m_integral = problem.keeps_integral ? source_integral : integral.value();
  }

  /// the nearest function among those with the integral and with the values of fixed vertices
  std::vector<double> consistent() const
  {
    std::vector<double> values = m_mass.solve(m_residual, m_is_free);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] += m_interpolated[i];
    // a constraint of the integral adds a multiple of what solves M y = m: the constant 1 if all vertices are free
    const bool all_are_free = std::find(m_is_free.begin(), m_is_free.end(), 0) == m_is_free.end();
    const std::vector<double> shift = all_are_free ? std::vector<double>(values.size(), 1)
                                                   : m_mass.solve(m_mass.lumped(), m_is_free);
    const double size = m_mass.integral(shift);
    for (int turn = 0; turn < 2 && size > 0; ++turn) {
      const double factor = (m_integral - m_mass.integral(values)) / size;
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += factor * shift[i];
    }
    return values;
  }

  /// near to that, with values between those that the source has in the triangles around
  std::vector<double> monotone() const
  {
    const std::vector<Bounds> bounds = vertex_bounds();
    const std::vector<double> moments = m_mass * m_interpolated;
    std::vector<double> values = m_interpolated;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (m_is_free[i])
        values[i] = bounds[i].clamp((moments[i] + m_residual[i]) / m_mass.lumped()[i]);
    limit_antidiffusion(m_problem.target, m_mass, bounds, m_is_free, consistent(), values);
    std::vector<double> weights = m_mass.lumped();
    for (std::size_t i = 0; i < weights.size(); ++i)
      weights[i] *= m_is_free[i];
    for (int turn = 0; turn < 2; ++turn)
      spread_within_bounds(m_integral - m_mass.integral(values), weights, bounds, values);
    return values;
  }

private:
  std::vector<Bounds> vertex_bounds() const
  {
    std::vector<Bounds> bounds;
    for (double v : m_interpolated)
      bounds.push_back(Bounds{v, v});
    for (std::size_t t = 0; t < m_shares.size(); ++t)
      for (Index v : m_problem.target.triangles[t])
        bounds[v].include(m_shares[t].bounds);
    return bounds;
  }

  const Transfer_problem_2& m_problem;
  const Mass_matrix_2& m_mass;
  const std::vector<double>& m_interpolated;
  const std::vector<Vertex_share_2>& m_shares;
  std::vector<double> m_residual;
  std::vector<char> m_is_free;
  double m_integral; // that the result is to have
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_VERTEX_PROJECTION_2_H
