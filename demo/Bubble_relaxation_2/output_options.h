// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_OUTPUT_OPTIONS_H
#define BUBBLE_RELAXATION_2_DEMO_OUTPUT_OPTIONS_H

#include "files/domain.h"
#include "files/domain_boundary.h"
#include "files/file_names.h"
#include "files/mesh_file.h"
#include "files/output_projection.h"
#include "formula.h"
#include "input_options.h"
#include "marker_list.h"

#include <CGAL/Mesh_arrays_2.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What the programs for one rank and for several are told of the files that they write.

namespace po = boost::program_options;

inline po::options_description output_options()
{
  po::options_description options;
  options.add_options()
    ("name", po::value<std::vector<std::string>>(),
     "MARKER=NAME, or region:ATTRIBUTE=NAME: a name for .msh and .msh2; as often as there are names")
    ("open", po::value<std::string>(),
     "markers of open boundaries, such as 2,3, for .14, .grd and .gr3; others are land")
    ("depth", po::value<std::string>(),
     "the depth of nodes for these and .2dm, and data of .vtu and .msh: a formula in x, y and rasters")
    ("output-crs", po::value<std::string>(),
     "the reference system of what is written, such as EPSG:4326, degrees; default: that in which the mesh is made")
    ("statistics", po::value<std::string>(), "a file for what is printed of the mesh and for warnings: .json");
  return options;
}

/// \throws std::runtime_error if statistics are asked for and cannot be written
inline void check_statistics(const po::variables_map& arguments)
{
  if (arguments.count("statistics") == 0)
    return;
  const std::string file = arguments["statistics"].as<std::string>();
  check_extension(file, {".json"});
  check_output(arguments["input"].as<std::string>(), file, "--statistics");
  if (arguments.count("simplification-report") > 0 && arguments["simplification-report"].as<std::string>() == file)
    throw std::runtime_error("--statistics and --simplification-report are one file, " + file);
}

/// What is said by the user of the mesh that is written.
class Output_tags
{
public:
  /// \throws std::runtime_error if an option makes no sense
  explicit Output_tags(const po::variables_map& arguments)
  {
    if (arguments.count("name") > 0)
      for (const std::string& text : arguments["name"].as<std::vector<std::string>>())
        read_name(text);
    const bool is_of_ocean = arguments.count("output") > 0 && is_of_adcirc(arguments["output"].as<std::string>());
    if (arguments.count("open") > 0) {
      if (!is_of_ocean)
        throw std::runtime_error("--open needs --output with the ending .14, .grd or .gr3");
      m_open = markers("--open", arguments["open"].as<std::string>());
    }
    check_format(arguments);
    m_lacks_depth = is_of_ocean && arguments.count("depth") == 0;
    if (arguments.count("depth") > 0)
      m_depth.emplace("--depth", arguments["depth"].as<std::string>(), raster_names(arguments));
    if (m_depth && m_depth->uses("distance"))
      throw std::runtime_error("--depth: only --size knows the distance to the outline");
    if (m_depth && m_depth->uses("region"))
      throw std::runtime_error("--depth: a node may lie in several regions; a formula in x and y is needed");
    if (arguments.count("output-crs") > 0) {
      m_crs = arguments["output-crs"].as<std::string>();
      if (arguments.count("output") == 0 || extension(arguments["output"].as<std::string>()) == ".pvtu")
        throw std::runtime_error("--output-crs needs --output with another ending than .pvtu");
    }
  }

  /// Warns, in the domain, of a depth that nobody gave.
  /// \throws std::runtime_error if a marker or a region that is named is not in the domain, or the domain cannot be
  /// written in another reference system
  void check(Domain& domain)
  {
    std::set<int> markers{1}; // of what has none on the boundary
    for (const auto& s : domain.segment_markers)
      markers.insert(s.second);
    std::set<double> regions;
    if (domain.regions.empty())
      regions.insert(1); // the group of all triangles, if the format has groups
    for (const Region& region : domain.regions)
      regions.insert(region.attribute);
    for (const int marker : m_open)
      if (markers.count(marker) == 0)
        throw std::runtime_error("--open: no segment has the marker " + std::to_string(marker));
    for (const auto& name : m_marker_names)
      if (markers.count(name.first) == 0)
        throw std::runtime_error("--name: no segment has the marker " + std::to_string(name.first));
    for (const auto& name : m_region_names)
      if (regions.count(name.first) == 0)
        throw std::runtime_error("--name: no region has the attribute of '" + name.second + "'");
    if (!m_crs.empty()) {
      m_projection.emplace(domain, m_crs);
      m_projection->check(domain);
    }
    if (m_lacks_depth)
      domain.warnings.push_back("without --depth the depth of all nodes is 0 in the output");
  }

  /// \param reason why there may be none, for the message
  /// \throws std::runtime_error if a marker of --open is on no segment of the boundary
  void check_open(const Domain& domain, const std::string& reason = "") const
  {
    if (m_open.empty())
      return;
    std::set<int> missing = m_open;
    for (const auto& ends : boundary_segments(domain)) {
      const int marker = segment_marker(domain, ends.first, ends.second);
      missing.erase(marker != 0 ? marker : 1); // as the boundary of a mesh is marked
    }
    if (!missing.empty())
      throw std::runtime_error("--open: no segment of the boundary has the marker " + std::to_string(*missing.begin()) +
                               reason);
  }

  /// \throws std::runtime_error if a depth on the outline is not finite; elsewhere only the mesh tells
  void check_depth(const Domain& domain) const
  {
    if (!m_depth)
      return;
    for (const auto& ends : boundary_segments(domain)) {
      depth(ends.first);
      depth(ends.second);
    }
  }

  /// \throws std::runtime_error if a raster is needed and there is none
  void set_rasters(const Rasters& rasters)
  {
    if (m_depth)
      m_depth->set_rasters(rasters);
  }

  const std::set<int>& open() const { return m_open; }

  /// \throws std::runtime_error if a depth is not finite
  void add_to(CGAL::Mesh_arrays_2& mesh) const
  {
    mesh.marker_names = m_marker_names;
    mesh.region_names = m_region_names;
    if (m_depth) {
      std::vector<double>& depths = mesh.vertex_data["depth"];
      for (const Point& p : mesh.points)
        depths.push_back(depth(p));
    }
  }

  /// Brings a mesh to the reference system of `--output-crs`, when all that depends on places is there.
  /// \throws std::runtime_error if a point cannot be projected
  void project(CGAL::Mesh_arrays_2& mesh) const
  {
    for (std::vector<Point>* points : {&mesh.points, &mesh.holes})
      if (m_projection)
        std::transform(points->begin(), points->end(), points->begin(), std::cref(*m_projection));
  }

private:
  /// \throws std::runtime_error if the format of the output has no place for what is said of it
  static void check_format(const po::variables_map& arguments)
  {
    const std::string output = arguments.count("output") > 0 ? arguments["output"].as<std::string>() : "",
                      ending = extension(output);
    if (arguments.count("name") > 0 && !has_names(output))
      throw std::runtime_error("--name needs --output with the ending .msh or .msh2: other formats have no names");
    if (arguments.count("depth") > 0 && (ending.empty() || ending == ".pvtu" || is_of_triangle(output)))
      throw std::runtime_error("--depth needs --output with another ending than .node, .ele, .edge and .pvtu, which "
                               "have no depths");
  }

  double depth(const Point& p) const
  {
    const double result = (*m_depth)(p.x(), p.y());
    if (!std::isfinite(result))
      throw std::runtime_error("--depth: at " + to_string(p) + " it must be finite");
    return result;
  }

  void read_name(const std::string& text)
  {
    const std::string region = "region:";
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at + 1 == text.size())
      throw std::runtime_error("--name: '" + text + "' must be MARKER=NAME or region:ATTRIBUTE=NAME");
    if (text.compare(0, region.size(), region) == 0)
      m_region_names[number("--name", text.substr(region.size(), at - region.size()))] = text.substr(at + 1);
    else
      m_marker_names[integer("--name", text.substr(0, at))] = text.substr(at + 1);
  }

  std::map<int, std::string> m_marker_names;
  std::map<double, std::string> m_region_names;
  std::set<int> m_open;
  bool m_lacks_depth = false; // although the format of the output has one
  std::optional<Formula> m_depth;
  std::string m_crs;
  std::optional<Output_projection> m_projection; // to that
};

#endif // BUBBLE_RELAXATION_2_DEMO_OUTPUT_OPTIONS_H
