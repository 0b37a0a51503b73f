// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_MESH_QUALITY_2_H
#define CGAL_MESH_QUALITY_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Checked_sizing_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/Mesh_quality_accumulator_2.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/radius_ratio_2.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

Statistics of a triangle mesh: the radius ratio q = 2 r_in / r_out of the triangles (eq. 11 of the
paper), their angles, the degrees of the vertices, and the lengths of the edges over the wanted length d.
It is made by `mesh_quality_2()`.

\tparam FT_ number type
*/
template <class FT_>
class Mesh_quality_2
{
public:
  using FT = FT_;

  /// number of bars of the histogram
  static constexpr std::size_t number_of_bars = Bubble_relaxation_2::internal::number_of_quality_bars;

  /// the statistics of no triangle at all
  Mesh_quality_2() = default;

  /// the same statistics in another number type
  template <class Other_FT>
  explicit Mesh_quality_2(const Mesh_quality_2<Other_FT>& other) : m(other.m)
  {}

#ifndef DOXYGEN_RUNNING
  explicit Mesh_quality_2(Bubble_relaxation_2::internal::Mesh_statistics_2 statistics)
    : m(statistics)
  {}

  const Bubble_relaxation_2::internal::Mesh_statistics_2& statistics() const { return m; }
#endif

  /// \name Size
  /// @{
  std::size_t number_of_vertices() const { return m.vertices; }   ///< vertices of the mesh
  std::size_t number_of_triangles() const { return m.triangles; } ///< triangles of the mesh
  /// @}

  /// \name Radius Ratio
  /// q of the triangles, between 0 (degenerate) and 1 (equilateral)
  /// @{
  FT minimum_quality() const { return FT(m.minimum_quality); } ///< the smallest q
  FT mean_quality() const { return FT(m.mean_quality); }       ///< the mean of q over all triangles

  /// the quality that `percent` of the triangles do not exceed
  /// \param percent one of 1, 5, 10, 25, 50, 75, 90
  /// \throws std::invalid_argument for other values
  FT quality_percentile(int percent) const
  {
    using namespace Bubble_relaxation_2::internal;
    for (std::size_t k = 0; k < quality_percents.size(); ++k)
      if (quality_percents[k] == percent)
        return FT(m.quality_percentiles[k]);
    throw std::invalid_argument("Mesh_quality_2: parameter percent = " + std::to_string(percent) +
                                " must be 1, 5, 10, 25, 50, 75 or 90");
  }

  /// numbers of triangles with q in [0, 0.05), [0.05, 0.1), ..., [0.95, 1]
  const std::array<std::size_t, number_of_bars>& histogram() const { return m.histogram; }

  /// the x coordinate of the centroid of the triangle with the smallest q
  FT worst_x() const { return FT(m.worst_x); }
  /// the y coordinate of the centroid of the triangle with the smallest q
  FT worst_y() const { return FT(m.worst_y); }
  /// @}

  /// \name Angles
  /// in degrees
  /// @{
  FT minimum_angle() const { return FT(m.minimum_angle); } ///< the smallest angle of all triangles
  FT maximum_angle() const { return FT(m.maximum_angle); } ///< the largest angle of all triangles
  /// triangles with an angle of more than 90 degrees and a rounding (10<sup>-12</sup>). A triangle with q > 2 (sqrt 2 - 1) = 0.8284 has none
  std::size_t number_of_obtuse_triangles() const { return m.obtuse; }
  /// whether no triangle is right-angled or obtuse, so that each contains its circumcentre
  bool is_well_centered() const { return number_of_triangles() > 0 && m.maximum_angle < 90; }
  /// @}

  /// \name Degrees
  /// A vertex is interior if no edge of the domain's boundary and no constraint ends in it.
  /// @{
  std::size_t number_of_interior_vertices() const { return m.interior; } ///< interior vertices
  /// the share of interior vertices with other than six neighbours; 0 if there is no interior vertex
  FT irregular_share() const
  {
    return m.interior == 0 ? FT(0) : FT(double(m.irregular) / double(m.interior));
  }
  /// @}

  /// \name Edge Lengths
  /// How long the edges of triangles are, in units of length.
  /// @{
  FT shortest_edge() const { return FT(m.shortest_edge); } ///< the length of the shortest edge
  FT longest_edge() const { return FT(m.longest_edge); }   ///< the length of the longest edge
  /// @}

  /// \name Edge Lengths over d
  /// The length of each edge over the wanted length d in its midpoint; not a number if no sizing
  /// function was given. In a report d is what the mesh follows: smaller where the outline asks for it, and as large as
  /// the rim of a part makes it.
  /// @{
  bool has_length_ratios() const { return m.has_lengths; }      ///< whether a sizing function was given
  FT mean_length_ratio() const { return FT(m.mean_length); }    ///< the mean of all edges
  FT length_ratio_deviation() const { return FT(m.deviation); } ///< the standard deviation
  /// the ratio that `percent` of the edges do not exceed
  /// \param percent 1 or 99
  /// \throws std::invalid_argument for other values
  FT length_ratio_percentile(int percent) const
  {
    if (percent != 1 && percent != 99)
      throw std::invalid_argument("Mesh_quality_2: parameter percent = " + std::to_string(percent) +
                                  " must be 1 or 99");
    return FT(percent == 1 ? m.length_percentile_1 : m.length_percentile_99);
  }
  /// @}

private:
  template <class>
  friend class Mesh_quality_2;

  Bubble_relaxation_2::internal::Mesh_statistics_2 m;
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief returns the statistics of the triangles of a domain.

\tparam CDT a `Constrained_Delaunay_triangulation_2` or a `Constrained_triangulation_plus_2` of one
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_function}
    \cgalParamDescription{the wanted length d of edges, in the units of the coordinates}
    \cgalParamType{a model of `BubbleSizingField_2`, or a number that converts to the kernel's `FT`}
    \cgalParamDefault{none: there are no length ratios}
  \cgalParamNEnd
  \cgalParamNBegin{seeds}
    \cgalParamDescription{points in the holes of the domain, or in the domain}
    \cgalParamType{a range of points}
    \cgalParamDefault{none: the domain are the faces that are marked as such, or else the faces in an odd
                      number of outlines}
  \cgalParamNEnd
  \cgalParamNBegin{seeds_are_in_domain}
    \cgalParamDescription{whether the seeds lie in the domain}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument if the triangulation has no domain, if an edge around the domain is not
constrained, if a coordinate is not finite or beyond the magnitudes that the manual states, if a seed tells no region,
or if a size is not positive and finite
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto mesh_quality_2(const CDT& cdt, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using FT = typename Quality_number<typename CDT::Geom_traits>::type;
  const Domain_marks_2<CDT> domain(cdt, np);
  const Flat_triangulation_2& tr = domain.tr;
  Mesh_quality_accumulator_2 accumulator;
  for (std::size_t t = 0; t < tr.number_of_triangles(); ++t) {
    const Index f = static_cast<Index>(t);
    if (domain.is_inside(f))
      accumulator.add_triangle(tr.point(f, 0), tr.point(f, 1), tr.point(f, 2));
  }
  add_vertices(
    tr, tr.points.size(), [&](Index t, int i) { return domain.is_constrained(t, i); },
    [](std::size_t) { return true; }, accumulator);
  if constexpr (Is_given<NamedParameters, internal_np::sizing_function_t>::value) {
    const auto& f = parameters::get_parameter_reference(np, internal_np::sizing_function);
    const auto sizing = checked_sizing_field<Place_2<CDT>>(f);
    for_each_edge(tr, 0, tr.number_of_triangles(), [&](Index t, int i) {
      add_length(tr.point(t, ccw(i)), tr.point(t, cw(i)), sizing, accumulator);
    });
  }
  return Mesh_quality_2<FT>(accumulator.statistics());
}

namespace Bubble_relaxation_2::internal {

CGAL_BUBBLE_RELAXATION_2_INLINE
void print_mesh_quality(std::ostream& out, const Mesh_quality_2<double>& quality);

} // namespace Bubble_relaxation_2::internal

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief prints the statistics as a table, with a histogram of the radius ratio.
*/
template <class FT>
std::ostream& operator<<(std::ostream& out, const Mesh_quality_2<FT>& quality)
{
  Bubble_relaxation_2::internal::print_mesh_quality(out, Mesh_quality_2<double>(quality));
  return out;
}

} // namespace CGAL

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/quality/print_mesh_quality_impl.h>
#endif

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_MESH_QUALITY_2_H
