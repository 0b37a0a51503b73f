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

#include <fstream>
#include <iostream>

/// Reads .poly, .wkt, or .node and .ele, by the ending of the name.
/// \param name of the file, "-" for standard input
/// \param format "poly" or "wkt" instead of the ending, if it is not empty
/// \throws std::runtime_error with the name and the place
inline Domain read_domain_file(const std::string& name, const std::string& format)
{
  const bool is_standard_input = name == "-";
  if (!format.empty() && format != "poly" && format != "wkt")
    throw std::runtime_error("--format: '" + format + "' must be poly or wkt");
  if (is_standard_input && format.empty())
    throw std::runtime_error("standard input needs --format poly or --format wkt");
  const std::string ending = format.empty() ? extension(name) : "." + format;
  if (format.empty())
    check_extension(name, {".poly", ".wkt", ".node", ".ele"});
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
