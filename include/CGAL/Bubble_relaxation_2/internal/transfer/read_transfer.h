// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_TRANSFER_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_TRANSFER_H

#include <CGAL/Bubble_relaxation_2/internal/transfer/Transfer_problem_2.h>

#include <CGAL/Bubble_relaxation_parameters.h>

#include <type_traits>

namespace CGAL::Bubble_relaxation_2::internal {

/// The value of `transfer_method`; those of vertices and of faces are different types.
template <class NamedParameters, class Method>
Method read_transfer_method([[maybe_unused]] const NamedParameters& np, Method by_default)
{
  if constexpr (Is_given<NamedParameters, internal_np::transfer_method_t>::value) {
    const auto method = parameters::get_parameter(np, internal_np::transfer_method);
    static_assert(std::is_same<std::decay_t<decltype(method)>, Method>::value,
                  "transfer_method is a Vertex_transfer for values at vertices, a Face_transfer for values of faces");
    return method;
  } else {
    return by_default;
  }
}

/// Two meshes and what the parameters say of them, without values.
template <class NamedParameters>
Transfer_problem_2 read_transfer(const Face_set_2& source, const Face_set_2& target,
                                 [[maybe_unused]] const NamedParameters& np)
{
  Transfer_problem_2 problem;
  problem.source = source;
  problem.target = target;
  if constexpr (Is_given<NamedParameters, internal_np::keep_integral_t>::value)
    problem.keeps_integral = parameters::get_parameter(np, internal_np::keep_integral);
  return problem;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_READ_TRANSFER_H
