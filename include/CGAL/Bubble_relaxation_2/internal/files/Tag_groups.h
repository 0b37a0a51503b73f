// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_TAG_GROUPS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_TAG_GROUPS_H

#include <CGAL/Bubble_relaxation_2/internal/core/in_words.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

/// Markers or regions as the positive integers that formats want, the same numbers wherever they are that: others, 0
/// too, come after the largest, with their values as names.
class Tag_groups
{
public:
  struct Group
  {
    int number;
    std::size_t place; ///< among the groups in the order of their values, from 0
    std::string name;  ///< empty if there is none
  };

  /// `names`: of values
  template <class Number>
  Tag_groups(const std::vector<Number>& values, const std::map<Number, std::string>& names)
  {
    int largest = 0;
    for (const Number& value : values) {
      const bool is_group = is_number_of_group(static_cast<double>(value));
      const int number = is_group ? static_cast<int>(value) : -1;
      m_groups.insert({static_cast<double>(value), {number, 0, is_group ? "" : in_words(static_cast<double>(value))}});
      largest = number > largest ? number : largest;
    }
    std::size_t place = 0;
    for (auto& g : m_groups) {
      if (g.second.number < 0)
        g.second.number = ++largest;
      g.second.place = place++;
    }
    for (const auto& name : names) {
      const auto found = m_groups.find(static_cast<double>(name.first));
      if (found != m_groups.end())
        found->second.name = name.second;
    }
  }

  const Group& operator()(double value) const { return m_groups.at(value); }

  /// by their values
  const std::map<double, Group>& all() const { return m_groups; }

private:
  static bool is_number_of_group(double value)
  {
    return value >= 1 && value <= 2e9 && value == static_cast<double>(static_cast<int>(value));
  }

  std::map<double, Group> m_groups;
};

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_FILES_TAG_GROUPS_H
