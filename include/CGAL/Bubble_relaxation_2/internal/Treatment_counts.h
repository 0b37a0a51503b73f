// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_COUNTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_COUNTS_H

#include <cstddef>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What the treatment of defects did to a mesh: vertices that were moved, inserted and deleted.
struct Treatment_counts
{
  std::size_t treated = 0, inserted = 0, deleted = 0;

  Treatment_counts& operator+=(const Treatment_counts& c)
  {
    treated += c.treated;
    inserted += c.inserted;
    deleted += c.deleted;
    return *this;
  }

  template <class Report>
  void add_to(Report& report) const
  {
    report.number_of_treated_vertices += treated;
    report.number_of_insertions += inserted;
    report.number_of_deletions += deleted;
  }
};

/// Triangles with less than the first are operated on at first, and so on: angles of 38 degrees and less are in
/// triangles with less than the first.
constexpr double bad_qualities[] = {0.88, 0.8, 0.8, 0.8};

/// Operations are dear: so many are made at a time, at most.
inline std::size_t most_operations(std::size_t number_of_bubbles) { return 32 + number_of_bubbles / 1000; }

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREATMENT_COUNTS_H
