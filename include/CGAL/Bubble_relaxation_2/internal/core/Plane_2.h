// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PLANE_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PLANE_2_H

#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL {

template <class R>
class Projection_traits_xy_3;
template <class R>
class Projection_traits_yz_3;
template <class R>
class Projection_traits_xz_3;

namespace Bubble_relaxation_2::internal {

/// Where points are seen that lie in the plane.
template <class Traits>
struct Flat_plane_2
{
  static constexpr bool has_elevation = false;

  using Point = typename Traits::Point_2; ///< of the triangulation
  using Place = Point;                    ///< in the plane

  template <class P> // it may have a weight
  static decltype(auto) x(const P& p)
  {
    return p.x();
  }

  template <class P>
  static decltype(auto) y(const P& p)
  {
    return p.y();
  }

  static const Place& place(const Point& p) { return p; }

  /// the point at a place. `N`: doubles, or numbers of the kernel
  template <class N, class Elevation>
  static Point point(const N& x, const N& y, const Elevation&)
  {
    return Point(x, y);
  }
};

/// Where points in space are seen along an axis. On it they have an elevation, which a triangulation does not look at.
template <class R, int axis>
struct Terrain_plane_2
{
  static constexpr bool has_elevation = true;

  using FT = typename R::FT;
  using Point = typename R::Point_3;
  using Place = typename R::Point_2;

  static decltype(auto) x(const Point& p) { return p.cartesian(axis == 0 ? 1 : 0); }
  static decltype(auto) y(const Point& p) { return p.cartesian(axis == 2 ? 1 : 2); }
  static decltype(auto) elevation(const Point& p) { return p.cartesian(axis); }
  static Place place(const Point& p) { return Place(x(p), y(p)); }

  template <class N>
  static Point point(const N& u, const N& v, const FT& elevation)
  {
    if constexpr (axis == 0)
      return Point(elevation, FT(u), FT(v));
    else if constexpr (axis == 1)
      return Point(FT(u), elevation, FT(v));
    else
      return Point(FT(u), FT(v), elevation);
  }
};

/// also for traits that are derived from those of projections
struct Plane_choice_2
{
  template <class R>
  static Terrain_plane_2<R, 0> plane(const Projection_traits_yz_3<R>*);
  template <class R>
  static Terrain_plane_2<R, 1> plane(const Projection_traits_xz_3<R>*);
  template <class R>
  static Terrain_plane_2<R, 2> plane(const Projection_traits_xy_3<R>*);
  static void plane(const void*);
};

/// The plane in which a triangulation is one.
template <class Triangulation, class Traits = typename Triangulation::Geom_traits,
          class Chosen = decltype(Plane_choice_2::plane(static_cast<const Traits*>(nullptr)))>
using Plane_2 = std::conditional_t<std::is_void<Chosen>::value, Flat_plane_2<Traits>, Chosen>;

/// a point in the plane of a triangulation, as the user's functions take it
template <class Triangulation>
using Place_2 = typename Plane_2<Triangulation>::Place;

/// the elevation at a place of the plane of a triangulation, empty if the user gave none
template <class Triangulation>
using Elevation_function = std::function<typename Triangulation::Geom_traits::FT(const Place_2<Triangulation>&)>;

/// the elevations of bubbles; none where points lie in the plane
template <class Triangulation>
using Elevations = std::vector<typename Triangulation::Geom_traits::FT>;

} // namespace Bubble_relaxation_2::internal
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_PLANE_2_H
