// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MESH_OPTIONS_H
#define BUBBLE_RELAXATION_2_DEMO_MESH_OPTIONS_H

#include "files/domain.h"
#include "files/simplify_domain.h"
#include "input_options.h"
#include "marker_list.h"
#include "output_options.h"
#include "size_formula.h"

#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Gradation_limited_sizing_field_2.h>
#include <CGAL/property_map.h>

#include <boost/program_options.hpp>

#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

// What the programs for one rank and for several have in common on their command lines.

namespace po = boost::program_options;

using Size = std::function<double(const Point&)>;

/// the options that tell what mesh is wanted
inline po::options_description mesh_options()
{
  namespace defaults = CGAL::Bubble_relaxation_2::internal;
  po::options_description options;
  options.add_options()
    ("size,s", po::value<std::string>(), "wanted length of edges, a formula in x, y, rasters, distance, that to the "
                                         "outline, and region, the attribute of a region of the domain; default: by the "
                                         "areas of regions in a .poly, else that of the domain's own edges")
    ("distance-to", po::value<std::string>()->default_value(""),
     "the markers of the segments and pinned points to which the distance of --size is measured, such as 1,2; default: "
     "all segments")
    ("gradation,g", po::value<double>(), "the most that the length may change per unit of length, such as 0.2; "
                                         "default: as --size asks")
    ("size-growth", po::value<double>()->default_value(defaults::default_size_growth, "0.2"),
     "by how much the length grows per unit of length away from where the domain is finer than it")
    ("minimum-angle", po::value<double>()->default_value(defaults::default_minimum_angle),
     "smaller angles are refined, in degrees, but for those between two segments; 0: never")
    ("protect", po::value<std::string>()->default_value(""),
     "segments that get no new vertices and keep theirs: all, or the markers of those, such as 1,2")
    ("tolerance", po::value<double>(), "replace the outline by one with pieces as long as --size, within this share of "
                                       "it, such as 0.1")
    ("absolute-tolerance", po::value<double>(), "the same, within this length; if both are given the smaller one counts")
    ("min-island", po::value<double>()->default_value(0), "with --tolerance: drop islands with a smaller area")
    ("min-gap", po::value<double>()->default_value(0), "with --tolerance: fill where the domain is narrower")
    ("simplification-report", po::value<std::string>(), "with --tolerance: a text file with the places of what was "
                                                        "dropped and filled")
    ("largest-part", "of the parts of the domain that are not connected, mesh the largest only")
    ("paper", "the parameters of the paper instead of the defaults")
    ("rounds", po::value<int>()->default_value(defaults::default_number_of_rounds),
     "rounds of simulation at most; with --paper 6")
    ("iterations", po::value<int>()->default_value(defaults::default_number_of_iterations),
     "steps in a round at most; with --paper 250")
    ("max-bubbles", po::value<long>()->default_value(20000000), "refuse sizes that ask for more vertices")
    ("quiet,q", "no progress and no statistics");
  return options;
}

/// whether the outline is replaced by one within a tolerance
inline bool is_simplified(const po::variables_map& arguments)
{
  return arguments.count("tolerance") > 0 || arguments.count("absolute-tolerance") > 0;
}

/// \throws std::runtime_error if options do not go together
inline void check_mesh_options(const po::variables_map& arguments)
{
  if (arguments.count("gradation") > 0) {
    const double gradation = arguments["gradation"].as<double>();
    if (!(gradation > 0))
      throw std::runtime_error("--gradation must be positive");
    if (gradation > 1 && std::isfinite(gradation)) // infinity is refused elsewhere
      throw std::runtime_error("--gradation must be at most 1, and not a percentage: the length changes by no more "
                               "than the way");
  }
  if (is_simplified(arguments) && arguments.count("size") == 0)
    throw std::runtime_error("--tolerance and --absolute-tolerance need --size");
  if (is_simplified(arguments) && !arguments["protect"].defaulted())
    throw std::runtime_error("--protect does not go with --tolerance, which replaces the outline");
  if (!is_simplified(arguments) && arguments.count("simplification-report") > 0)
    throw std::runtime_error("--simplification-report needs --tolerance");
  if (!is_simplified(arguments) && !(arguments["min-island"].defaulted() && arguments["min-gap"].defaulted()))
    throw std::runtime_error("--min-island and --min-gap need --tolerance");
}

/// what the user asks for, else what `parameters` hold, else the default that --help shows
template <class Parameters, class Tag>
int count(const po::variable_value& argument, const Parameters& parameters, Tag tag)
{
  using namespace CGAL::parameters;
  if (!argument.defaulted())
    return argument.as<int>();
  return static_cast<int>(choose_parameter(get_parameter(parameters, tag), argument.as<int>()));
}

/// The segments of a domain that --protect names, as `npbs_relax()` takes them.
class Protected_segments
{
public:
  using key_type = std::pair<CDT::Vertex_handle, CDT::Vertex_handle>;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  /// \throws std::runtime_error if the option is no list of markers, or no segment has one of them
  Protected_segments(const Domain& domain, const std::string& option) : m_domain(&domain), m_all(option == "all")
  {
    if (m_all)
      return;
    m_markers = markers("--protect", option);
    check_markers(domain, "--protect", m_markers);
  }

  bool has_any() const { return m_all || !m_markers.empty(); }

  friend bool get(const Protected_segments& map, const key_type& edge)
  {
    return map.m_all || (!map.m_markers.empty() && map.m_markers.count(segment_marker(
                                                     *map.m_domain, edge.first->point(), edge.second->point())) > 0);
  }

private:
  const Domain* m_domain;
  bool m_all;
  std::set<int> m_markers;
};

/// what the options say, on top of `parameters`
template <class Parameters>
auto mesh_parameters(Domain& domain, const Region_map& regions, const po::variables_map& arguments,
                     const Parameters& parameters)
{
  namespace np = CGAL::internal_np;
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  return parameters.number_of_rounds(count(arguments["rounds"], parameters, np::number_of_rounds))
    .number_of_iterations(count(arguments["iterations"], parameters, np::number_of_iterations))
    .maximum_number_of_bubbles(arguments["max-bubbles"].as<long>())
    .size_growth(arguments["size-growth"].as<double>())
    .minimum_angle(arguments["minimum-angle"].as<double>())
    .vertex_is_constrained_map(Pinned(domain.pinned))
    .edge_marker_map(Segment_marker_map{&domain})
    .face_region_map(regions)
    .protect_constraints(Protected_segments(domain, arguments["protect"].as<std::string>()));
}

/// what npbs_relax says, in the words of the command line
inline std::string in_words_of_options(std::string text)
{
  const std::pair<std::string, std::string> words[] = {
    {"Bubble_relaxation_2: ", ""},
    {"maximum_number_of_bubbles", "--max-bubbles"},
    {"gradation", "--gradation"},
    {"size_growth", "--size-growth"},
    {"minimum_angle", "--minimum-angle"},
    {"relative_outline_tolerance", "--tolerance"},
    {"outline_tolerance", "--absolute-tolerance"},
    {"minimum_island_area", "--min-island"},
    {"minimum_gap", "--min-gap"},
    {"number_of_rounds", "--rounds"},
    {"number_of_iterations", "--iterations"},
    {"parameter --", "--"},
    {"the sizing function", "--size"}};
  for (const auto& word : words) {
    const std::size_t found = text.find(word.first);
    if (found != std::string::npos)
      text.replace(found, word.first.size(), word.second);
  }
  return text;
}

/// the input as messages call it
inline std::string input_name(const po::variables_map& arguments)
{
  const std::string input = arguments["input"].as<std::string>();
  return input == "-" ? "standard input" : input;
}

/// what --size asks for, if it is given
/// \throws std::runtime_error if that is not one formula, or --distance-to no list of markers, or of no use
inline std::optional<Size_formula> size_formula(const po::variables_map& arguments)
{
  const std::set<int> shore = markers("--distance-to", arguments["distance-to"].as<std::string>());
  std::optional<Size_formula> formula;
  if (arguments.count("size") > 0)
    formula.emplace(arguments["size"].as<std::string>(), raster_names(arguments), shore);
  if (!shore.empty() && !(formula && formula->has_distance()))
    throw std::runtime_error("--distance-to needs the variable distance in --size");
  return formula;
}

/// The size, limited as --gradation asks, and one by areas as --size-growth does at least: it jumps between regions.
/// \param callback of the field, whose refinement it may end
/// \throws std::runtime_error with the name of the input
inline Size limited_size(Domain& domain, const po::variables_map& arguments, const Size& size,
                         const std::function<bool(double)>& callback = nullptr)
try {
  using Limited = CGAL::Gradation_limited_sizing_field_2<CDT>;
  using Pinned = CGAL::Boolean_property_map<const std::set<CDT::Vertex_handle>>;
  const bool is_by_areas = size && arguments.count("size") == 0;
  if (arguments.count("gradation") == 0 && !is_by_areas)
    return size;
  const double g = arguments[arguments.count("gradation") > 0 ? "gradation" : "size-growth"].as<double>();
  if (!size)
    return Limited(domain.cdt, g, CGAL::Bubble_relaxation_parameters::vertex_is_constrained_map(Pinned(domain.pinned))
                                    .edge_marker_map(Segment_marker_map{&domain}).callback(callback));
  return Limited(domain.cdt, g, CGAL::Bubble_relaxation_parameters::sizing_function(size).callback(callback));
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

/// The sizes that --size asks for, or else areas of regions; nothing without both.
/// \throws std::runtime_error with the name of the input
inline Size wanted_size(const Domain& domain, const po::variables_map& arguments,
                        const std::optional<Size_formula>& formula)
try {
  return formula ? size_in_domain(*formula, domain) : size_by_areas(domain);
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

/// where the outline is finer than a tolerance can follow, or lengths are of another unit
inline void warn_of_lost_area(Domain& domain, const CGAL::Outline_simplification_report_2& report)
{
  constexpr double most = 0.2; // of the area
  if (std::abs(report.area - report.old_area) <= most * report.old_area)
    return;
  std::ostringstream text;
  text << "--tolerance and the rules change the area of the domain from " << report.old_area << " to " << report.area
       << "; is --size in the unit of the coordinates?";
  domain.warnings.push_back(text.str());
}

/// Replaces the outline by one within the tolerances. `tells`: whether it says and writes what it was replaced by
inline void simplify(Domain& domain, const po::variables_map& arguments, const Size_formula& formula, bool tells)
{
  const Size size = size_in_domain(formula, domain);
  const auto given = [&arguments](const char* option, double if_not_given) {
    return arguments.count(option) > 0 ? arguments[option].as<double>() : if_not_given;
  };
  const double share = given("tolerance", 1),
               length = given("absolute-tolerance", (std::numeric_limits<double>::max)());
  const auto report = simplify_domain(domain, CGAL::Bubble_relaxation_parameters::sizing_function(size)
                                                .relative_outline_tolerance(share)
                                                .outline_tolerance(length)
                                                .minimum_island_area(arguments["min-island"].as<double>())
                                                .minimum_gap(arguments["min-gap"].as<double>())
                                                .maximum_number_of_bubbles(arguments["max-bubbles"].as<long>()));
  warn_of_lost_area(domain, report);
  if (!report.filled_gaps.empty() && arguments.count("largest-part") == 0) {
    const std::vector<Connected_part> parts = connected_parts(domain.cdt);
    if (parts.size() > 1)
      domain.warnings.push_back(parts_message(parts));
  }
  if (!tells)
    return;
  if (arguments.count("quiet") == 0)
    std::cout << "outline\n" << report;
  if (arguments.count("simplification-report") > 0)
    write_simplification(arguments["simplification-report"].as<std::string>(), report);
}

/// Makes what is meshed of what was read: by --tolerance and --largest-part. Checks what the mesh's files need of the
/// boundary, before and after it.
/// \throws std::runtime_error with the name of the input
inline void prepare(Domain& domain, const po::variables_map& arguments, const std::optional<Size_formula>& formula,
                    const Output_tags& tags, bool tells = true)
try {
  tags.check_open(domain);
  if (is_simplified(arguments))
    simplify(domain, arguments, *formula, tells); // which needs --size
  if (arguments.count("largest-part") > 0)
    keep_largest_part(domain);
  tags.check_open(domain, " any more: --min-gap, --min-island, --tolerance or --largest-part took all of them");
  tags.check_depth(domain);
} catch (const std::exception& e) {
  throw std::runtime_error(input_name(arguments) + ": " + in_words_of_options(e.what()));
}

#endif // BUBBLE_RELAXATION_2_DEMO_MESH_OPTIONS_H
