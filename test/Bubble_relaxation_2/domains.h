// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DOMAINS_H
#define BUBBLE_RELAXATION_2_TEST_DOMAINS_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

/// Kernels, triangulations and domains that several tests use.
namespace domains {

/// of points of a kernel, or of traits, with faces that have marks
template <class Traits, class Intersection_tag = CGAL::Default>
using Cdt_of = CGAL::Constrained_Delaunay_triangulation_2<
  Traits, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Traits>,
                                               CGAL::Delaunay_mesh_face_base_2<Traits>>, Intersection_tag>;

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = Cdt_of<K>;

using Outline = std::vector<std::pair<double, double>>;

/// a domain without symmetries, and a hole in it
inline const Outline slanted{{0, 0.1}, {0.97, 0}, {1.1, 0.9}, {0.1, 1.03}}, hole{{0.4, 0.4}, {0.7, 0.43}, {0.5, 0.65}};

template <class P = Point>
std::vector<P> points_of(const Outline& outline)
{
  std::vector<P> points;
  for (const auto& [x, y] : outline)
    points.emplace_back(x, y);
  return points;
}

template <class Cdt>
auto insert(Cdt& cdt, const Outline& outline, bool closed = true)
{
  const auto points = points_of<typename Cdt::Point>(outline);
  return cdt.insert_constraint(points.begin(), points.end(), closed);
}

template <class Cdt = CDT>
Cdt make(const std::vector<Outline>& outlines)
{
  Cdt cdt;
  for (const Outline& o : outlines)
    insert(cdt, o);
  return cdt;
}

/// the mesh of a domain; `d` may be a number or a function
template <class Cdt = CDT, class D>
Cdt mesh(const std::vector<Outline>& outlines, const D& d)
{
  Cdt cdt = make<Cdt>(outlines);
  CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
  return cdt;
}

inline Outline square(double x, double y, double side)
{
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// constraints inside of the domain, of all kinds
template <class Cdt>
Cdt square_with_inner_constraints()
{
  Cdt cdt = make<Cdt>({square(0, 0, 1)});
  insert(cdt, {{0.2, 0.2}, {0.8, 0.3}}, false);                       // inside, free ends
  insert(cdt, {{0.5, 1}, {0.55, 0.6}}, false);                        // dangling from the boundary
  insert(cdt, {{0, 0.5}, {0.3, 0.45}, {0.25, 0.8}, {0, 0.8}}, false); // cuts a region off
  return cdt;
}

inline Outline polygon(double x, double y, double radius, int n, double turn = 0)
{
  Outline o;
  for (int i = 0; i < n; ++i)
    o.push_back({x + radius * std::cos(turn + 2 * 3.14159265358979 * i / n),
                 y + radius * std::sin(turn + 2 * 3.14159265358979 * i / n)});
  return o;
}

/// the area that an outline encloses, counterclockwise
inline double area(const Outline& o)
{
  double sum = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    const auto &p = o[i], &q = o[(i + 1) % o.size()];
    sum += 0.5 * (p.first * q.second - p.second * q.first);
  }
  return sum;
}

/// a random star-shaped polygon around the origin with a square hole
inline std::vector<Outline> random_star(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.6, 1.), turn(-0.3, 0.3);
  std::uniform_int_distribution<int> corners(5, 14);
  const int n = corners(random);
  Outline o;
  for (int i = 0; i < n; ++i) {
    const double r = radius(random), t = 2 * 3.14159265358979 * (i + turn(random)) / n;
    o.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return {o, square(-0.15, -0.1, 0.25)};
}

/// in another order, from other starting points, in other directions
inline std::vector<Outline> shuffled(std::vector<Outline> outlines, std::mt19937& random)
{
  std::shuffle(outlines.begin(), outlines.end(), random);
  for (Outline& o : outlines) {
    std::rotate(o.begin(), o.begin() + static_cast<std::ptrdiff_t>(random() % o.size()), o.end());
    if (random() % 2 == 0)
      std::reverse(o.begin(), o.end());
  }
  return outlines;
}

inline std::vector<Outline> scaled(std::vector<Outline> outlines, double scale)
{
  for (Outline& o : outlines)
    for (auto& [x, y] : o) {
      x *= scale;
      y *= scale;
    }
  return outlines;
}

} // namespace domains

#endif // BUBBLE_RELAXATION_2_TEST_DOMAINS_H
