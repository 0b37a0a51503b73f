// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SET_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SET_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/signed_area.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// The difference of two points.
struct Offset_2
{
  double x, y;
};

inline Offset_2 operator-(const Offset_2& a, const Offset_2& b) { return {a.x - b.x, a.y - b.y}; }

inline Offset_2 offset(const Point& from, const Point& to) { return {to.x() - from.x(), to.y() - from.y()}; }

inline double cross(const Offset_2& a, const Offset_2& b) { return a.x * b.y - a.y * b.x; }

inline double dot(const Offset_2& a, const Offset_2& b) { return a.x * b.x + a.y * b.y; }

/// The triangles of one of the two meshes of a transfer. Points are in lexicographic order, the corners of a triangle
/// counterclockwise from the smallest number on, and triangles in the order of their corners: all sums are taken in
/// this order, so that it does not matter how the user's triangulation came about.
struct Face_set_2
{
  std::vector<Point> points;
  std::vector<std::array<Index, 3>> triangles;

  std::size_t number_of_triangles() const { return triangles.size(); }

  const Point& point(Index t, int i) const { return points[triangles[t][i]]; }

  double area(Index t) const { return (std::max)(0., twice_signed_area(point(t, 0), point(t, 1), point(t, 2)) / 2); }

  std::vector<double> areas() const
  {
    std::vector<double> result;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      result.push_back(area(static_cast<Index>(t)));
    return result;
  }

  Bbox_2 box(Index t) const { return point(t, 0).bbox() + point(t, 1).bbox() + point(t, 2).bbox(); }

  std::vector<Bbox_2> boxes() const
  {
    std::vector<Bbox_2> result;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      result.push_back(box(static_cast<Index>(t)));
    return result;
  }
};

/// The power of two that brings a positive number to about 1, or near to that: the largest double is below 2^1024, and
/// 2^-1024 is not a normal number.
inline double factor_to_unit(double value)
{
  return std::ldexp(1., (std::min)(1022, (std::max)(-1022, -std::ilogb(value))));
}

/// Scales both sets by a power of two, which alters no bit of a mantissa, so that the source's extent is about 1: areas
/// and their products neither overflow nor vanish, whatever the units. Returns the factor.
inline double scale_to_unit(Face_set_2& source, Face_set_2& target)
{
  const Bbox_2 box = bbox_2(source.points.begin(), source.points.end());
  const double extent = (std::max)(box.x_span(), box.y_span());
  const double factor = extent > 0 ? factor_to_unit(extent) : 1;
  for (Face_set_2* faces : {&source, &target})
    for (Point& p : faces->points)
      p = Point(p.x() * factor, p.y() * factor);
  return factor;
}

/// The same for values, whose squares are summed. Returns the factor.
inline double scale_to_unit(std::vector<double>& values)
{
  double largest = 0;
  for (double v : values)
    largest = (std::max)(largest, std::abs(v));
  if (largest == 0)
    return 1;
  const double factor = factor_to_unit(largest);
  for (double& v : values)
    v *= factor;
  return factor;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TRANSFER_FACE_SET_2_H
