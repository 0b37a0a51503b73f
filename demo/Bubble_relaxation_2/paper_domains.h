// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_PAPER_DOMAINS_H
#define BUBBLE_RELAXATION_2_DEMO_PAPER_DOMAINS_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// The domains and sizes of the paper's figures. Where the paper shows a domain without giving its
/// coordinates they are chosen here to look like its caption: the octagram, the non-convex domain, the
/// trunk, the comb, and the radii of circles.
namespace paper {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<
  K, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<K>,
                                          CGAL::Delaunay_mesh_face_base_2<K>>>;
using Sizing = std::function<double(const Point&)>;
using Outline = std::vector<Point>;

constexpr double pi = 3.14159265358979323846;

/// A domain: outlines, nested, and the wanted distance d.
struct Domain
{
  int figure;
  std::string name;
  std::vector<Outline> outlines;
  Sizing d;
  int iterations; ///< the paper's steps in a round
  int rounds;     ///< the paper's rounds
};

template <class Cdt = CDT>
Cdt triangulate(const std::vector<Outline>& outlines)
{
  Cdt cdt;
  for (const Outline& o : outlines)
    cdt.insert_constraint(o.begin(), o.end(), true);
  return cdt;
}

inline CDT triangulate(const Domain& domain) { return triangulate(domain.outlines); }

inline double distance(const Point& p, double x, double y = 0)
{
  return std::hypot(p.x() - x, p.y() - y);
}

/// A circle as a polygon. Its vertices are corners of the domain and stay, so its edges must be as long
/// as the mesh shall be there.
inline Outline circle(double radius, double edge)
{
  const int n = (std::max)(6, static_cast<int>(std::lround(2 * pi * radius / edge)));
  Outline outline;
  for (int i = 0; i < n; ++i)
    outline.push_back(Point(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n)));
  return outline;
}

/// Example 1: a square with a hole, eq. 1. Figures 3 to 6 and 19; `f` scales d in all functions.
inline Domain square_with_hole(double f)
{
  return {6, "square with hole", {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, circle(0.5, f * 0.5 / 8)},
          [f](const Point& p) { return f * distance(p, 0) / 8; }, 250, 4};
}

/// Example 1 refined towards the hole, eq. 12. Figures 20 and 21.
inline Sizing refined_size(double f)
{
  return [f](const Point& p) {
    const double r = distance(p, 0);
    return f * r / (r > 0.7 ? 8 : r > 0.6 ? 11 : 14);
  };
}

/// Figure 7: an octagram, two squares crossed, inner corners where their sides meet.
inline Domain octagram(double f)
{
  Outline o;
  for (int i = 0; i < 16; ++i) {
    const double r = i % 2 == 0 ? 1 : std::cos(pi / 4) / std::cos(pi / 8);
    o.push_back(Point(r * std::cos(pi * i / 8), r * std::sin(pi * i / 8)));
  }
  return {7, "octagram", {o}, [f](const Point&) { return 0.05 * f; }, 30, 1};
}

/// Figure 8: a non-convex domain with a hole.
inline Domain non_convex(double f)
{
  return {8, "non-convex with hole",
          {{{0, 0}, {2, 0}, {2, 1}, {1.2, 1}, {1, 1.6}, {0.4, 1.6}, {0, 1}},
           {{0.5, 0.4}, {0.9, 0.4}, {0.9, 0.8}, {0.5, 0.8}}},
          [f](const Point&) { return 0.05 * f; }, 5, 1};
}

/// Figure 9: a trunk with two branches.
inline Domain trunk(double f)
{
  return {9, "trunk",
          {{{-0.3, 0}, {0.3, 0}, {0.25, 0.6}, {0.8, 1.1}, {0.7, 1.2}, {0.2, 0.85}, {0.15, 1.5},
            {-0.1, 1.5}, {-0.15, 0.9}, {-0.7, 1.3}, {-0.8, 1.2}, {-0.25, 0.65}}},
          [f](const Point&) { return 0.05 * f; }, 250, 6};
}

/// Figure 10: a circle, dense around another, eq. 4.
inline Domain graded_circle(double f)
{
  return {10, "circle", {circle(0.6, f * 0.06)},
          [f](const Point& p) { return f * (0.04 * std::abs(distance(p, 0) - 0.3) / 0.3 + 0.02); },
          500, 1};
}

/// Figure 11: a square, dense around two points, eq. 5.
inline Domain graded_square(double f)
{
  return {11, "square", {{{-0.5, 0}, {0.5, 0}, {0.5, 1}, {-0.5, 1}}},
          [f](const Point& p) {
            return f * (std::min)({0.06 * distance(p, 0, 0.25) / 0.5 + 0.02,
                                   0.06 * distance(p, 0, 0.75) / 0.5 + 0.02, 0.05});
          },
          750, 1};
}

/// Figure 12: an L, dense in its inner corner, eq. 6.
inline Domain l_shape(double f)
{
  return {12, "L", {{{0, 0}, {0.4, 0}, {0.4, 0.6}, {1, 0.6}, {1, 1}, {0, 1}}},
          [f](const Point& p) {
            return f * (std::min)(0.16 * distance(p, 0.4, 0.6) + 0.01, 0.08);
          },
          250, 10};
}

/// Figure 13: a comb with seven dense fingers, eq. 7.
inline Domain comb(double f)
{
  constexpr int fingers = 7;
  constexpr double pitch = 1 / (fingers - 0.5), width = pitch / 2;
  Outline o{{0, 0}};
  for (int i = 0; i < fingers; ++i) {
    if (i > 0)
      o.push_back(Point(0.7, pitch * i));
    o.push_back(Point(1, pitch * i));
    o.push_back(Point(1, i + 1 < fingers ? pitch * i + width : 1));
    if (i + 1 < fingers)
      o.push_back(Point(0.7, pitch * i + width));
  }
  o.push_back(Point(0, 1));
  return {13, "comb", {o},
          [f](const Point& p) {
            return f * (p.x() > 0.7 ? 0.015 : (std::min)((0.7 - p.x()) / 5 + 0.015, 0.05));
          },
          250, 6};
}

/// Figures 14 to 16: a ring, eq. 8. With these radii it has about the paper's 1192 nodes.
inline Domain ring(double f)
{
  constexpr double inner = 1. / 83;
  return {16, "ring", {circle(1, f / 6), circle(inner, f * inner / 6)},
          [f](const Point& p) { return f * distance(p, 0) / 6; }, 250, 6};
}

/// All domains of sections 2.1.5 and 2.2, with d scaled by `f`.
inline std::vector<Domain> all_domains(double f)
{
  return {square_with_hole(f), octagram(f),      non_convex(f), trunk(f),
          graded_circle(f),    graded_square(f), l_shape(f),    comb(f),  ring(f)};
}

} // namespace paper

#endif // BUBBLE_RELAXATION_2_DEMO_PAPER_DOMAINS_H
