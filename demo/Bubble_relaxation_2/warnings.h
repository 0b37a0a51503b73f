// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_DEMO_WARNINGS_H
#define BUBBLE_RELAXATION_2_DEMO_WARNINGS_H

#include "files/domain.h"
#include "mesh_options.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

/// Tells warnings, and keeps them for `--statistics`.
class Warnings
{
public:
  Warnings(const std::string& program, const po::variables_map& arguments)
    : m_begin(program + ": warning: " + input_name(arguments) + ": ")
  {}

  void operator()(const std::string& text)
  {
    std::cerr << m_begin << text << '\n';
    m_all.push_back(text);
  }

  /// tells those of a domain that are not told yet
  void tell_of(Domain& domain)
  {
    for (const std::string& text : std::exchange(domain.warnings, {}))
      (*this)(text);
  }

  const std::vector<std::string>& all() const { return m_all; }

private:
  std::string m_begin;
  std::vector<std::string> m_all;
};

#endif // BUBBLE_RELAXATION_2_DEMO_WARNINGS_H
