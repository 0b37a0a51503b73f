// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MAP_PROJECTION_H
#define BUBBLE_RELAXATION_2_DEMO_MAP_PROJECTION_H

#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <memory>
#include <stdexcept>
#include <string>

// What the readers of maps and of rasters need of GDAL: it is silent, and tells its reasons when it is asked.

/// GDAL prints nothing as long as this lives.
class Quiet_gdal
{
public:
  Quiet_gdal() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~Quiet_gdal() { CPLPopErrorHandler(); }
  Quiet_gdal(const Quiet_gdal&) = delete;
  Quiet_gdal& operator=(const Quiet_gdal&) = delete;

  static std::string reason() { return CPLGetLastErrorMsg(); }
};

/// a reference system, with x to the east and y to the north
/// \param option that asks for it, for the message
/// \throws std::runtime_error if `text` is none
inline OGRSpatialReference reference_system(const std::string& option, const std::string& text)
{
  OGRSpatialReference system;
  if (system.SetFromUserInput(text.c_str()) != OGRERR_NONE)
    throw std::runtime_error(option + ": '" + text + "' is no reference system; one is EPSG:32632");
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

inline std::string in_wkt(const OGRSpatialReference& system)
{
  char* text = nullptr;
  system.exportToWkt(&text);
  const std::string result = text == nullptr ? "" : text;
  CPLFree(text);
  return result;
}

using Projection = std::unique_ptr<OGRCoordinateTransformation>;

/// from one reference system to another
inline Projection projection(const OGRSpatialReference& from, const OGRSpatialReference& to)
{
  Projection result(OGRCreateCoordinateTransformation(&from, &to));
  if (!result)
    throw std::runtime_error("the reference systems cannot be transformed: " + Quiet_gdal::reason());
  return result;
}

#endif // BUBBLE_RELAXATION_2_DEMO_MAP_PROJECTION_H
