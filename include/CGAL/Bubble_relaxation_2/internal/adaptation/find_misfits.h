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
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Neighborhood_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_check_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/Sizes_of_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/read_adaptation.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
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

/// Squares around faces in which sizes are known if the outline in squares next to them is: where the size is d, none
/// farther than d / g counts; and a part that is found begins at these faces, and has some rings more.
template <class Cdt>
Grid_squares_2 squares_around(const std::vector<typename Cdt::Face_handle>& faces, const Sizes_2& wanted, double growth)
{
  constexpr double rings = 5;
  double largest = 0, longest = 0;
  std::vector<Bbox_2> boxes;
  for (typename Cdt::Face_handle f : faces) {
    tick(boxes.size());
    const std::array<Point, 3> p = corners_in_double<Cdt>(f);
    boxes.push_back(CGAL::bbox_2(p.begin(), p.end()));
    longest = (std::max)({longest, boxes.back().x_span(), boxes.back().y_span()});
    largest = (std::max)(largest, wanted(*std::min_element(p.begin(), p.end())));
  }
  return Grid_squares_2(boxes, (std::max)(longest, (std::max)(rings, 1 + 1 / growth) * largest)).with_neighbors();
}

/// faces of a triangulation, and sizes by which a part with them is to be meshed
template <class Cdt>
using Faces_and_sizes = std::pair<std::vector<typename Cdt::Face_handle>, std::optional<Sizes_2>>;

/// The faces of a triangulation that do not fit sizes, and the sizes by which a relaxation of the whole would cut its
/// corners off.
/// \throws std::invalid_argument if no face is of the domain
template <class Cdt, class Is_inside, class NamedParameters>
Faces_and_sizes<Cdt> find_misfits(const Cdt& cdt, const Is_inside& is_in_domain, const Relaxation_options& options,
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
  const Sizes_2 wanted = *given_sizes<Place_2<Cdt>>(np);
  const auto search_by_outline = [&](const Part_growth_2<Cdt, Is_inside>* where) -> Faces_and_sizes<Cdt> {
    const Sizes_of_outline_2<Cdt, Is_inside> outline(cdt, is_in_domain, np, wanted, options, where);
    Misfit_search_2<Cdt, Is_inside> search(cdt, is_in_domain, outline.sizes(), wanted, criteria,
                                           outline.forced_places());
    return {search(faces), outline.sizes_of_parts()};
  };
  if constexpr (Is_given<NamedParameters, internal_np::faces_to_check_t>::value) {
    if (faces.empty())
      return {};
    auto around = faces;
    for (int attempt = 0; attempt < 2; ++attempt) { // a part may go on beyond them
      const Grid_squares_2 known = squares_around<Cdt>(around, wanted, options.size_growth);
      const auto near = neighborhood(cdt, is_in_domain, around, known.with_neighbors());
      const Faces_and_sizes<Cdt> found = search_by_outline(&near);
      if (std::all_of(found.first.begin(), found.first.end(), [&](auto f) { return known.cover(box_of<Cdt>(f)); }))
        return found;
      around.insert(around.end(), found.first.begin(), found.first.end());
    }
  }
  return search_by_outline(nullptr);
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_FIND_MISFITS_H
