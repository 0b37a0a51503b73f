// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_RELAXATION_OPTIONS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_RELAXATION_OPTIONS_H

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

constexpr std::size_t default_number_of_iterations = 30;
constexpr std::size_t default_number_of_rounds = 10;
constexpr std::size_t default_maximum_number_of_bubbles = 100000000;
constexpr double default_displacement_tolerance = 0.0085;
constexpr double default_size_growth = 0.2;
constexpr double default_minimum_angle = 30; // degrees
constexpr double largest_neighbor_radius = 100; // sets have 4 times the square of it as members

/// The values of the named parameters that steer the simulation, checked.
struct Relaxation_options
{
  Bubble_integrator integrator = Bubble_integrator::SEMI_IMPLICIT_EULER;
  double force_coefficient = 1;
  double mass = 1;
  double damping = 0.6;
  double time_step = 0.6;
  std::size_t number_of_iterations = default_number_of_iterations;
  std::size_t number_of_rounds = default_number_of_rounds;
  double neighbor_radius = 1.7;
  std::size_t renewal_interval = 0;
  bool placement_is_given = false;
  Bubble_placement placement = Bubble_placement::FRONTAL;
  Bubble_population population = Bubble_population::DELAUNAY;
  bool defect_treatment = true;
  bool limit_by_outline = true;
  double size_growth = default_size_growth;
  double minimum_angle = default_minimum_angle; ///< in degrees
  double displacement_tolerance = default_displacement_tolerance;
  std::size_t maximum_number_of_bubbles = default_maximum_number_of_bubbles;
  bool counts_bubbles = true; ///< that sizes ask for, which calls them often
  bool restore_when_stopped = false;
  std::shared_ptr<Progress> progress = std::make_shared<Progress>(); ///< copies of the options tell the same
  Threads threads;
  std::size_t exchange_interval = 0;
};

[[noreturn]] inline void throw_invalid_parameter(const std::string& name, const std::string& value,
                                                 const std::string& requirement)
{
  throw std::invalid_argument("Bubble_relaxation_2: parameter " + name + " = " + value + " must be " + requirement);
}

[[noreturn]] inline void throw_invalid_parameter(const std::string& name, double value, const std::string& requirement)
{
  throw_invalid_parameter(name, in_words(value), requirement);
}

inline void check_positive(const char* name, double value)
{
  if (!(value > 0) || !std::isfinite(value))
    throw_invalid_parameter(name, value, "positive and finite");
}

inline void check_not_negative(const char* name, double value)
{
  if (!(value >= 0) || !std::isfinite(value))
    throw_invalid_parameter(name, value, "finite and not negative");
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_RELAXATION_OPTIONS_H
