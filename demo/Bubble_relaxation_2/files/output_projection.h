// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_OUTPUT_PROJECTION_H
#define BUBBLE_RELAXATION_2_DEMO_OUTPUT_PROJECTION_H

#include "domain.h"
#include "domain_boundary.h"

#include <stdexcept>
#include <string>

#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
#include "map_projection.h"

#include <cmath>
#include <optional>
#include <utility>
#endif

/// Brings the points of a domain to the reference system of `--output-crs`.
class Output_projection
{
public:
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
  /// \throws std::runtime_error if `crs` is no reference system, or that of the domain is not known
  Output_projection(const Domain& domain, const std::string& crs)
  {
    const Quiet_gdal quiet;
    if (domain.crs.empty())
      throw std::runtime_error("--output-crs: the input does not tell which reference system its coordinates are in");
    const OGRSpatialReference system = reference_system("--output-crs", crs);
    m_is_in_degrees = system.IsGeographic();
    m_projection = projection(reference_system("--crs", domain.crs), system);
  }

  /// \throws std::runtime_error if there is no such point
  Point operator()(const Point& p) const
  {
    const Quiet_gdal quiet;
    double x = p.x(), y = p.y();
    if (!m_projection->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
      throw std::runtime_error("--output-crs: the point " + to_string(p) + " cannot be projected");
    return Point(x, y);
  }

  /// \throws std::runtime_error if the boundary goes where there are no points, or across the meridian at which
  /// longitudes jump, or if the domain is turned over, since axes point to the west or to the south
  void check(const Domain& domain) const
  {
    double area = 0; // twice that
    std::optional<Point> origin;
    for (const auto& [first, last] : boundary_segments(domain)) {
      const Point p = (*this)(first), q = (*this)(last);
      if (std::abs(p.x() - q.x()) > 180 && m_is_in_degrees)
        throw std::runtime_error("--output-crs: longitudes jump at " + to_string(first));
      origin = origin ? origin : p;
      area += CGAL::determinant(p - *origin, q - *origin);
    }
    if (!(area > 0))
      throw std::runtime_error("--output-crs: the axes of this reference system turn the domain over");
  }

private:
  Projection m_projection;
  bool m_is_in_degrees = false;
#else
  Output_projection(const Domain&, const std::string&)
  {
    throw std::runtime_error("--output-crs: this program was built without GDAL");
  }

  Point operator()(const Point& p) const { return p; }
  void check(const Domain&) const {}
#endif
};

#endif // BUBBLE_RELAXATION_2_DEMO_OUTPUT_PROJECTION_H
