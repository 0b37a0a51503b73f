// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_OPTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_OPTIONS_H

#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_parameters.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// The values of the named parameters of moving least squares.
struct Mls_options
{
  Moving_least_squares_basis basis = Moving_least_squares_basis::LINEAR;
  Moving_least_squares_weight weight = Moving_least_squares_weight::QUARTIC_SPLINE;
  Deficient_support deficient_support = Deficient_support::ENLARGE;
  double maximum_condition_number = 1e4;
};

/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Mls_options read_mls_options(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Mls_options o;
  o.basis = choose_parameter(get_parameter(np, internal_np::mls_basis), o.basis);
  o.weight = choose_parameter(get_parameter(np, internal_np::mls_weight), o.weight);
  o.deficient_support = choose_parameter(get_parameter(np, internal_np::deficient_support), o.deficient_support);
  o.maximum_condition_number = choose_parameter(get_parameter(np, internal_np::maximum_condition_number),
                                                o.maximum_condition_number);
  // beyond that eigenvalues are rounding errors
  if (!(o.maximum_condition_number >= 1 && o.maximum_condition_number <= 1e14))
    throw_invalid_parameter("maximum_condition_number", o.maximum_condition_number, "between 1 and 1e14");
  return o;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_MESHLESS_MLS_OPTIONS_H
