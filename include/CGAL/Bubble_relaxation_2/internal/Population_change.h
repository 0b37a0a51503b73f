// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H

#include <CGAL/Bubble_relaxation_2/internal/Bubbles_2.h>

#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Bubbles that a population control wants to delete and to insert.
struct Population_change
{
  std::vector<Index> deleted;
  Bubbles_2 inserted;

  bool is_empty() const { return deleted.empty() && inserted.size() == 0; }
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_POPULATION_CHANGE_H
