// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_MARKER_LIST_H
#define BUBBLE_RELAXATION_2_DEMO_MARKER_LIST_H

#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

inline double number(const std::string& option, const std::string& text)
{
  std::istringstream in(text);
  double value = 0;
  if (!(in >> value) || !(in >> std::ws).eof())
    throw std::runtime_error(option + ": '" + text + "' is not a number");
  return value;
}

inline int integer(const std::string& option, const std::string& text)
{
  const double value = number(option, text);
  if (value != std::floor(value) || std::abs(value) > 2e9)
    throw std::runtime_error(option + ": the marker '" + text + "' must be an integer");
  return static_cast<int>(value);
}

/// the markers of a list such as 1,2
/// \throws std::runtime_error if one is no integer
inline std::set<int> markers(const std::string& option, const std::string& text)
{
  std::set<int> result;
  std::istringstream list(text.empty() ? text : text + ','); // one ends each marker
  for (std::string marker; std::getline(list, marker, ',');)
    result.insert(integer(option, marker));
  return result;
}

#endif // BUBBLE_RELAXATION_2_DEMO_MARKER_LIST_H
