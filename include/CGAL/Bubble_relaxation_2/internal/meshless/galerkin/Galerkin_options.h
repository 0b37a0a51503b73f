// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_OPTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_OPTIONS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>

#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The values of the named parameters of the element-free Galerkin method, checked.
struct Galerkin_options
{
  Moving_least_squares_basis basis = Moving_least_squares_basis::LINEAR;
  double support_factor = 2.5;
  double support_radius = 0;   ///< 0: by the factor
  Dirichlet_condition dirichlet = Dirichlet_condition::NITSCHE;
  double penalty_factor = 0;   ///< 0: by the sizes of the nodes
  double nitsche_factor = 30;
  Integration_cells cells = Integration_cells::TRIANGLES;
  std::size_t nx = 0, ny = 0;  ///< of the grid; 0: by the sizes of the nodes
  std::size_t gauss_points = 0;
  bool consistent = true;
  double residual_tolerance = 1e-12;
  std::function<bool(double)> callback;

  bool is_quadratic() const { return basis == Moving_least_squares_basis::QUADRATIC; }
};

template <class T>
struct Is_grid_cells_request : std::false_type {};
template <class Count>
struct Is_grid_cells_request<Grid_cells_request<Count>> : std::true_type {};

template <class NamedParameters>
void read_grid_cells(const NamedParameters& np, Galerkin_options& o)
{
  if constexpr (Is_given<NamedParameters, internal_np::grid_cells_t>::value) {
    constexpr std::size_t most = 100000;
    const auto given = parameters::get_parameter(np, internal_np::grid_cells);
    if constexpr (Is_grid_cells_request<std::decay_t<decltype(given)>>::value) {
      o.nx = read_count("grid_cells", given.nx, 1, most);
      o.ny = read_count("grid_cells", given.ny, 1, most);
    } else {
      o.nx = o.ny = read_count("grid_cells", given, 1, most);
    }
  }
}

/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Galerkin_options read_galerkin_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Galerkin_options o;
  o.basis = choose_parameter(get_parameter(np, internal_np::mls_basis), o.basis);
  o.support_factor = choose_parameter(get_parameter(np, internal_np::support_factor), o.support_factor);
  check_positive("support_factor", o.support_factor);
  if constexpr (Is_given<NamedParameters, internal_np::support_radius_t>::value) {
    o.support_radius = get_parameter(np, internal_np::support_radius);
    check_positive("support_radius", o.support_radius);
  }
  o.dirichlet = choose_parameter(get_parameter(np, internal_np::dirichlet_condition), o.dirichlet);
  if constexpr (Is_given<NamedParameters, internal_np::penalty_factor_t>::value) {
    o.penalty_factor = get_parameter(np, internal_np::penalty_factor);
    check_positive("penalty_factor", o.penalty_factor);
  }
  o.nitsche_factor = choose_parameter(get_parameter(np, internal_np::nitsche_factor), o.nitsche_factor);
  check_positive("nitsche_factor", o.nitsche_factor);
  o.cells = choose_parameter(get_parameter(np, internal_np::integration_cells), o.cells);
  read_grid_cells(np, o);
  // The quadratic basis has order 3 in L2 with 5; with 4 integrals limit it where d is about 0.01 of the domain. More
  // points than 64 gain nothing, and in a rule of hundreds their number is the cells' likely one
  o.gauss_points = read_count("number_of_gauss_points",
                              choose_parameter(get_parameter(np, internal_np::number_of_gauss_points),
                                               std::size_t(o.is_quadratic() ? 5 : 3)), 1, 64);
  o.consistent = choose_parameter(get_parameter(np, internal_np::consistent_integration), o.consistent);
  o.residual_tolerance =
    choose_parameter(get_parameter(np, internal_np::residual_tolerance), o.residual_tolerance);
  check_positive("residual_tolerance", o.residual_tolerance);
  o.callback = choose_parameter(get_parameter(np, internal_np::callback), o.callback);
  return o;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_GALERKIN_GALERKIN_OPTIONS_H
