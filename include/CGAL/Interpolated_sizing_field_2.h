// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_INTERPOLATED_SIZING_FIELD_2_H
#define CGAL_INTERPOLATED_SIZING_FIELD_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>
#include <CGAL/Bubble_relaxation_2/internal/core/magnitudes.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Gradient_limiter_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Sizing

A sizing field that is given by sizes at the vertices of a triangulation, such as those that an indicator of
errors asks for on the mesh of the last computation. It is linear in triangles.

Only what is marked counts, if the face base has marks and any face is marked; else all faces do, so that
the triangulation may be one that knows no constraints. Outside it is the size in the nearest point of the marked
faces, and outside of the convex hull that in the nearest point of the hull.

The triangulation is copied and may be changed or go away: `npbs_relax()` may be called on the very mesh that
the field was made of. Copies of the field share what they hold; a query takes well under a microsecond inside, and
some times as long outside: none looks at all faces, or at the whole hull. Its bits depend neither on other queries nor
on threads.

\cgalModels{BubbleSizingField_2}

\tparam Triangulation_ a 2D triangulation of \cgal, such as `Delaunay_triangulation_2` or
`Constrained_Delaunay_triangulation_2`

\sa `npbs_relax()`
\sa `Gradation_limited_sizing_field_2`
*/
template <class Triangulation_>
class Interpolated_sizing_field_2
{
  using Field = Bubble_relaxation_2::internal::Interpolated_field_2;

public:
  using Triangulation = Triangulation_;
  using FT = double; ///< the number type of sizes
  /// the point type: of a terrain, that of its plane
  using Point_2 = Bubble_relaxation_2::internal::Place_2<Triangulation>;

  /*!
  reads the sizes.

  \tparam VertexSizeMap a model of `ReadablePropertyMap` with `Triangulation::Vertex_handle` as key and a number
  as value
  \param t the triangulation
  \param sizes the wanted length of edges at each vertex of the faces that count

  \throws std::invalid_argument if the triangulation has no face, if a size is not positive and finite, if a
  coordinate is not finite or beyond the magnitudes that the manual states, or if a triangle is turned over when its
  corners are rounded to `double`
  */
  template <class VertexSizeMap>
  Interpolated_sizing_field_2(const Triangulation& t, const VertexSizeMap& sizes)
  {
    auto [tr, lengths] = read(t, sizes);
    m_field = std::make_shared<const Field>(std::move(tr), std::move(lengths));
  }

  /*!
  reads the sizes and lowers them so that they change by no more than `gradation` per unit of length.

  In each triangle the gradient of the field is at most `gradation`, up to 10<sup>-6</sup> of it. Sizes grow
  from the smaller ones, along the faces that count. In flat triangles, such as those that
  `Delaunay_triangulation_2` has along the convex hull of arbitrary points, they become smaller than needed.

  \throws std::invalid_argument as above, or if `gradation` is not positive and finite
  */
  template <class VertexSizeMap>
  Interpolated_sizing_field_2(const Triangulation& t, const VertexSizeMap& sizes, double gradation)
  {
    using namespace Bubble_relaxation_2::internal;
    check_positive("gradation", gradation);
    auto [tr, lengths] = read(t, sizes);
    Gradient_limiter_2(tr, gradation).clip(lengths);
    m_field = std::make_shared<const Field>(std::move(tr), std::move(lengths));
  }

  /// returns the size at `p`, NaN if a coordinate is not finite.
  FT operator()(const Point_2& p) const
  {
    return (*m_field)(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }

private:
  /// the triangulation, and the size at each vertex
  template <class VertexSizeMap>
  static std::pair<Bubble_relaxation_2::internal::Flat_triangulation_2, std::vector<double>>
  read(const Triangulation& t, const VertexSizeMap& sizes)
  {
    using namespace Bubble_relaxation_2::internal;
    if (t.dimension() < 2)
      throw std::invalid_argument("Bubble_relaxation_2: the triangulation of an Interpolated_sizing_field_2 has the "
                                  "dimension " + std::to_string(t.dimension()) + ", so it has no faces");
    auto flat = flatten_triangulation(t);
    check_orientations("triangulation of an Interpolated_sizing_field_2", flat.tr.points, flat.tr.vertices);
    const Faces_that_count<Triangulation> counts(t);
    for (auto f : flat.faces)
      flat.tr.inside.push_back(counts(f) ? 1 : 0);
    std::vector<double> lengths(flat.vertices.size(), 0);
    for (std::size_t f = 0; f < flat.tr.inside.size(); ++f)
      for (Index v : flat.tr.vertices[f])
        if (flat.tr.inside[f] && lengths[v] == 0)
          lengths[v] = checked_size(CGAL::to_double(get(sizes, flat.vertices[v])), flat.tr.points[v]);
    return {std::move(flat.tr), std::move(lengths)};
  }

  static double checked_size(double d, const Bubble_relaxation_2::internal::Point& p)
  {
    using namespace Bubble_relaxation_2::internal;
    if (is_within_magnitudes(d))
      return d;
    throw std::invalid_argument("Bubble_relaxation_2: parameter sizes: the size " + in_words(d) +
                                " of the vertex at " + in_words(p.x(), p.y()) +
                                " must be " + required_of_length(d));
  }

  std::shared_ptr<const Field> m_field;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_INTERPOLATED_SIZING_FIELD_2_H
