// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/input/hash_of_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/distributed/mpi/Communicator.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

inline Parameter_value parameter_value(const char* name, double value)
{
  value += 0.; // there is a negative zero
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return Parameter_value{name, bits, [](std::uint64_t b) {
                           double v;
                           std::memcpy(&v, &b, sizeof(v));
                           return in_words(v);
                         }};
}

inline Parameter_value parameter_value(const char* name, std::size_t value)
{
  return Parameter_value{name, value, [](std::uint64_t v) { return std::to_string(v); }};
}

inline Parameter_value parameter_value(const char* name, bool value)
{
  return Parameter_value{name, value, [](std::uint64_t v) { return std::string(v != 0 ? "true" : "false"); }};
}

inline Parameter_value parameter_value(const char* name, Bubble_integrator value)
{
  return Parameter_value{name, static_cast<std::uint64_t>(value), [](std::uint64_t v) {
                           const char* const names[] = {"RUNGE_KUTTA_4", "SEMI_IMPLICIT_EULER"};
                           return std::string(names[v]);
                         }};
}

inline Parameter_value parameter_value(const char* name, Bubble_population value)
{
  return Parameter_value{name, static_cast<std::uint64_t>(value), [](std::uint64_t v) {
                           const char* const names[] = {"NONE", "OVERLAP_RATIO", "DELAUNAY"};
                           return std::string(names[v]);
                         }};
}

/// `is_given`: whether the user chose it
inline Parameter_value parameter_value(const char* name, Bubble_placement value, bool is_given)
{
  return Parameter_value{name, is_given ? static_cast<std::uint64_t>(value) : 3, [](std::uint64_t v) {
                           const char* const names[] = {"KEEP", "RHOMBIC", "FRONTAL", "the default"};
                           return std::string(names[v]);
                         }};
}

/// Collective. Callbacks need not be the same, nor be there on all ranks.
/// \throws std::invalid_argument on all ranks if another parameter is not the same on all
inline void check_same_options(const Communicator& comm, const Relaxation_options& o)
{
  check_same_values(comm, {
    parameter_value("integrator", o.integrator), // other defaults depend on it
    parameter_value("initial_placement", o.placement, o.placement_is_given),
    parameter_value("population_control", o.population),
    parameter_value("number_of_rounds", o.number_of_rounds),
    parameter_value("number_of_iterations", o.number_of_iterations),
    parameter_value("displacement_tolerance", o.displacement_tolerance),
    parameter_value("force_coefficient", o.force_coefficient),
    parameter_value("mass", o.mass),
    parameter_value("damping", o.damping),
    parameter_value("time_step", o.time_step),
    parameter_value("neighbor_radius", o.neighbor_radius),
    parameter_value("renewal_interval", o.renewal_interval),
    parameter_value("defect_treatment", o.defect_treatment),
    parameter_value("limit_by_outline", o.limit_by_outline),
    parameter_value("maximum_number_of_bubbles", o.maximum_number_of_bubbles),
    parameter_value("exchange_interval", o.exchange_interval)});
}

/// What the user's callback throws on one rank stops all. It is kept until all ranks can throw it.
inline std::function<bool(double)> agreed_callback(const std::function<bool(double)>& callback, Agreement& agreement)
{
  if (!callback)
    return callback;
  return [callback, &agreement](double progress) {
    bool goes_on = false;
    agreement.keep([&] { goes_on = callback(progress); });
    return goes_on;
  };
}

/// The user's d on one of several ranks. What it throws is kept until all ranks can throw it; until then d is `large`,
/// so that little is done in vain.
inline Sizes_2 agreed_sizes(const Sizes_2& users, Agreement& agreement, double large)
{
  Sizes_2 result([users, &agreement, large](double x, double y) {
    double d = large;
    if (!agreement.has_failed())
      agreement.keep([&] { d = users(x, y); });
    return d;
  });
  result.expected_number = users.expected_number;
  return result;
}

/// A function cannot be compared, but how many bubbles it asks for in the domain.
inline Parameter_value sizing_function_value(double expected_number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &expected_number, sizeof(bits));
  return Parameter_value{"sizing_function", bits, [](std::uint64_t b) {
                           double number;
                           std::memcpy(&number, &b, sizeof(number));
                           return "one that asks for " + in_words(number) + " bubbles";
                         }};
}

/// Collective. What `Input_2` reads, the same on all ranks; the callback need not be the same, nor be there on all.
/// \throws std::invalid_argument on all ranks if a parameter is out of its range on any rank, or if one has no domain,
/// telling which; and if parameters, the domain, or how many bubbles the sizing functions ask for are not the same
template <class Cdt, class NamedParameters>
std::unique_ptr<Input_2<Cdt>> read_same_input(const Cdt& cdt, const NamedParameters& np, const Communicator& comm,
                                              Agreement& agreement)
{
  std::unique_ptr<Input_2<Cdt>> input;
  agreement.reach_after([&] {
    try {
      input = std::make_unique<Input_2<Cdt>>(cdt, np);
    } catch (const std::invalid_argument& e) {
      throw std::invalid_argument(std::string(e.what()) + " (on rank " + std::to_string(comm.rank()) + ")");
    }
  });
  check_same_options(comm, input->options);
  check_same_domain(comm, input->reading.domain);
  check_same_vertices(comm, input->reading.given);
  check_same_values(comm, {sizing_function_value(input->sizes.expected_number)});
  agreement.reach_after([&] { input->options.callback = agreed_callback(input->options.callback, agreement); });
  return input;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DISTRIBUTED_INPUT_READ_SAME_INPUT_H
