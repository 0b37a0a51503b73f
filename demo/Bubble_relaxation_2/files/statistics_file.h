// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_STATISTICS_FILE_H
#define BUBBLE_RELAXATION_2_DEMO_STATISTICS_FILE_H

#include "file_names.h"

#include <CGAL/Bubble_relaxation_report_2.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// What is printed of a mesh as JSON, for scripts.

/// with all digits; JSON has no number that is not finite
inline std::string in_json(double value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return std::isfinite(value) ? text.str() : "null";
}

inline std::string place_in_json(double x, double y) { return '[' + in_json(x) + ", " + in_json(y) + ']'; }

/// how many bytes from `k` on are one character of UTF-8, 0 if they are none: names of files may be of any
inline std::size_t length_of_character(const std::string& text, std::size_t k)
{
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : 0); };
  const unsigned first = byte(k), second = byte(k + 1);
  const std::size_t length =
    first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i)
    if (byte(k + i) < 0x80 || byte(k + i) > 0xbf)
      return 0;
  const bool is_too_long = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90),
             is_beyond = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return is_too_long || is_beyond ? 0 : length;
}

inline std::string in_json(const std::string& text)
{
  std::string result = "\"";
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = length_of_character(text, k);
    if (text[k] == '"' || text[k] == '\\') {
      result += std::string("\\") + text[k];
    } else if (length == 1 && static_cast<unsigned char>(text[k]) < ' ') {
      char code[16];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(text[k]));
      result += code;
    } else {
      result += length > 0 ? text.substr(k, length) : "?";
    }
    k += length > 0 ? length : 1;
  }
  return result + '"';
}

/// an object of members with their values in JSON
inline std::string object_in_json(const std::vector<std::pair<std::string, std::string>>& members)
{
  std::string result;
  for (const auto& member : members)
    result += (result.empty() ? "{\"" : ", \"") + member.first + "\": " + member.second;
  return result + '}';
}

/// triangles with small angles, and where the smallest is
inline std::string small_angles_in_json(std::size_t number, double x, double y)
{
  return object_in_json(
    {{"number", std::to_string(number)}, {"smallest_at", number > 0 ? place_in_json(x, y) : "null"}});
}

/// the members of the file
inline std::vector<std::pair<std::string, std::string>>
statistics_in_json(const CGAL::Bubble_relaxation_report_2<double>& report)
{
  const char* const reasons[] = {"converged", "iteration limit", "interrupted"};
  const CGAL::Mesh_quality_2<double>& q = report.quality;
  const std::string length_over_d = object_in_json({{"mean", in_json(q.mean_length_ratio())},
                                                    {"deviation", in_json(q.length_ratio_deviation())},
                                                    {"percent_1", in_json(q.length_ratio_percentile(1))},
                                                    {"percent_99", in_json(q.length_ratio_percentile(99))}});
  return {{"vertices", std::to_string(report.number_of_vertices)},
          {"triangles", std::to_string(report.number_of_triangles)},
          {"vertices_that_d_alone_asks_for", std::to_string(report.number_of_wanted_vertices)},
          {"radius_ratio", object_in_json({{"mean", in_json(q.mean_quality())},
                                           {"smallest", in_json(q.minimum_quality())},
                                           {"smallest_at", place_in_json(q.worst_x(), q.worst_y())},
                                           {"percent_1", in_json(q.quality_percentile(1))},
                                           {"percent_10", in_json(q.quality_percentile(10))},
                                           {"median", in_json(q.quality_percentile(50))}})},
          {"angle",
           object_in_json({{"smallest", in_json(q.minimum_angle())}, {"largest", in_json(q.maximum_angle())}})},
          {"obtuse_triangles", std::to_string(q.number_of_obtuse_triangles())},
          {"interior_vertices", std::to_string(q.number_of_interior_vertices())},
          {"share_not_of_degree_6", in_json(q.irregular_share())},
          {"edge", object_in_json({{"shortest", in_json(q.shortest_edge())}, {"longest", in_json(q.longest_edge())}})},
          {"length_over_d", q.has_length_ratios() ? length_over_d : "null"},
          {"change_of_d_per_length",
           object_in_json({{"largest", in_json(report.largest_size_gradient)},
                           {"largest_at", report.largest_size_gradient > 0
                                            ? place_in_json(report.steepest_x, report.steepest_y)
                                            : "null"},
                           {"share_of_steep_edges", in_json(report.steep_share)}})},
          {"small_angles_at_sharp_corners",
           small_angles_in_json(report.number_of_forced_triangles, report.forced_x, report.forced_y)},
          {"small_angles_elsewhere",
           small_angles_in_json(report.number_of_small_angles, report.small_x, report.small_y)},
          {"steps", std::to_string(report.number_of_steps)},
          {"converged", report.converged ? "true" : "false"},
          {"stop_reason", in_json(std::string(reasons[static_cast<int>(report.stop_reason)]))},
          {"seconds", in_json(report.seconds.total())}};
}

/// Writes the statistics of a mesh, the warnings and the exit code of the program, a line each.
/// \throws std::runtime_error with the name and the system's reason
inline void write_statistics(const std::string& name, const CGAL::Bubble_relaxation_report_2<double>& report,
                             const std::vector<std::string>& warnings, int exit_code)
{
  write_file(name, [&](std::ostream& out) {
    out << '{';
    for (const auto& member : statistics_in_json(report))
      out << "\n  \"" << member.first << "\": " << member.second << ',';
    out << "\n  \"warnings\": [";
    for (std::size_t k = 0; k < warnings.size(); ++k)
      out << (k > 0 ? ",\n    " : "\n    ") << in_json(warnings[k]);
    out << (warnings.empty() ? "],\n" : "\n  ],\n") << "  \"exit_code\": " << exit_code << "\n}\n";
  });
}

#endif // BUBBLE_RELAXATION_2_DEMO_STATISTICS_FILE_H
