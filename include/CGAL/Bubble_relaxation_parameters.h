// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_PARAMETERS_H
#define CGAL_BUBBLE_RELAXATION_PARAMETERS_H

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_enums.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <cstddef>
#include <functional>
#include <type_traits>

/// \file
/// CGAL's class of named parameters has no hook for packages outside of CGAL. The class here derives
/// from it and has CGAL's setters and the package's, all of which return the class again. It is made by
/// reading CGAL's list of names, whatever version it is of, with other macros.

namespace CGAL {

#ifndef DOXYGEN_RUNNING

namespace internal_np {

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace internal_np

namespace Bubble_relaxation_2 {
namespace internal {

/// whether a value was given for the parameter with this tag
template <class NamedParameters, class Tag>
struct Is_given
  : std::bool_constant<!std::is_same<
      typename internal_np::Lookup_named_param_def<Tag, NamedParameters,
                                                   internal_np::Param_not_found>::type,
      internal_np::Param_not_found>::value>
{};

/// `Sequential_tag` unless the user asks for threads
template <class NamedParameters>
using Concurrency = std::decay_t<typename internal_np::Lookup_named_param_def<
  internal_np::concurrency_tag_t, NamedParameters, Sequential_tag>::type>;

/// what `grid_cells(nx, ny)` asks for, and `grid_cells(n)` with n for both
template <class Count>
struct Grid_cells_request
{
  Count nx, ny;
};

} // namespace internal
} // namespace Bubble_relaxation_2

/// A pack of named parameters with the setters of CGAL and of this package.
template <class T, class Tag, class Base = internal_np::No_property>
struct Bubble_relaxation_named_parameters : Named_function_parameters<T, Tag, Base>
{
  using Cgal_pack = Named_function_parameters<T, Tag, Base>;

  explicit Bubble_relaxation_named_parameters(const T& value) : Cgal_pack(value) {}
  Bubble_relaxation_named_parameters(const T& value, const Base& others) : Cgal_pack(value, others) {}

// what the three kinds of CGAL's parameters have in common
#define CGAL_bubble_relaxation_setter(Held, Argument, held, X, Z)                                    \
  template <class K>                                                                                 \
  Bubble_relaxation_named_parameters<Held, internal_np::X, Cgal_pack> Z(Argument k) const            \
  {                                                                                                  \
    return Bubble_relaxation_named_parameters<Held, internal_np::X, Cgal_pack>(held, *this);         \
  }
#define CGAL_add_named_parameter(X, Y, Z) CGAL_bubble_relaxation_setter(K, const K&, k, X, Z)
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)                               \
  CGAL_bubble_relaxation_setter(std::reference_wrapper<const K>, const K&, std::cref(k), X, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)                                \
  CGAL_bubble_relaxation_setter(std::reference_wrapper<K>, K&, std::ref(k), X, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#undef CGAL_bubble_relaxation_setter

  // the setter with two arguments
  template <class Count>
  auto grid_cells(const Count& nx, const Count& ny) const
  {
    return grid_cells(Bubble_relaxation_2::internal::Grid_cells_request<Count>{nx, ny});
  }
};

#endif // DOXYGEN_RUNNING

/// All names, CGAL's and the package's, to start a pack with: from here any order of setters works, see
/// \ref bgl_namedparameters.
namespace Bubble_relaxation_parameters {

#ifndef DOXYGEN_RUNNING
#define CGAL_bubble_relaxation_setter(Held, Argument, held, X, Z)                                    \
  template <class K>                                                                                 \
  Bubble_relaxation_named_parameters<Held, internal_np::X> Z(Argument k)                             \
  {                                                                                                  \
    return Bubble_relaxation_named_parameters<Held, internal_np::X>(held);                           \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_bubble_relaxation_setter

template <class Count>
auto grid_cells(const Count& nx, const Count& ny)
{
  return grid_cells(Bubble_relaxation_2::internal::Grid_cells_request<Count>{nx, ny});
}
#endif // DOXYGEN_RUNNING

/*!
\ingroup PkgBubbleRelaxation2Parameters

\brief the parameters of the paper in one go; setters that follow override them.

`integrator(Bubble_integrator::RUNGE_KUTTA_4)`, `force_coefficient(1)`, `mass(1)`, `damping(3.8429)`,
`time_step(0.02)`, `number_of_iterations(250)`, `number_of_rounds(6)`, `neighbor_radius(1.7)`,
`renewal_interval(10)`, `displacement_tolerance(0)`, `initial_placement(Bubble_placement::RHOMBIC)`,
`population_control(Bubble_population::OVERLAP_RATIO)`, `defect_treatment(false)` and
`limit_by_outline(false)`. They are in units of length and time, for sizes of a few hundredths; the renewal
interval, which the paper calls k, has no value there.
*/
inline auto npbs_paper_parameters()
{
  return integrator(Bubble_integrator::RUNGE_KUTTA_4)
    .force_coefficient(1.)
    .mass(1.)
    .damping(3.8429)
    .time_step(0.02)
    .number_of_iterations(std::size_t(250))
    .number_of_rounds(std::size_t(6))
    .neighbor_radius(1.7)
    .renewal_interval(std::size_t(10))
    .displacement_tolerance(0.)
    .initial_placement(Bubble_placement::RHOMBIC)
    .population_control(Bubble_population::OVERLAP_RATIO)
    .defect_treatment(false)
    .limit_by_outline(false);
}

} // namespace Bubble_relaxation_parameters

#ifndef DOXYGEN_RUNNING

namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z) using Bubble_relaxation_parameters::Z;
#include <CGAL/Bubble_relaxation_2/internal/core/parameters_interface.h>
#undef CGAL_add_named_parameter

using Bubble_relaxation_parameters::npbs_paper_parameters;

// CGAL's own names that functions of the package read: they start packs of CGAL's class, which lacks the package's
// setters, so there are better matches here. They are better for all arguments but constants, to which CGAL's `const K&`
// is the closest. Constants need a constraint or, in C++17, overloads for what they are: numbers, and objects of class
// templates.
#if defined(__cpp_concepts) && __cpp_concepts >= 201907L
#define CGAL_bubble_relaxation_constants(Z)                                                          \
  template <class K>                                                                                 \
    requires true                                                                                    \
  auto Z(const K& k)                                                                                 \
  {                                                                                                  \
    return Bubble_relaxation_parameters::Z(k);                                                       \
  }
#else
#define CGAL_bubble_relaxation_constant(K, Z)                                                        \
  inline auto Z(const K& k) { return Bubble_relaxation_parameters::Z(k); }
#define CGAL_bubble_relaxation_constants(Z)                                                          \
  template <template <class...> class C, class... A>                                                 \
  auto Z(const C<A...>& k)                                                                           \
  {                                                                                                  \
    return Bubble_relaxation_parameters::Z(k);                                                       \
  }                                                                                                  \
  CGAL_bubble_relaxation_constant(bool, Z)                                                           \
  CGAL_bubble_relaxation_constant(short, Z)                                                          \
  CGAL_bubble_relaxation_constant(unsigned short, Z)                                                 \
  CGAL_bubble_relaxation_constant(int, Z)                                                            \
  CGAL_bubble_relaxation_constant(unsigned int, Z)                                                   \
  CGAL_bubble_relaxation_constant(long, Z)                                                           \
  CGAL_bubble_relaxation_constant(unsigned long, Z)                                                  \
  CGAL_bubble_relaxation_constant(long long, Z)                                                      \
  CGAL_bubble_relaxation_constant(unsigned long long, Z)                                             \
  CGAL_bubble_relaxation_constant(float, Z)                                                          \
  CGAL_bubble_relaxation_constant(double, Z)
#endif
#define CGAL_bubble_relaxation_start(Z)                                                              \
  template <class K>                                                                                 \
  auto Z(K&& k)                                                                                      \
  {                                                                                                  \
    return Bubble_relaxation_parameters::Z(k);                                                       \
  }                                                                                                  \
  CGAL_bubble_relaxation_constants(Z)

CGAL_bubble_relaxation_start(callback)
CGAL_bubble_relaxation_start(neighbor_radius)
CGAL_bubble_relaxation_start(number_of_iterations)
CGAL_bubble_relaxation_start(protect_constraints)
CGAL_bubble_relaxation_start(vertex_is_constrained_map)
CGAL_bubble_relaxation_start(visitor)
#if CGAL_VERSION_NR >= 1060000000
CGAL_bubble_relaxation_start(sizing_function)
CGAL_bubble_relaxation_start(concurrency_tag)
#endif

#undef CGAL_bubble_relaxation_start
#undef CGAL_bubble_relaxation_constants
#undef CGAL_bubble_relaxation_constant

} // namespace parameters

#endif // DOXYGEN_RUNNING

using Bubble_relaxation_parameters::npbs_paper_parameters;

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_RELAXATION_PARAMETERS_H
