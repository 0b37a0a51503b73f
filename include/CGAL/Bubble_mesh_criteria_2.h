// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_MESH_CRITERIA_2_H
#define CGAL_BUBBLE_MESH_CRITERIA_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Checked_sizing_field_2.h>

#include <CGAL/Mesh_2/Face_badness.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Ref

Criteria for CGAL's Delaunay refinement that make a mesh as fine as a sizing field asks: the same d drives
`refine_Delaunay_mesh_2()` and `npbs_relax()`.

A triangle is too large if its longest edge exceeds `size_factor` times d in its centroid, and badly shaped
if the square of the sine of its smallest angle is less than the shape bound.

\cgalModels{MeshingCriteria_2}

\tparam CDT a constrained Delaunay triangulation
\tparam SizingField_ a model of `BubbleSizingField_2`
*/
template <class CDT, class SizingField_>
class Bubble_mesh_criteria_2
{
  using Plane = Bubble_relaxation_2::internal::Plane_2<CDT>;
  using Point_2 = typename Plane::Place;
  using Checked_sizing =
    Bubble_relaxation_2::internal::Checked_sizing_field_2<Point_2, const SizingField_&>;

public:
  using SizingField = SizingField_;
  using Face_handle = typename CDT::Face_handle;

  /// The longest edge over d that a triangle may have. Refinement stops well below its bound; with this
  /// one the mean of edge length over d is about 1 (the tests ask for 1 within 0.08).
  static constexpr double size_factor = 1.45;

  /// how bad a triangle is
  struct Quality
  {
    double size = 0;         ///< square of the longest edge over the allowed one; too large if above 1
    double squared_sine = 1; ///< of the smallest angle

    /// whether this triangle is to be refined before the other: large ones first
    bool operator<(const Quality& q) const
    {
      if (size > 1 || q.size > 1)
        return size > q.size;
      return squared_sine < q.squared_sine;
    }
  };

  /// decides whether a triangle is to be refined
  class Is_bad
  {
  public:
    Is_bad(std::shared_ptr<const SizingField> sizing, double shape_bound)
      : m_sizing(std::move(sizing)), m_shape_bound(shape_bound)
    {}

    Mesh_2::Face_badness operator()(const Quality& q) const
    {
      if (q.size > 1)
        return Mesh_2::IMPERATIVELY_BAD;
      return q.squared_sine < m_shape_bound ? Mesh_2::BAD : Mesh_2::NOT_BAD;
    }

    /// also sets the quality of the triangle
    /// \throws std::invalid_argument where the size is not positive and finite
    Mesh_2::Face_badness operator()(Face_handle f, Quality& q) const
    {
      double x[3], y[3], squared[3];
      for (int i = 0; i < 3; ++i) {
        x[i] = CGAL::to_double(Plane::x(f->vertex(i)->point()));
        y[i] = CGAL::to_double(Plane::y(f->vertex(i)->point()));
      }
      for (int i = 0; i < 3; ++i) {
        const double dx = x[(i + 2) % 3] - x[(i + 1) % 3], dy = y[(i + 2) % 3] - y[(i + 1) % 3];
        squared[i] = dx * dx + dy * dy;
      }
      std::sort(squared, squared + 3);
      const double d =
        Checked_sizing(*m_sizing)(x[0] + ((x[1] - x[0]) + (x[2] - x[0])) / 3,
                                 y[0] + ((y[1] - y[0]) + (y[2] - y[0])) / 3);
      const double twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
      q.size = squared[2] / (size_factor * size_factor * d * d);
      q.squared_sine = twice_area * twice_area / (squared[1] * squared[2]);
      return (*this)(q);
    }

  private:
    std::shared_ptr<const SizingField> m_sizing;
    double m_shape_bound;
  };

  /// \param sizing the wanted length of edges
  /// \param shape_bound the square of the sine of the smallest allowed angle; refinement is known to end
  /// for 0.125, about 20.7 degrees, or less
  explicit Bubble_mesh_criteria_2(SizingField sizing, double shape_bound = 0.125)
    : m_sizing(std::make_shared<const SizingField>(std::move(sizing))), m_shape_bound(shape_bound)
  {}

  /// the predicate that the mesher calls
  Is_bad is_bad_object() const { return Is_bad(m_sizing, m_shape_bound); }

private:
  // shared, since a lambda cannot be assigned, and the mesher assigns its criteria
  std::shared_ptr<const SizingField> m_sizing;
  double m_shape_bound;
};

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief returns the criteria of a sizing field, whose type need not be named.
*/
template <class CDT, class SizingField>
Bubble_mesh_criteria_2<CDT, SizingField> make_bubble_mesh_criteria_2(const CDT&, SizingField sizing,
                                                                     double shape_bound = 0.125)
{
  return Bubble_mesh_criteria_2<CDT, SizingField>(std::move(sizing), shape_bound);
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_BUBBLE_MESH_CRITERIA_2_H
