// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_IN_QUOTES_H
#define BUBBLE_RELAXATION_2_DEMO_IN_QUOTES_H

#include <algorithm>
#include <cstddef>
#include <string>

/// What a file has where a number or a word should be, for messages. It may be any file: only the beginning, and
/// question marks for what would change a terminal.
inline std::string in_quotes(const std::string& text)
{
  constexpr std::size_t longest = 40;
  std::string shown = text.substr(0, longest);
  std::replace_if(shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + shown + (text.size() > longest ? "...'" : "'");
}

#endif // BUBBLE_RELAXATION_2_DEMO_IN_QUOTES_H
