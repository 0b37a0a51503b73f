// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_LIMIT_ANTIDIFFUSION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_LIMIT_ANTIDIFFUSION_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Mass_matrix_2.h>
#include <CGAL/Bubble_relaxation_2/internal/transfer/Transfer_problem_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Takes a projection with a lumped mass matrix, whose values are means and keep all bounds, as near to the consistent
/// one as bounds allow. Both differ by fluxes along the edges, m<sub>ij</sub> (u<sub>i</sub> - u<sub>j</sub>), which
/// move the integral from vertex to vertex and keep its sum. Each flux is scaled by what both its ends can take
/// (Zalesak, J. Comput. Phys. 31 (1979); for projections Kuzmin, Moeller, Shadid and Shashkov, J. Comput. Phys. 229
/// (2010)).
class Antidiffusion_limiter_2
{
public:
  Antidiffusion_limiter_2(const Face_set_2& faces, const Mass_matrix_2& mass, const std::vector<Bounds>& bounds,
                          const std::vector<char>& is_free)
    : m_faces(faces), m_mass(mass), m_bounds(bounds), m_is_free(is_free)
  {}

  /// \param consistent the values of the consistent projection
  /// \param lumped those of the lumped one, which become the result
  void operator()(const std::vector<double>& consistent, std::vector<double>& lumped) const
  {
    std::vector<double> gain(lumped.size(), 0), loss(lumped.size(), 0);
    for_each_flux(consistent, [&](Index i, Index j, double flux) {
      (flux > 0 ? gain[i] : loss[i]) += flux;
      (flux > 0 ? loss[j] : gain[j]) -= flux;
    });
    for (std::size_t i = 0; i < lumped.size(); ++i) {
      const double m = m_mass.lumped()[i];
      gain[i] = share(m * (m_bounds[i].largest - lumped[i]), gain[i], m_is_free[i]);
      loss[i] = share(m * (m_bounds[i].least - lumped[i]), loss[i], m_is_free[i]);
    }
    std::vector<double> added(lumped.size(), 0);
    for_each_flux(consistent, [&](Index i, Index j, double flux) {
      flux *= flux > 0 ? (std::min)(gain[i], loss[j]) : (std::min)(loss[i], gain[j]);
      added[i] += flux;
      added[j] -= flux;
    });
    for (std::size_t i = 0; i < lumped.size(); ++i)
      if (m_is_free[i])
        lumped[i] = m_bounds[i].clamp(lumped[i] + added[i] / m_mass.lumped()[i]);
  }

private:
  template <class Visitor>
  void for_each_flux(const std::vector<double>& values, const Visitor& visit) const
  {
    for (std::size_t t = 0; t < m_faces.number_of_triangles(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Index i = m_faces.triangles[t][k], j = m_faces.triangles[t][ccw(k)];
        const double flux = m_mass.areas()[t] / 12 * (values[i] - values[j]);
        if (flux != 0)
          visit(i, j, flux);
      }
  }

  /// how much of the wanted change, of the same sign as the room for it, can be had; what is fixed limits nothing
  static double share(double room, double wanted, bool is_free)
  {
    return is_free && wanted != 0 ? (std::max)(0., (std::min)(1., room / wanted)) : 1;
  }

  const Face_set_2& m_faces;
  const Mass_matrix_2& m_mass;
  const std::vector<Bounds>& m_bounds;
  const std::vector<char>& m_is_free;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_LIMIT_ANTIDIFFUSION_H
