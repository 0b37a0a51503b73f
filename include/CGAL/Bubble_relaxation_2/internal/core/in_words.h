// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_IN_WORDS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_IN_WORDS_H

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace CGAL::Bubble_relaxation_2::internal {

/// A number as messages tell it: with as few digits as it takes to give back the very same number.
inline std::string in_words(double value)
{
  if (std::isnan(value))
    return "nan"; // not "-nan", as x86 makes it of 0/0
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), end.ptr);
}

/// a place as messages tell it
inline std::string in_words(double x, double y)
{
  return "(" + in_words(x) + ", " + in_words(y) + ")";
}

/// where to look, as reports tell it
inline std::string about_in_words(double x, double y)
{
  const auto about = [](double value) {
    constexpr int digits = 10; // millimetres of a map's coordinates
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return std::string(text.data(), end.ptr);
  };
  return "(" + about(x) + ", " + about(y) + ")";
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_IN_WORDS_H
