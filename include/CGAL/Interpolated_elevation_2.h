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
#include <CGAL/Bubble_relaxation_2/internal/geometry/Side_search_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/linear_values.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Terrain

The elevation of the surface that a triangulation of points in space is, linear in its faces: what `npbs_relax()` gives
new vertices by default. Who meshes a terrain many times gives it those of a copy of the first one as
`elevation_function`, so that no surface is interpolated from one that was.

Beyond the convex hull it is the elevation at the nearest point of the hull. Its sides are read at the first call there.

It refers to the triangulation, which must stay as it is as long as it is asked. A call begins where the last one ended,
so it is fast if places follow each other that are near, but what it returns does not depend on calls before; a copy can
be asked by another thread.

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

  /// returns the elevation at `p`, NaN if a coordinate is not finite. At a vertex it is that of its point, else it is
  /// computed in `double`.
  FT operator()(const Point_2& p) const
  {
    const Place q(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    if constexpr (std::numeric_limits<FT>::has_quiet_NaN) // numbers of exact kernels are finite
      if (!std::isfinite(q.x()) || !std::isfinite(q.y()))
        return std::numeric_limits<FT>::quiet_NaN();
    typename Triangulation::Locate_type where{};
    int i = 0;
    const Face_handle f = m_terrain->locate(Plane::point(p.x(), p.y(), FT(0)), where, i, m_near);
    m_near = f;
    if (where == Triangulation::VERTEX)
      return Plane::elevation(f->vertex(i)->point());
    if (m_terrain->is_infinite(f))
      return FT(beyond_hull(q));
    using namespace Bubble_relaxation_2::internal;
    if (where == Triangulation::EDGE) { // exactly, which it need not be in `double`
      const auto ends = sorted(std::array<Corner, 2>{corner(f->vertex(f->ccw(i))), corner(f->vertex(f->cw(i)))});
      return FT(value_on_side(ends[0], ends[1], q));
    }
    return FT(value_in_triangle(sorted(std::array<Corner, 3>{corner(f->vertex(0)), corner(f->vertex(1)),
                                                             corner(f->vertex(2))}), q));
  }

private:
  using Place = Bubble_relaxation_2::internal::Point;
  using Corner = Bubble_relaxation_2::internal::Valued_corner_2;
  using Hull = Bubble_relaxation_2::internal::Side_search_2;
  using Vertex_handle = typename Triangulation::Vertex_handle;

  static Corner corner(Vertex_handle v)
  {
    const auto& p = v->point();
    return {Bubble_relaxation_2::internal::point_in_double<Triangulation>(p), CGAL::to_double(Plane::elevation(p)), 0};
  }

  static bool is_before(const Corner& a, const Corner& b) { return a.point < b.point; }

  /// bits depend on the order, and that of a face on how it came about
  template <std::size_t n>
  static std::array<Corner, n> sorted(std::array<Corner, n> c)
  {
    std::sort(c.begin(), c.end(), is_before);
    for (std::size_t k = 0; k < n; ++k)
      c[k].rank = static_cast<Bubble_relaxation_2::internal::Index>(k);
    return c;
  }

  double beyond_hull(const Place& q) const
  {
    if (m_hull == nullptr)
      m_hull = std::make_shared<const Hull>(sides_of_hull());
    return m_hull->value(Bubble_relaxation_2::internal::within_reach(q));
  }

  /// in the order of their first ends, so that it does not matter how the triangulation came about
  std::vector<typename Hull::Side> sides_of_hull() const
  {
    std::vector<typename Hull::Side> sides;
    std::vector<Corner> corners;
    auto f = m_terrain->incident_faces(m_terrain->infinite_vertex()), first = f;
    do {
      const int i = f->index(m_terrain->infinite_vertex());
      sides.emplace_back(corner(f->vertex(Triangulation::cw(i))), corner(f->vertex(Triangulation::ccw(i))));
      corners.push_back(sides.back().first);
    } while (++f != first);
    std::sort(corners.begin(), corners.end(), is_before);
    for (auto& side : sides)
      for (Corner* c : {&side.first, &side.second})
        c->rank = static_cast<Bubble_relaxation_2::internal::Index>(
          std::lower_bound(corners.begin(), corners.end(), *c, is_before) - corners.begin());
    std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first.rank < b.first.rank; });
    return sides;
  }

  const Triangulation* m_terrain;
  mutable Face_handle m_near;
  mutable std::shared_ptr<const Hull> m_hull; // none as long as nobody asked beyond it
};

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_INTERPOLATED_ELEVATION_2_H
