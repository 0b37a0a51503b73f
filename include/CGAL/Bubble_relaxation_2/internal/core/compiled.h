// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_COMPILED_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_COMPILED_H

// What is compiled once is declared in headers, and defined in headers whose names end in `_impl.h`. A program that is
// linked with the compiled core (target `CGAL::Bubble_relaxation_2_core`) sees declarations only.
#ifdef CGAL_BUBBLE_RELAXATION_2_COMPILED
#define CGAL_BUBBLE_RELAXATION_2_INLINE
#else
#define CGAL_BUBBLE_RELAXATION_2_INLINE inline
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_COMPILED_H
