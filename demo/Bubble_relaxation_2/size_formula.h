// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H
#define BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H

#include "files/domain.h"
#include "formula.h"
#include "outline_distance.h"

#include <CGAL/Region_sizing_field_2.h>

#include <cmath>
#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// d as a formula
class Size_formula
{
public:
  /// \param rasters the names of their variables
  /// \param shore the markers of the segments and pinned points to which the variable `distance` is measured; none: all
  /// segments
  /// \throws std::runtime_error with one line if `text` is not one formula
  explicit Size_formula(const std::string& text, const std::vector<std::string>& rasters, std::set<int> shore = {})
    : m_formula("--size", text, rasters), m_shore(std::move(shore))
  {}

  /// sets what the variable `distance` is in a domain, if it is used
  /// \throws std::runtime_error if no segment and no pinned point has one of the markers
  void set_distance(const Domain& domain)
  {
    if (has_distance())
      m_formula.set_distance(Outline_distance(domain, m_shore));
  }

  bool has_distance() const { return m_formula.uses("distance"); }

  /// whether it depends on the region
  bool has_region() const { return m_formula.uses("region"); }

  /// \throws std::runtime_error if a raster is needed and there is none
  void set_rasters(const Rasters& rasters) { m_formula.set_rasters(rasters); }

  /// \throws std::runtime_error if d is not positive and finite
  template <class Point_2>
  double operator()(const Point_2& p, double region = 0) const
  {
    const double d = m_formula(p.x(), p.y(), region);
    if (!(d > 0) || !std::isfinite(d)) {
      std::ostringstream message;
      message << "--size: d(" << p.x() << ", " << p.y() << ") = "
              << (std::isnan(d) ? std::nan("") : d) // not "-nan", as 0/0 is printed
              << " must be positive and finite";
      throw std::runtime_error(message.str());
    }
    return d;
  }

private:
  Formula m_formula;
  std::set<int> m_shore;
};

/// the sizes that a formula asks for in a domain as it is now
/// \throws std::runtime_error if it needs what the domain does not have
inline std::function<double(const Point&)> size_in_domain(Size_formula formula, const Domain& domain)
{
  if (formula.has_region() && domain.regions.empty()) // it would be 0 everywhere
    throw std::runtime_error("--size: the variable region needs regions in the domain, and there are none; a .poly or "
                             "an .ele may have them, and --field makes them of polygons");
  formula.set_distance(domain);
  if (!formula.has_region())
    return formula;
  return CGAL::Region_sizing_field_2<CDT>(domain.cdt, region_attributes(domain),
                                          [formula](double region, const Point& p) { return formula(p, region); });
}

/// The sizes that maximal areas of regions ask for: sides of equilateral triangles with these areas, and elsewhere what
/// the outline and its neighbours allow. Nothing if there are no areas.
inline std::function<double(const Point&)> size_by_areas(const Domain& domain)
{
  if (!has_areas(domain))
    return nullptr;
  CGAL::Bbox_2 box;
  for (CDT::Vertex_handle v : domain.cdt.finite_vertex_handles())
    box += v->point().bbox();
  const double longest = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  return CGAL::Region_sizing_field_2<CDT>(domain.cdt, region_values(domain, &Region::area), [longest](double area) {
    return area > 0 ? std::sqrt(4 * area / std::sqrt(3.)) : longest;
  });
}

#endif // BUBBLE_RELAXATION_2_DEMO_SIZE_FORMULA_H
