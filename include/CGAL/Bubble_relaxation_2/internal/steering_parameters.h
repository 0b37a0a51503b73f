// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_STEERING_PARAMETERS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_STEERING_PARAMETERS_H

#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

struct Named_value
{
  const char* name;
  double value;
};

/// The parameters on which it depends where bubbles go, once they are placed in some way, as long as they go on.
inline std::array<Named_value, 13> steering_parameters(const Relaxation_options& o)
{
  return {{{"integrator", static_cast<double>(o.integrator)},
           {"force_coefficient", o.force_coefficient},
           {"mass", o.mass},
           {"damping", o.damping},
           {"time_step", o.time_step},
           {"number_of_iterations", static_cast<double>(o.number_of_iterations)},
           {"neighbor_radius", o.neighbor_radius},
           {"renewal_interval", static_cast<double>(o.renewal_interval)},
           {"initial_placement", static_cast<double>(o.placement)},
           {"population_control", static_cast<double>(o.population)},
           {"limit_by_outline", static_cast<double>(o.limit_by_outline)},
           {"displacement_tolerance", o.displacement_tolerance},
           {"exchange_interval", static_cast<double>(o.exchange_interval)}}};
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_STEERING_PARAMETERS_H
