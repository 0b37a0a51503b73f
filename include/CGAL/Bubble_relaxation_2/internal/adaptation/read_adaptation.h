// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_READ_ADAPTATION_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_READ_ADAPTATION_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Misfit_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Default_adaptation_visitor_2.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// the options of a relaxation, with its threads
template <class NamedParameters>
Relaxation_options read_local_options(const NamedParameters& np)
{
  Relaxation_options options = read_options(np);
  options.progress = std::make_shared<Progress>(read_callback(np));
  options.threads = threads_of<Concurrency<NamedParameters>>();
  return options;
}

/// when a face does not fit, as the user says
template <class NamedParameters>
Misfit_criteria read_misfit_criteria(const NamedParameters& np)
{
  Misfit_criteria c;
  take(np, internal_np::longest_edge, c.longest_edge);
  take(np, internal_np::shortest_edge, c.shortest_edge);
  take(np, internal_np::misfit_angle, c.misfit_angle);
  take(np, internal_np::misfit_quality, c.misfit_quality);
  take_count(np, internal_np::number_of_rings, "number_of_rings", c.number_of_rings, 0, 1000000);
  if (!(c.longest_edge > 1))
    throw_invalid_parameter("longest_edge", c.longest_edge, "greater than 1");
  if (!(c.shortest_edge >= 0 && c.shortest_edge < 1))
    throw_invalid_parameter("shortest_edge", c.shortest_edge, "not negative and less than 1");
  if (!(c.misfit_angle >= 0 && c.misfit_angle <= 33))
    throw_invalid_parameter("misfit_angle", c.misfit_angle, "0 to 33 degrees");
  if (!(c.misfit_quality >= 0 && c.misfit_quality <= 0.9))
    throw_invalid_parameter("misfit_quality", c.misfit_quality, "0 to 0.9");
  return c;
}

/// whether a visitor can be told of parts that are meshed anew
template <class Visitor, class Cdt, class = void>
struct Is_told_of_parts : std::false_type {};

template <class Visitor, class Cdt>
struct Is_told_of_parts<Visitor, Cdt, std::void_t<decltype(std::declval<Visitor&>().before_change(
                                        std::declval<const std::vector<typename Cdt::Face_handle>&>(),
                                        std::declval<const std::vector<typename Cdt::Vertex_handle>&>()))>>
  : std::true_type
{};

/// a copy of the user's visitor, or a reference to it if that was given
template <class Cdt, class NamedParameters>
decltype(auto) visitor_of([[maybe_unused]] const NamedParameters& np)
{
  using Visitor = Value_of<NamedParameters, internal_np::visitor_t>;
  static_assert(is_missing<Visitor> || Is_told_of_parts<Visitor, Cdt>::value,
                "visitor must be a model of BubbleAdaptationVisitor_2 here, such as Default_adaptation_visitor_2");
  if constexpr (Is_told_of_parts<Visitor, Cdt>::value)
    return parameters::get_parameter(np, internal_np::visitor);
  else
    return Default_adaptation_visitor_2<Cdt>();
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_READ_ADAPTATION_H
