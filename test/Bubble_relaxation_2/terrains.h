// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_TERRAINS_H
#define BUBBLE_RELAXATION_2_TEST_TERRAINS_H

#include "domains.h"

#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>
#include <CGAL/Projection_traits_xy_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

/// Terrains for tests, and what is compared of them.
namespace terrains {

using domains::K;

using Terrain = domains::Cdt_of<CGAL::Projection_traits_xy_3<K>>;

/// how a test sees a triangulation: which coordinates count, and which one is the elevation
template <class Cdt_, int u, int v, int z, class Flat_ = domains::CDT>
struct View
{
  using Cdt = Cdt_;
  using Flat = Flat_; // the same kind of triangulation with points in the plane
  using Point = typename Cdt::Point;

  static Point point(double x, double y, double elevation)
  {
    std::array<double, 3> c{};
    c[u] = x;
    c[v] = y;
    c[z] = elevation;
    return Point(c[0], c[1], c[2]);
  }

  static double x(const Point& p) { return coordinate(p, u); }
  static double y(const Point& p) { return coordinate(p, v); }
  static double elevation(const Point& p) { return coordinate(p, z); }

private:
  /// what a lazy number is in double depends on whether it has been evaluated
  static double coordinate(const Point& p, int axis)
  {
    CGAL::Bubble_relaxation_2::internal::evaluate_lazy(p, 0);
    return CGAL::to_double(p.cartesian(axis));
  }
};

using Place = std::pair<double, double>;
using Height = std::function<double(double, double)>;

inline double plane(double x, double y) { return 0.5 * x - 0.25 * y + 3; }
inline double hill(double x, double y) { return std::exp(-4 * (x * x + y * y)); }

/// A domain with a hole, a ridge inside of it, and vertices outside, all on a surface; `is_scattered`: with free
/// vertices. `point(x, y)` makes the points.
template <class Cdt, class Make_point>
Cdt make(const Make_point& point, bool is_scattered)
{
  using Path = std::vector<Place>;
  Cdt cdt;
  const auto insert = [&](Path path, bool is_closed) {
    if (is_closed)
      path.push_back(path.front());
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
      cdt.insert_constraint(point(path[k].first, path[k].second), point(path[k + 1].first, path[k + 1].second));
  };
  insert({{-1, -1}, {1, -1.1}, {1.2, 1}, {-0.9, 0.9}}, true);
  insert({{0.3, 0.3}, {0.3, 0.7}, {0.75, 0.6}}, true);
  insert({{-0.6, -0.5}, {0.1, -0.2}, {0.5, -0.6}}, false);
  for (const Place& p : {Place{-2, 0.3}, {2.5, -0.5}, {0.4, 2}, {0.1, -3}, {0.4, 0.5}})
    cdt.insert(point(p.first, p.second));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-0.85, 0.85);
  for (int i = 0; i < 300 && is_scattered; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    cdt.insert(point(x, y));
  }
  return cdt;
}

template <class V>
typename V::Cdt make_terrain(const Height& height, bool is_scattered = true)
{
  return make<typename V::Cdt>([&](double x, double y) { return V::point(x, y, height(x, y)); }, is_scattered);
}

/// the place and the mark of all corners of faces, sorted
using Mesh = std::set<std::array<double, 7>>;

template <class Cdt, class Get_x, class Get_y>
Mesh mesh_of(const Cdt& cdt, const Get_x& x, const Get_y& y)
{
  Mesh mesh;
  for (const auto f : cdt.finite_face_handles()) {
    std::array<Place, 3> p;
    for (int i = 0; i < 3; ++i)
      p[static_cast<std::size_t>(i)] = {x(f->vertex(i)->point()), y(f->vertex(i)->point())};
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    mesh.insert({p[0].first, p[0].second, p[1].first, p[1].second, p[2].first, p[2].second,
                 f->is_in_domain() ? 1. : 0.});
  }
  return mesh;
}

template <class V>
Mesh mesh_of(const typename V::Cdt& cdt)
{
  return mesh_of(cdt, V::x, V::y);
}

template <class Flat>
Mesh mesh_of_flat(const Flat& cdt)
{
  using CGAL::Bubble_relaxation_2::internal::point_in_double;
  return mesh_of(cdt, [](const auto& p) { return point_in_double<Flat>(p).x(); },
                 [](const auto& p) { return point_in_double<Flat>(p).y(); });
}

/// all vertices with elevations
template <class V>
std::map<Place, double> elevations(const typename V::Cdt& cdt)
{
  std::map<Place, double> result;
  for (const auto v : cdt.finite_vertex_handles())
    result[{V::x(v->point()), V::y(v->point())}] = V::elevation(v->point());
  return result;
}

template <class V>
double largest_error(const typename V::Cdt& cdt, const Height& height)
{
  double error = 0;
  for (const auto& [p, z] : elevations<V>(cdt))
    error = (std::max)(error, std::abs(z - height(p.first, p.second)));
  return error;
}

inline const auto growing = [](const auto& p) { return 0.06 + 0.05 * CGAL::to_double(p.x() * p.x()); };

} // namespace terrains

#endif // BUBBLE_RELAXATION_2_TEST_TERRAINS_H
