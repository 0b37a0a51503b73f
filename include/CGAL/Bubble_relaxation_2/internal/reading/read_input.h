// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_INPUT_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_INPUT_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Checked_sizing_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Said_of_constraints.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/Tags_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/elevations.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Default_relaxation_visitor_2.h>
#include <CGAL/property_map.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

/// whether the user pinned a vertex, as a function object
template <class Cdt, class NamedParameters>
auto is_pinned(const NamedParameters& np)
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  const auto pinned = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::vertex_is_constrained),
    Static_boolean_property_map<Vertex_handle, false>());
  return [pinned](Vertex_handle v) { return static_cast<bool>(get(pinned, v)); };
}

/// the user's sizing function, checked, if there is one
template <class User_point, class NamedParameters>
std::optional<Sizes_2> given_sizes([[maybe_unused]] const NamedParameters& np)
{
  if constexpr (Is_given<NamedParameters, internal_np::sizing_function_t>::value)
    return Sizes_2(
      checked_sizing_field<User_point>(parameters::get_parameter_reference(np, internal_np::sizing_function)));
  else
    return std::nullopt;
}

/// The sizes that the user wants: the sizing function, or by default those of the mesh that is there, or else what the
/// outline asks for; larger beside longer constraints that stay as they are.
template <class Cdt, class NamedParameters>
Sizes_2 wanted_sizes(const NamedParameters& np, const Domain_marks_2<Cdt>& marks,
                     const Domain_reading_2<Cdt>& reading)
{
  const std::optional<Sizes_2> sizes = given_sizes<Place_2<Cdt>>(np);
  if (!sizes && !reading.free.empty())
    return sizes_of_mesh(marks);
  double growth = default_size_growth;
  take(np, internal_np::size_growth, growth);
  return no_finer_than_edges(reading.domain, reading.given,
                             sizes ? *sizes : sizes_of_domain(reading.domain, reading.given, growth), growth);
}

/// A visitor of the user's, or a reference to one.
template <class Visitor>
class Observer_of : public Observer
{
public:
  explicit Observer_of(const Visitor& visitor) : m_visitor(visitor) {}

  void phase_begins(Bubble_phase phase) override { unwrapped(m_visitor).phase_begins(phase); }
  void step_ends(const Bubbles_2& b) override { unwrapped(m_visitor).step_ends(Bubble_view_2(b)); }
  void round_ends(const Bubble_relaxation_report_2<double>& r) override { unwrapped(m_visitor).round_ends(r); }

private:
  Visitor m_visitor;
};

/// whether a visitor can be told of phases
template <class Visitor, class = void>
struct Is_told_of_phases : std::false_type {};

template <class Visitor>
struct Is_told_of_phases<Visitor, std::void_t<decltype(std::declval<Visitor&>().phase_begins(Bubble_phase()))>>
  : std::true_type
{};

/// whom a relaxation tells how far it is: the user's callback and visitor
template <class NamedParameters>
std::shared_ptr<Progress> read_progress(const NamedParameters& np)
{
  using Visitor = Value_of<NamedParameters, internal_np::visitor_t>;
  static_assert(is_missing<Visitor> || Is_told_of_phases<Visitor>::value,
                "visitor must be a model of BubbleRelaxationVisitor_2 here, such as Default_relaxation_visitor_2");
  std::unique_ptr<Observer> observer;
  if constexpr (Is_told_of_phases<Visitor>::value) {
    auto visitor = parameters::get_parameter(np, internal_np::visitor); // a copy of it, or of a reference to it
    observer = std::make_unique<Observer_of<decltype(visitor)>>(visitor);
  }
  return std::make_shared<Progress>(read_callback(np), std::move(observer));
}

/// What all entry points begin with. It refers to the user's vertices and parameters.
template <class Cdt>
struct Input_2
{
  Relaxation_options options;
  Domain_reading_2<Cdt> reading;
  Sizes_2 wanted; ///< by the user
  Limits_of_outline_2 limits;
  Elevation_function<Cdt> elevation; ///< by the user

  /// `progress`: whom the stages shall tell how far they are
  // in braces, since options are to be checked before the triangulation
  template <class NamedParameters>
  Input_2(const Cdt& cdt, const NamedParameters& np, const std::shared_ptr<Progress>& progress)
    : Input_2{np, cdt, telling(progress, read_options(np)), Domain_marks_2<Cdt>(cdt, np)}
  {}

  Problem_2 problem() const
  {
    return Problem_2{limits.cut ? *limits.domain : reading.domain, reading.given, options, wanted, limits.sizes,
                     limits.cut.get(), &reading.domain};
  }

private:
  template <class NamedParameters>
  static constexpr bool has_sizing_function = Is_given<NamedParameters, internal_np::sizing_function_t>::value;

  static Relaxation_options telling(const std::shared_ptr<Progress>& progress, Relaxation_options options)
  {
    options.progress = progress;
    progress->start_phase(Bubble_phase::READING);
    return options;
  }

  template <class NamedParameters>
  Input_2(const NamedParameters& np, const Cdt& cdt, const Relaxation_options& o, const Domain_marks_2<Cdt>& marks)
    : options(o), reading(cdt, marks, is_pinned<Cdt>(np), Said_of_constraints<NamedParameters>{np}),
      wanted(wanted_sizes(np, marks, reading)),
      limits(limit_by_outline(reading.domain, reading.given, wanted, options,
                              options.limit_by_outline &&
                                (reading.free.empty() || has_sizing_function<NamedParameters>))),
      elevation(given_elevation<Cdt>(np))
  {
    check_regions<Cdt>(np, marks);
    reading.find_pins_outside(is_pinned<Cdt>(np));
    options.threads = threads_of<Concurrency<NamedParameters>>();
    if (!options.placement_is_given) // then what fits of a mesh is kept
      reading.look_around(marks);
  }
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_READING_READ_INPUT_H
