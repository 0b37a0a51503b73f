// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_INPUT_OPTIONS_H
#define BUBBLE_RELAXATION_2_DEMO_INPUT_OPTIONS_H

#include "files/domain_file.h"
#include "formula.h"
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
#include "files/raster_file.h"
#endif

#include <boost/program_options.hpp>

#include <memory>
#include <stdexcept>
#include <string>

// What the programs for one rank and for several are told of what they read.

namespace po = boost::program_options;

inline po::options_description input_options()
{
  po::options_description options;
  options.add_options()
    ("input", po::value<std::string>(),
     "the domain: .poly (Triangle), .wkt, a mesh to relax: .ele with its .node; and with GDAL .geojson, .shp, .gpkg")
    ("field", po::value<std::string>()->default_value(""),
     "of what GDAL reads: the field that is the marker of a feature")
    ("crs", po::value<std::string>()->default_value(""),
     "of what GDAL reads: the reference system to project to, such as EPSG:32632; default: degrees to metres")
    ("raster", po::value<std::string>(), "what GDAL reads, such as a .tif or .nc: the variable raster of formulas");
  return options;
}

/// The arguments, of which one without an option is the input. Options are not abbreviated: one with a longer name may
/// come.
inline po::variables_map parse_arguments(int argc, char** argv, const po::options_description& options)
{
  using Style = po::command_line_style::style_t;
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map arguments;
  po::store(po::command_line_parser(argc, argv)
              .options(options)
              .positional(positional)
              .style(Style::default_style & ~Style::allow_guessing)
              .run(),
            arguments);
  return arguments;
}

/// \param format that is asked for, empty if the ending tells it
inline Domain read_domain(const po::variables_map& arguments, const std::string& format)
{
  Domain domain = read_domain_file(arguments["input"].as<std::string>(), format, arguments["field"].as<std::string>(),
                                   arguments["crs"].as<std::string>());
  if (arguments.count("size") > 0 && has_areas(domain))
    domain.warnings.push_back("areas of regions are not used, since --size tells the size");
  return domain;
}

/// The values of `--raster`, nothing without it. It may warn, in the domain.
inline Raster_values read_raster([[maybe_unused]] const po::variables_map& arguments, [[maybe_unused]] Domain& domain)
{
  if (arguments.count("raster") == 0)
    return {};
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
  const auto raster = std::make_shared<const Raster>(arguments["raster"].as<std::string>(), domain);
  const std::string warning = raster->warning(domain);
  if (!warning.empty())
    domain.warnings.push_back(warning);
  return [raster](double x, double y) { return (*raster)(x, y); };
#else
  throw std::runtime_error("--raster: this program was built without GDAL");
#endif
}

#endif // BUBBLE_RELAXATION_2_DEMO_INPUT_OPTIONS_H
