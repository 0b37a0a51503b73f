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
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Calls `visit(i, j, flux)` for the fluxes from vertex to vertex along the sides of triangles.
template <class Visitor>
void for_each_flux(const Face_set_2& faces, const Mass_matrix_2& mass, const std::vector<double>& values,
                   const Visitor& visit)
{
  for (std::size_t t = 0; t < faces.number_of_triangles(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index i = faces.triangles[t][k], j = faces.triangles[t][ccw(k)];
      const double flux = mass.areas()[t] / 12 * (values[i] - values[j]);
      if (flux != 0)
        visit(i, j, flux);
    }
}

/// Takes a projection with a lumped mass matrix, whose values are means and keep all bounds, as near to the consistent
/// one as bounds allow. Both differ by fluxes along the edges, m<sub>ij</sub> (u<sub>i</sub> - u<sub>j</sub>), which
/// move the integral from vertex to vertex and keep its sum. Each flux is scaled by what both its ends can take
/// (Zalesak, J. Comput. Phys. 31 (1979); for projections Kuzmin, Moeller, Shadid and Shashkov, J. Comput. Phys. 229
/// (2010)). What is not free limits nothing.
/// \param consistent the values of the consistent projection
/// \param lumped those of the lumped one, which become the result
inline void limit_antidiffusion(const Face_set_2& faces, const Mass_matrix_2& mass, const std::vector<Bounds>& bounds,
                                const std::vector<char>& is_free, const std::vector<double>& consistent,
                                std::vector<double>& lumped)
{
  std::vector<double> gain(lumped.size(), 0), loss(lumped.size(), 0);
  for_each_flux(faces, mass, consistent, [&](Index i, Index j, double flux) {
    (flux > 0 ? gain[i] : loss[i]) += flux;
    (flux > 0 ? loss[j] : gain[j]) -= flux;
  });
  for (std::size_t i = 0; i < lumped.size(); ++i) {
    const double m = mass.lumped()[i];
    gain[i] = is_free[i] ? share_in_room(m * (bounds[i].largest - lumped[i]), gain[i]) : 1;
    loss[i] = is_free[i] ? share_in_room(m * (bounds[i].least - lumped[i]), loss[i]) : 1;
  }
  std::vector<double> added(lumped.size(), 0);
  for_each_flux(faces, mass, consistent, [&](Index i, Index j, double flux) {
    flux *= flux > 0 ? (std::min)(gain[i], loss[j]) : (std::min)(loss[i], gain[j]);
    added[i] += flux;
    added[j] -= flux;
  });
  for (std::size_t i = 0; i < lumped.size(); ++i)
    if (is_free[i])
      lumped[i] = bounds[i].clamp(lumped[i] + added[i] / mass.lumped()[i]);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_LIMIT_ANTIDIFFUSION_H
