// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_OUTLINE_LIMITED_SIZING_FIELD_2_H
#define CGAL_OUTLINE_LIMITED_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/number_utils.h>

#include <memory>
#include <optional>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

The sizes that `npbs_relax()` follows: d, smaller where the outline is finer or the domain narrower, and larger beside
constraints that are protected and far longer.

It tells before a mesh is made how fine it will be, and how many vertices it will have, and gives its sizes to
whatever comes after it: radii of influence, error bounds, other meshers.

The field is read from the domain once, which takes a small part of the time of meshing, and does not refer to the
triangulation. It keeps copies of the parameters, so a sizing function that was given by `std::ref` must live as long.
Copies share what was read.

\cgalModels{BubbleSizingField_2}

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one

\sa `npbs_relax()`
\sa `Gradation_limited_sizing_field_2`
*/
template <class CDT_>
class Outline_limited_sizing_field_2
{
public:
  using CDT = CDT_;
  using FT = double; ///< the number type of sizes
  /// the point type: of a terrain, that of its plane
  using Point_2 = Bubble_relaxation_2::internal::Place_2<CDT>;

  /*!
  reads the domain.

  \param cdt the domain, as for `npbs_relax()`
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `npbs_relax()` with the same
  defaults, or a size alone, a number or a function of points. What tells sizes, the domain and what stays of it counts, and
  `maximum_number_of_bubbles`; the callback and the visitor are not called

  \throws as `npbs_relax()` does before it places bubbles, such as `std::invalid_argument` if a parameter is out of its
  range or there is no domain, and `std::length_error` if sizes ask for too many vertices
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Outline_limited_sizing_field_2(const CDT& cdt, const NamedParameters& np = parameters::default_values())
    : m_sizes(*read_sizes(cdt, np))
  {}

  /// returns the size at `p`. Outside of the domain it means nothing.
  FT operator()(const Point_2& p) const { return m_sizes(CGAL::to_double(p.x()), CGAL::to_double(p.y())); }

  /// returns about how many vertices a mesh of the domain has that follows these sizes.
  double number_of_vertices() const { return m_sizes.expected_number; }

private:
  using Sizes = Bubble_relaxation_2::internal::Sizes_2;

  template <class NamedParameters>
  static std::optional<Sizes> read_sizes(const CDT& cdt, const NamedParameters& np)
  {
    using namespace Bubble_relaxation_2::internal;
    return call_checked<CDT, std::optional<Sizes>>(np, [&cdt](const auto& pack) {
      const auto kept = std::make_shared<const std::decay_t<decltype(pack)>>(pack); // sizes refer to it
      const Input_2<CDT> input(cdt, *kept, std::make_shared<Progress>());
      Sizes result([kept, followed = input.limits.sizes](double x, double y) { return followed(x, y); });
      result.expected_number = input.limits.sizes.expected_number;
      return std::make_optional(result);
    });
  }

  Sizes m_sizes;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_OUTLINE_LIMITED_SIZING_FIELD_2_H
