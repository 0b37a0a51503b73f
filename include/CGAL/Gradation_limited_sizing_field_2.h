// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_GRADATION_LIMITED_SIZING_FIELD_2_H
#define CGAL_GRADATION_LIMITED_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Background_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Gradient_limiter_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

A sizing field that grows slowly: the largest field below a given d that changes by no more than a gradation
g per unit of length, h(x) = min<sub>y</sub> d(y) + g |x - y|.

Where d is small h is d, and from there it grows as fast as g allows. |x - y| is the length of the way within
the domain: a small size does not reach through a hole or across a bay, but through inner constraints, since
meshes of both of their sides share vertices.

The field is computed once, on a triangulation of the domain, and is linear in its triangles. d is not needed
any more then. Copies share the triangulation; a query takes well under a microsecond
inside, and some times as long outside.

- <b>Guaranteed:</b> in each triangle the gradient of h is at most g, up to 10<sup>-6</sup> of it; at the
  vertices of the triangulation h is at most d; h is at least the least d that was found.
- <b>Approximate:</b> h is less than the largest field possible, so that the guarantee holds: where g limits it
  it grows by 0.9 g, and in places, behind sharp dips and in flat triangles at narrow corners of the domain, by
  up to 25 % less. The triangulation is refined until h differs in the middle of an edge from its linear
  interpolation by no more than 5 %, or until the edge is no longer than h. So h may exceed d between the
  vertices by some percent, and by more where d changes much within a length of h.
- <b>What can be missed:</b> d is seen at all vertices of the triangulation, constrained or not, on constraints
  at least in each 128th, inside at least in each 32nd of the domain's extent, and finer where what was seen
  there asks for it. A dip of d that fits between is not found. A vertex inserted in the middle of it helps.
- <b>Cost:</b> that of the triangulation: where d is small in hundreds of points it takes several times as long as the
  mesh. If there is a mesh that follows d, `Interpolated_sizing_field_2` limits the sizes
  of its vertices far faster.

The values are the same to the last bit for the same domain, in whatever order it was made, in whatever order
and by however many threads the field is asked.

\cgalModels{BubbleSizingField_2}

\tparam CDT_ a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one

\sa `npbs_relax()`
\sa `Interpolated_sizing_field_2`
*/
template <class CDT_>
class Gradation_limited_sizing_field_2
{
  using Field = Bubble_relaxation_2::internal::Interpolated_field_2;

public:
  using CDT = CDT_;
  using FT = double; ///< the number type of sizes
  /// the point type: of a terrain, that of its plane
  using Point_2 = Bubble_relaxation_2::internal::Place_2<CDT>;

  /*!
  limits the sizes that are given, or by default those that `npbs_relax()` would use. What `npbs_relax()` does by its
  parameter `limit_by_outline` comes later, and grows by 0.2 per unit of length.

  \param cdt the domain, as for `npbs_relax()`
  \param gradation g, the most that h changes per unit of length, positive; 0.1 to 0.3 is usual
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `sizing_function`, `seeds`,
  `seeds_are_in_domain`, `vertex_is_constrained_map` and `edge_marker_map` as for `npbs_relax()`, with the same
  defaults, and

  \cgalNamedParamsBegin
    \cgalParamNBegin{maximum_number_of_vertices}
      \cgalParamDescription{the most vertices of the triangulation that holds the field, if those of `cdt` are not more}
      \cgalParamType{an integer, positive}
      \cgalParamDefault{200 000}
    \cgalParamNEnd
    \cgalParamNBegin{callback}
      \cgalParamDescription{a function that is called after each turn of refinement, and several times a second in
                            between, with how much is done, not falling, 1 at the end. If it returns `false` before
                            there is no other call: the field is as good as it is by then, with its gradient limited,
                            and `is_resolved()` is `false`}
      \cgalParamType{a type that `std::function<bool(double)>` can hold}
      \cgalParamDefault{none}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws std::invalid_argument if a parameter is out of its range, if a coordinate or a size is not finite,
  if a size is not positive, or if there is no domain with constraints all around it
  */
  template <class NamedParameters = parameters::Default_named_parameters>
  Gradation_limited_sizing_field_2(const CDT& cdt, double gradation,
                                   const NamedParameters& np = parameters::default_values())
    : m_gradation(gradation)
  {
    using namespace Bubble_relaxation_2::internal;
    check_positive("gradation", gradation);
    const std::size_t maximum = read_count(
      "maximum_number_of_vertices",
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::maximum_number_of_vertices),
                                   std::size_t(200000)), 1,
      static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()));
    Progress progress(read_callback(np));
    progress.remember_stop(); // there is to be a field
    const Progress_scope scope(progress);
    const Domain_marks_2<CDT> is_inside(cdt, np);
    const Domain_reading_2<CDT> reading(cdt, is_inside, is_pinned<CDT>(np), Said_of_constraints<NamedParameters>{np});
    const Sizes_2 sizes = wanted_sizes(np, is_inside, reading);
    // every vertex of the user's is a place to look at d: none is taken as a mere split of a constraint
    const Domain_reading_2<CDT> all(
      cdt, is_inside, [](typename CDT::Vertex_handle) { return true; }, [](const auto&...) {});
    Background_mesh_2 background(all.domain, all.given.pinned, sizes, m_gradation / margin, maximum);
    m_is_resolved = background.build(progress);
    Marked_triangulation_2& mesh = background.mesh();
    Gradient_limiter_2(mesh, m_gradation).clip(background.sizes());
    m_field = std::make_shared<const Field>(std::move(mesh), std::move(background.sizes()));
    m_is_resolved = m_is_resolved && !progress.is_stopped();
    progress.finish();
  }

  /// returns h at `p`. Outside of the domain it is the one in the nearest point of the domain's boundary, and
  /// outside of the convex hull the one at the nearest point of the hull.
  FT operator()(const Point_2& p) const
  {
    return (*m_field)(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }

  /// returns g.
  double gradation() const { return m_gradation; }

  /// returns the number of vertices of the triangulation that holds the field.
  std::size_t number_of_vertices() const { return m_field->triangulation().points.size(); }

  /// returns whether the triangulation could be refined as far as d asked, and not only as far as
  /// `maximum_number_of_vertices`, the rounding of coordinates or the callback allowed. Also if not, the gradient is
  /// limited.
  bool is_resolved() const { return m_is_resolved; }

private:
  /// Fronts are interpolated with a gradient that is some percent too large here and there. To cut it off there
  /// takes more, from all that lies behind, than to let sizes grow by a little less from the start.
  static constexpr double margin = 1.1;

  double m_gradation;
  bool m_is_resolved = false;
  std::shared_ptr<const Field> m_field;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_GRADATION_LIMITED_SIZING_FIELD_2_H
