// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_INTERPOLATED_ELEVATION_2_H
#define CGAL_INTERPOLATED_ELEVATION_2_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Terrain

The elevation of the surface that a triangulation of points in space is, linear in its faces: what `npbs_relax()` gives
new vertices by default. Who meshes a terrain many times gives it those of a copy of the first one as
`elevation_function`, so that no surface is interpolated from one that was.

Beyond the convex hull it is the elevation at the nearest point of a side of the hull that is seen from there.

It refers to the triangulation, which must stay as it is as long as it is asked. A call begins where the last one ended,
so it is fast if places follow each other that are near; a copy can be asked by another thread.

\tparam Triangulation_ a 2D triangulation of \cgal with `Projection_traits_xy_3`, `Projection_traits_yz_3` or
`Projection_traits_xz_3`, such as `Constrained_Delaunay_triangulation_2`

\sa `npbs_relax()`
*/
template <class Triangulation_>
class Interpolated_elevation_2
{
  using Plane = Bubble_relaxation_2::internal::Plane_2<Triangulation_>;
  static_assert(Plane::has_elevation,
                "Interpolated_elevation_2 needs a triangulation with Projection_traits_xy_3, Projection_traits_yz_3 or "
                "Projection_traits_xz_3");

public:
  using Triangulation = Triangulation_;
  using FT = typename Triangulation::Geom_traits::FT; ///< the number type of elevations
  using Point_2 = typename Plane::Place;              ///< the type of points in the plane of the projection

  using Face_handle = typename Triangulation::Face_handle;

  /// `terrain` is referred to. `near` is a face of it where the first call begins; by default, an empty handle, that is
  /// where `Triangulation::locate()` begins without a hint
  /// \throws std::invalid_argument if the triangulation has no face
  explicit Interpolated_elevation_2(const Triangulation& terrain, Face_handle near = Face_handle())
    : m_terrain(&terrain), m_near(near)
  {
    if (terrain.dimension() < 2)
      throw std::invalid_argument("Bubble_relaxation_2: the triangulation of an Interpolated_elevation_2 has no faces");
  }

  /// returns the elevation at `p`. At a vertex it is that of its point, else it is computed in `double`.
  FT operator()(const Point_2& p) const
  {
    typename Triangulation::Locate_type where{};
    int i = 0;
    const Face_handle f = m_terrain->locate(Plane::point(p.x(), p.y(), FT(0)), where, i, m_near);
    m_near = f;
    if (where == Triangulation::VERTEX)
      return Plane::elevation(f->vertex(i)->point());
    const Place q(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    if (m_terrain->is_infinite(f))
      i = f->index(m_terrain->infinite_vertex());
    else if (where == Triangulation::FACE)
      return FT(in_triangle({corner(f, 0), corner(f, 1), corner(f, 2)}, q));
    return FT(on_side(corner(f, Triangulation::ccw(i)), corner(f, Triangulation::cw(i)), q));
  }

private:
  using Place = Bubble_relaxation_2::internal::Point;

  struct Corner
  {
    Place place;
    double elevation;

    bool operator<(const Corner& other) const { return place < other.place; }
  };

  static Corner corner(Face_handle f, int i)
  {
    const auto& p = f->vertex(i)->point();
    return {Bubble_relaxation_2::internal::point_in_double<Triangulation>(p), CGAL::to_double(Plane::elevation(p))};
  }

  /// Corners are sorted, since bits depend on the order of a sum, and that of a face on how it came about.
  static double in_triangle(std::array<Corner, 3> c, const Place& q)
  {
    std::sort(c.begin(), c.end());
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Place &a = c[(i + 1) % 3].place, &b = c[(i + 2) % 3].place;
      const double weight = std::abs((a.x() - q.x()) * (b.y() - q.y()) - (a.y() - q.y()) * (b.x() - q.x()));
      sum += weight * c[i].elevation;
      weights += weight;
    }
    return weights > 0 ? sum / weights : on_side(c[0], c[2], q); // too thin for double
  }

  static double on_side(Corner a, Corner b, const Place& q)
  {
    if (b < a)
      std::swap(a, b);
    const auto side = b.place - a.place;
    const double s = (std::max)(0., (std::min)(1., (q - a.place) * side / side.squared_length()));
    return (1 - s) * a.elevation + s * b.elevation;
  }

  const Triangulation* m_terrain;
  mutable Face_handle m_near;
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_INTERPOLATED_ELEVATION_2_H
