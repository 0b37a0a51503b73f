// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_EXAMPLES_WRITE_SVG_H
#define BUBBLE_RELAXATION_2_EXAMPLES_WRITE_SVG_H

#include "file_names.h"

#include <ostream>
#include <string>

/// Writes elements of SVG as a picture on a white ground.
inline void write_svg(const std::string& file_name, double width, double height, const std::string& elements)
{
  write_file(file_name, [&](std::ostream& out) {
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << height
        << "\" width=\"" << width << "\" height=\"" << height << "\" font-family=\"sans-serif\">\n"
        << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << elements << "</svg>\n";
  });
}

#endif // BUBBLE_RELAXATION_2_EXAMPLES_WRITE_SVG_H
