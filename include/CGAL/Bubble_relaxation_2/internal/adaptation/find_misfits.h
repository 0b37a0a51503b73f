// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FIND_MISFITS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FIND_MISFITS_H

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Misfit_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_check_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Sizes_of_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/read_adaptation.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The domain of a triangulation whose faces have no marks is found as by a relaxation, in a copy.
template <class Cdt, class NamedParameters>
auto domain_of(const Cdt& cdt, [[maybe_unused]] const NamedParameters& np)
{
  if constexpr (Has_domain_mark<typename Cdt::Face>::value)
    return Is_in_domain<Cdt>{cdt};
  else
    return Domain_marks_2<Cdt>(cdt, np);
}

/// the faces among which the user has misfits looked for: all, or those that are given
template <class Cdt, class Is_inside, class NamedParameters>
auto faces_to_check(const Cdt& cdt, [[maybe_unused]] const Is_inside& is_in_domain,
                    [[maybe_unused]] const NamedParameters& np)
{
  if constexpr (Is_given<NamedParameters, internal_np::faces_to_check_t>::value)
    return Part_check_2<Cdt>(cdt, "faces_to_check")(
      parameters::get_parameter_reference(np, internal_np::faces_to_check), is_in_domain, /* may_be_none = */ true);
  else
    return cdt.finite_face_handles();
}

/// The faces of a triangulation that do not fit sizes, and the sizes by which a relaxation of the whole would cut its
/// corners off.
/// \throws std::invalid_argument if no face is of the domain
template <class Cdt, class Is_inside, class NamedParameters>
std::pair<std::vector<typename Cdt::Face_handle>, std::optional<Sizes_2>>
find_misfits(const Cdt& cdt, const Is_inside& is_in_domain, const Relaxation_options& options,
             const NamedParameters& np)
{
  static_assert(Is_given<NamedParameters, internal_np::sizing_function_t>::value,
                "sizing_function is needed to find out where a mesh does not fit it");
  const Misfit_criteria criteria = read_misfit_criteria(np);
  const auto all = cdt.finite_face_handles();
  if (std::none_of(all.begin(), all.end(), [&](auto f) { return is_in_domain(f); }))
    throw std::invalid_argument("Bubble_relaxation_2: no face of the triangulation is marked as one of the domain; "
                                "npbs_relax() marks them");
  const auto faces = faces_to_check(cdt, is_in_domain, np);
  const Sizes_of_outline_2<Cdt> outline(cdt, is_in_domain, np, *given_sizes<Place_2<Cdt>>(np), options);
  Misfit_search_2<Cdt, Is_inside> search(cdt, is_in_domain, outline.sizes(), criteria, outline.forced_places());
  return {search(faces), outline.sizes_of_parts()};
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FIND_MISFITS_H
