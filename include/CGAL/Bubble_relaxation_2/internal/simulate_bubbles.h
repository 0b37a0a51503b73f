// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H

#include <CGAL/Bubble_relaxation_2/internal/Checked_sizing_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Outline_sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Sizing_field_ref_2.h>
#include <CGAL/Bubble_relaxation_2/internal/expected_number_of_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/relax.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Calls `use(sizing, wanted)` with the size that the user wants, and with what is smaller where the outline
/// is too fine or the domain too narrow for it.
template <class Cdt, class Use>
void with_outline_limit(const Domain_reading_2<Cdt>& reading, const Relaxation_options& options,
                        const Sizing_field_ref_2& wanted, const Use& use)
{
  const Counted_sizing_field_2 counted_wanted =
    counted(reading.domain, wanted, options.maximum_number_of_bubbles);
  std::vector<Size_source_2> sources;
  if (options.limit_by_outline)
    sources = Outline_sizes_2<Cdt>(reading, &wanted)();
  if (sources.empty()) {
    use(counted_wanted, wanted);
    return;
  }
  const Outline_field_2 limit(sources, reading.domain.bbox());
  const Smaller_of_2 smaller(&wanted, &limit);
  use(counted(reading.domain, Sizing_field_ref_2(smaller), options.maximum_number_of_bubbles), wanted);
}

/// Calls `use(sizing, wanted)` with the sizing field that the simulation follows and the one that the named
/// parameters want: the user's function, checked, or by default that of the mesh that is there, or else what
/// the outline asks for.
template <class Cdt, class NamedParameters, class Use>
void with_sizing_field(const Cdt& cdt, const NamedParameters& np, const Domain_marks_2<Cdt>& marks,
                       const Domain_reading_2<Cdt>& reading, const Relaxation_options& options,
                       const Use& use)
{
  const auto use_as_it_is = [&](const Sizing_field_ref_2& sizing) {
    use(counted(reading.domain, sizing, options.maximum_number_of_bubbles), sizing);
  };
  using Point_2 = typename Cdt::Geom_traits::Point_2;
  if constexpr (!Is_given<NamedParameters, internal_np::sizing_function_t>::value) {
    if (reading.free.empty()) { // no mesh yet
      const Outline_field_2 field = outline_field(reading);
      use_as_it_is(Sizing_field_ref_2(field));
    } else {
      const Interpolated_field_2 field = mean_edge_length_field(cdt, marks);
      use_as_it_is(Sizing_field_ref_2(field));
    }
  } else {
    const auto& f = parameters::get_parameter_reference(np, internal_np::sizing_function);
    const Checked_sizing_field_2<Point_2, std::decay_t<decltype(f)>> field(f);
    with_outline_limit(reading, options, Sizing_field_ref_2(field), use);
  }
}

/// Reads the domain with what the user pinned.
template <class Cdt, class NamedParameters>
std::unique_ptr<Domain_reading_2<Cdt>> read_domain(const Cdt& cdt, const NamedParameters& np,
                                                   const Domain_marks_2<Cdt>& marks)
{
  using Vertex_handle = typename Cdt::Vertex_handle;
  const auto pinned = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::vertex_is_constrained),
    Static_boolean_property_map<Vertex_handle, false>());
  return std::make_unique<Domain_reading_2<Cdt>>(
    cdt, marks, [&pinned](Vertex_handle v) { return static_cast<bool>(get(pinned, v)); });
}

/// The whole method without the triangulation: initial bubbles, simulation, population.
template <class Concurrency_tag, class Cdt, class Sizing, class Report>
Bubbles_2 simulate_bubbles(const Cdt& cdt, const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                           const Relaxation_options& options, Progress& progress, Report& report)
{
  Bubbles_2 bubbles;
  {
    const Phase_timer timer(report.seconds.placement);
    bubbles = place_bubbles<Concurrency_tag>(cdt, reading, sizing, options);
    report.number_of_initial_bubbles = bubbles.size();
  }
  if (options.integrator == Bubble_integrator::RUNGE_KUTTA_4)
    relax<Concurrency_tag, Runge_kutta_4<Concurrency_tag>>(reading.domain, sizing, options, bubbles,
                                                           progress, report);
  else
    relax<Concurrency_tag, Semi_implicit_euler<Concurrency_tag>>(reading.domain, sizing, options,
                                                                 bubbles, progress, report);
  return bubbles;
}

/// `Sequential_tag` unless the user asks for threads
template <class NamedParameters>
using Concurrency = std::decay_t<typename internal_np::Lookup_named_param_def<
  internal_np::concurrency_tag_t, NamedParameters, Sequential_tag>::type>;

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIMULATE_BUBBLES_H
