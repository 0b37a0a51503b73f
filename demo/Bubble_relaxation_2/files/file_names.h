// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_FILE_NAMES_H
#define BUBBLE_RELAXATION_2_DEMO_FILE_NAMES_H

#include <CGAL/Bubble_relaxation_2/internal/files/write_file.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// the ending of a file's name in lower case, with its dot
inline std::string extension(const std::string& name)
{
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

/// the name of a file without its ending
inline std::string without_extension(const std::string& name)
{
  return std::filesystem::path(name).replace_extension().string();
}

/// \throws std::runtime_error if the ending is none of the supported ones
inline void check_extension(const std::string& name, const std::vector<std::string>& supported)
{
  std::string list;
  for (const std::string& ending : supported) {
    if (extension(name) == ending)
      return;
    list += (list.empty() ? "" : ending == supported.back() ? " or " : ", ") + ending;
  }
  throw std::runtime_error(name + ": the ending must be " + list);
}

/// Tells that a file cannot be written before the work is done, not after it. Leaves what is there as it is.
/// \throws std::runtime_error with the name and the system's reason
inline void check_writable(const std::string& name)
{
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(name, ignored);
  errno = 0;
  if (!std::ofstream(name, std::ios::app))
    throw std::runtime_error(name + ": cannot be written: " + std::strerror(errno));
  if (!is_there)
    std::filesystem::remove(name, ignored);
}

/// \throws std::runtime_error if a file that `option` asks for is the input, or if it cannot be written
inline void check_output(const std::string& input, const std::string& file, const std::string& option)
{
  std::error_code ignored;
  if (std::filesystem::equivalent(input, file, ignored))
    throw std::runtime_error(file + ": is the input; give " + option + " another name");
  check_writable(file);
}

using CGAL::Bubble_relaxation_2::internal::write_file;

#endif // BUBBLE_RELAXATION_2_DEMO_FILE_NAMES_H
