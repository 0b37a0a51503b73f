// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_DOMAIN_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_DOMAIN_FILE_H

#include "domain.h"
#include "file_names.h"
#include "triangle_file.h"
#include "wkt_file.h"
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
#include "ogr_file.h"
#endif

#include <fstream>
#include <iostream>

/// what GDAL reads
inline Domain read_map([[maybe_unused]] const std::string& name, [[maybe_unused]] const std::string& field,
                       [[maybe_unused]] const std::string& crs)
try {
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
  Domain domain = Ogr_reader(name, field, crs).read();
  pin_points_with_markers(domain); // on lines
  return domain;
#else
  throw std::runtime_error("this program was built without GDAL, which reads such files");
#endif
} catch (const std::exception& e) {
  throw std::runtime_error(name + ": " + e.what());
}

/// Reads .poly, .wkt, .node and .ele, or what GDAL reads, by the ending of the name.
/// \param name of the file, "-" for standard input
/// \param format "poly", "wkt" or "map" instead of the ending, if it is not empty
/// \param field, crs of what GDAL reads, see `Ogr_reader`
/// \throws std::runtime_error with the name and the place
inline Domain read_domain_file(const std::string& name, const std::string& format, const std::string& field,
                               const std::string& crs)
{
  const bool is_standard_input = name == "-";
  if (!format.empty() && format != "poly" && format != "wkt" && format != "map")
    throw std::runtime_error("--format: '" + format + "' must be poly or wkt, or map for what GDAL reads");
  if (is_standard_input && format.empty())
    throw std::runtime_error("standard input needs --format poly or --format wkt");
  const std::string ending = format.empty() ? extension(name) : "." + format;
  if (format.empty())
    check_extension(name, {".poly", ".wkt", ".node", ".ele", ".geojson", ".shp", ".gpkg"});
  if (ending == ".geojson" || ending == ".shp" || ending == ".gpkg" || ending == ".map")
    return read_map(name, field, crs);
  if (!field.empty() || !crs.empty())
    throw std::runtime_error(name + ": --field and --crs are for what GDAL reads");
  errno = 0;
  std::ifstream file;
  if (!is_standard_input) {
    file.open(name);
    if (!file || file.peek() == std::ifstream::traits_type::eof())
      throw std::runtime_error(name + (file.is_open() && errno == 0 ? std::string(": is empty")
                                         : std::string(": cannot be opened: ") + std::strerror(errno)));
  }
  std::istream& in = is_standard_input ? std::cin : file;
  if (ending == ".node" || ending == ".ele") { // two or three files, and errors name the one
    Domain domain = read_triangle_mesh(name);
    pin_points_with_markers(domain);
    return domain;
  }
  try {
    Domain domain =
      ending == ".poly" ? read_poly(in, is_standard_input ? std::string() : name) : Wkt_reader(in).read();
    pin_points_with_markers(domain);
    return domain;
  } catch (const std::exception& e) {
    throw std::runtime_error((is_standard_input ? "standard input" : name) + ": " + e.what());
  }
}

#endif // BUBBLE_RELAXATION_2_DEMO_DOMAIN_FILE_H
