// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Outline_markers_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/Simplified_outline_2.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/read_outline.h>
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/write_outline.h>

namespace CGAL::Bubble_relaxation_2::internal {

/// The stages of `CGAL::simplify_outline_2()` between reading and writing, without the user's types.
CGAL_BUBBLE_RELAXATION_2_INLINE
Simplified_outline_2 simplify_outline(const Simplification_problem_2& problem);

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/simplify_outline_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_OUTLINE_SIMPLIFICATION_SIMPLIFY_OUTLINE_H
