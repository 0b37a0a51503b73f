// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_READ_SIZES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_READ_SIZES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Checked_sizing_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Sizing_field_ref_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/expected_number_of_bubbles.h>

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Calls `use(sizing)` with the sizing field of the named parameters: the user's function, checked, or by
/// default that of the mesh that is there, or else what the outline asks for.
template <class Cdt, class NamedParameters, class Use>
void with_sizing_field(const Cdt& cdt, const NamedParameters& np, const Domain_marks_2<Cdt>& marks,
                       const Domain_reading_2<Cdt>& reading, const Use& use)
{
  using Point_2 = typename Cdt::Geom_traits::Point_2;
  if constexpr (!Is_given<NamedParameters, internal_np::sizing_function_t>::value) {
    if (reading.free.empty()) { // no mesh yet
      const Outline_field_2 field = outline_field(reading);
      use(Sizing_field_ref_2(field));
    } else {
      const Interpolated_field_2 field = mean_edge_length_field(cdt, marks);
      use(Sizing_field_ref_2(field));
    }
  } else {
    const auto& f = parameters::get_parameter_reference(np, internal_np::sizing_function);
    const auto field = checked_sizing_field<Point_2>(f);
    use(Sizing_field_ref_2(field));
  }
}

/// Calls `use(sizing, wanted)` with the sizing field of the named parameters, `wanted`, and with the one that
/// the simulation follows: it is smaller where the outline is too fine or the domain too narrow for what the
/// user wants. Both have been checked for the number of bubbles that they ask for.
template <class Cdt, class NamedParameters, class Use>
void with_limited_sizing_field(const Cdt& cdt, const NamedParameters& np,
                               const Domain_marks_2<Cdt>& marks, const Domain_reading_2<Cdt>& reading,
                               const Relaxation_options& options, const Use& use)
{
  constexpr bool is_given = Is_given<NamedParameters, internal_np::sizing_function_t>::value;
  with_sizing_field(cdt, np, marks, reading, [&](const Sizing_field_ref_2& wanted) {
    const std::size_t maximum = options.maximum_number_of_bubbles;
    const Counted_sizing_field_2 counted_wanted = counted(
      reading.domain, wanted, maximum, "the domain and the sizing function");
    std::vector<Size_source_2> sources;
    if (is_given && options.limit_by_outline)
      sources = Outline_sizes_2<Cdt>(reading, &wanted)();
    if (sources.empty()) {
      use(counted_wanted, wanted);
      return;
    }
    const Outline_field_2 limit(sources, reading.domain.bbox());
    const Smaller_of_2 smaller(&wanted, &limit);
    use(counted(reading.domain, Sizing_field_ref_2(smaller), maximum,
                "the sizing function and the fine parts of the outline (limit_by_outline)"),
        wanted);
  });
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

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_SIZES_READ_SIZES_H
