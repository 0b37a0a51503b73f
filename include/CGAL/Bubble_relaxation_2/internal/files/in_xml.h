// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_IN_XML_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_IN_XML_H

#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

/// a text as the value of an attribute; characters that XML has not are question marks
inline std::string in_xml(const std::string& text)
{
  std::string result;
  for (char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n' || c == '\t' || c == '\r')
      result += "&#" + std::to_string(static_cast<int>(c)) + ';';
    else
      result += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  }
  return result;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_IN_XML_H
