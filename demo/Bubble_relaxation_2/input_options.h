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

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

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
     "of what GDAL reads: the reference system to project to, such as EPSG:32632, or none: coordinates as they are; "
     "default: degrees to metres")
    ("raster", po::value<std::vector<std::string>>(),
     "what GDAL reads, such as a .tif or .nc: the variable raster of formulas; or NAME=FILE: the variable NAME; as often "
     "as there are some");
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

/// The files of `--raster` by the names of their variables.
/// \throws std::runtime_error if two have the same one, or one has that of another variable
inline std::map<std::string, std::string> raster_files(const po::variables_map& arguments)
{
  std::map<std::string, std::string> files;
  if (arguments.count("raster") == 0)
    return files;
  for (const std::string& text : arguments["raster"].as<std::vector<std::string>>()) {
    const auto is_of_name = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
    const auto name_end = std::find_if_not(text.begin(), text.end(), is_of_name);
    const bool has_name = name_end != text.end() && *name_end == '=' && std::isalpha(static_cast<unsigned char>(text[0]));
    const std::string name = has_name ? std::string(text.begin(), name_end) : "raster";
    if (name == "x" || name == "y" || name == "region" || name == "distance" || is_function(name))
      throw std::runtime_error("--raster: " + name + " has another meaning in formulas");
    if (!files.emplace(name, has_name ? std::string(name_end + 1, text.end()) : text).second)
      throw std::runtime_error("--raster: two have the name " + name + "; NAME=FILE gives them others");
  }
  return files;
}

/// the variables that rasters may be in formulas
inline std::vector<std::string> raster_names(const po::variables_map& arguments)
{
  std::vector<std::string> names{"raster"}; // always, for the message that there is none
  for (const auto& file : raster_files(arguments))
    if (file.first != "raster")
      names.push_back(file.first);
  return names;
}

/// The values of `--raster`. They may warn, in the domain.
inline Rasters read_rasters(const po::variables_map& arguments, [[maybe_unused]] Domain& domain)
{
  Rasters rasters;
  for (const auto& file : raster_files(arguments)) {
#ifdef BUBBLE_RELAXATION_2_WITH_GDAL
    const auto raster = std::make_shared<const Raster>(file.second, domain);
    const std::string warning = raster->warning(domain);
    if (!warning.empty())
      domain.warnings.push_back("--raster: " + file.second + ": " + warning);
    rasters[file.first] = [raster](double x, double y) { return (*raster)(x, y); };
#else
    throw std::runtime_error("--raster: " + file.second + ": this program was built without GDAL");
#endif
  }
  return rasters;
}

#endif // BUBBLE_RELAXATION_2_DEMO_INPUT_OPTIONS_H
