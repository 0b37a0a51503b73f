// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H

#include <CGAL/Bubble_relaxation_2/internal/core/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Given_mesh_2.h>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// What is to be done, without the user's types. It refers to what was read.
struct Problem_2
{
  const Domain_2& domain;
  const Given_mesh_2& given;
  const Relaxation_options& options;
  Sizes_2 wanted; ///< by the user
  Sizes_2 sizes;  ///< that the simulation follows: smaller where the outline asks for it
};

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_DOMAIN_PROBLEM_2_H
