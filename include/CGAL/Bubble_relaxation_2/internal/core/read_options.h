// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_READ_OPTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_READ_OPTIONS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Bubble_relaxation_2::internal {

/// A count given as any number. A negative one would turn into a huge unsigned one silently, and what a
/// floating-point number that is no integer turns into is not defined.
template <class T>
std::size_t read_count(const char* name, T value, std::size_t least,
                       std::size_t largest = (std::numeric_limits<std::size_t>::max)())
{
  static_assert(std::is_arithmetic<T>::value, "a count must be given as a number");
  std::string text;
  if constexpr (std::is_floating_point<T>::value) {
    text = in_words(static_cast<double>(value));
    if (!(std::abs(value) < T(1e18)) || value != std::floor(value))
      throw_invalid_parameter(name, text, "an integer");
  } else {
    text = std::to_string(value);
  }
  bool is_negative = false;
  if constexpr (std::is_signed<T>::value)
    is_negative = value < 0;
  if (is_negative || static_cast<std::size_t>(value) < least)
    throw_invalid_parameter(name, text, "at least " + std::to_string(least));
  if (static_cast<std::size_t>(value) > largest)
    throw_invalid_parameter(name, text, "at most " + std::to_string(largest));
  return static_cast<std::size_t>(value);
}

/// Takes the value of a parameter if there is one.
template <class NamedParameters, class Tag, class T>
void take(const NamedParameters& np, Tag tag, T& value)
{
  if constexpr (Is_given<NamedParameters, Tag>::value)
    value = parameters::get_parameter(np, tag);
}

template <class NamedParameters, class Tag>
void take_count(const NamedParameters& np, Tag tag, const char* name, std::size_t& value, std::size_t least,
                std::size_t largest = (std::numeric_limits<std::size_t>::max)())
{
  if constexpr (Is_given<NamedParameters, Tag>::value)
    value = read_count(name, parameters::get_parameter(np, tag), least, largest);
}

template <class NamedParameters>
void take_maximum_number_of_bubbles(const NamedParameters& np, std::size_t& value)
{
  take_count(np, internal_np::maximum_number_of_bubbles, "maximum_number_of_bubbles", value, 1,
             static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()));
}

/// Checks the coefficients of eq. 3. The default integrator has them in units of the size, where none beyond has a
/// sense; but their products with lengths could overflow in one unit of length and not in another.
inline void check_motion(const Relaxation_options& o)
{
  constexpr double least = 1e-12, most = 1e12;
  const auto check = [&o](const char* name, double value) {
    check_positive(name, value);
    if (o.integrator == Bubble_integrator::SEMI_IMPLICIT_EULER && !(value >= least && value <= most))
      throw_invalid_parameter(name, value, "at least " + in_words(least) + " and at most " + in_words(most));
  };
  check("force_coefficient", o.force_coefficient);
  check("mass", o.mass);
  check("time_step", o.time_step);
  check_not_negative("damping", o.damping);
  if (o.damping > 0)
    check("damping", o.damping);
}

/// \throws std::invalid_argument naming the parameter and its value
inline void check_options(const Relaxation_options& o)
{
  check_motion(o);
  check_not_negative("displacement_tolerance", o.displacement_tolerance);
  if (!(o.size_growth > 0 && o.size_growth <= 1))
    throw_invalid_parameter("size_growth", o.size_growth, "positive and at most 1");
  if (!(o.minimum_angle >= 0 && o.minimum_angle <= 33))
    throw_invalid_parameter("minimum_angle", o.minimum_angle, "0 to 33 degrees: beyond, refinement would hardly end");
  if (!(o.neighbor_radius > 1.5 && o.neighbor_radius <= largest_neighbor_radius))
    throw_invalid_parameter("neighbor_radius", o.neighbor_radius,
                            "greater than 1.5, where the force ends, and at most " + in_words(largest_neighbor_radius));
}

/// the user's callback, if there is any
template <class NamedParameters>
std::function<bool(double)> read_callback(const NamedParameters& np)
{
  std::function<bool(double)> callback;
  take(np, internal_np::callback, callback);
  return callback;
}

/// Reads the named parameters that steer the simulation. Defaults of the time step and the damping
/// depend on the integrator: the paper's are in length units, those of the default in units of d.
/// \throws std::invalid_argument naming the parameter and its value
template <class NamedParameters>
Relaxation_options read_options(const NamedParameters& np)
{
  Relaxation_options o;
  take(np, internal_np::integrator, o.integrator);
  if (o.integrator == Bubble_integrator::RUNGE_KUTTA_4) {
    o.damping = 3.8429;
    o.time_step = 0.02;
    o.displacement_tolerance = 1e-3;
  }
  take(np, internal_np::force_coefficient, o.force_coefficient);
  take(np, internal_np::mass, o.mass);
  take(np, internal_np::damping, o.damping);
  take(np, internal_np::time_step, o.time_step);
  take_count(np, internal_np::number_of_iterations, "number_of_iterations", o.number_of_iterations, 0);
  take_count(np, internal_np::number_of_rounds, "number_of_rounds", o.number_of_rounds, 0);
  take(np, internal_np::neighbor_radius, o.neighbor_radius);
  take_count(np, internal_np::renewal_interval, "renewal_interval", o.renewal_interval, 0);
  o.placement_is_given = Is_given<NamedParameters, internal_np::initial_placement_t>::value;
  take(np, internal_np::initial_placement, o.placement);
  take(np, internal_np::population_control, o.population);
  take(np, internal_np::defect_treatment, o.defect_treatment);
  take(np, internal_np::limit_by_outline, o.limit_by_outline);
  take(np, internal_np::size_growth, o.size_growth);
  take(np, internal_np::minimum_angle, o.minimum_angle);
  take(np, internal_np::displacement_tolerance, o.displacement_tolerance);
  take_maximum_number_of_bubbles(np, o.maximum_number_of_bubbles);
  take(np, internal_np::restore_when_stopped, o.restore_when_stopped);
  take_count(np, internal_np::exchange_interval, "exchange_interval", o.exchange_interval, 0);
  check_options(o);
  return o;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_READ_OPTIONS_H
