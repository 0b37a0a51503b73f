// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_ARITHMETIC_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_ARITHMETIC_H

#include <cfloat>

// Meshes are the same on every machine where each operation is rounded to double by itself, as IEEE 754 has it. A
// compiler that is told otherwise is told here. g++ tells by __GCC_IEC_559 of parts of -ffast-math, too; clang does
// not.

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
  (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0) || defined(_M_FP_FAST)
#  error "Bubble_relaxation_2: compile without -ffast-math, -Ofast, /fp:fast and parts of them: bits would depend on it"
#endif

#if FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2
#  error "Bubble_relaxation_2: double is computed with more digits (x87): compile with -msse2 -mfpmath=sse"
#endif

// What may be fused cannot be asked. The target of CMake turns it off, and says so by this macro.
#if !defined(CGAL_BUBBLE_RELAXATION_2_NO_CONTRACTION) && \
  (defined(__FMA__) || defined(__FMA4__) || defined(__FP_FAST_FMA) || defined(__ARM_FEATURE_FMA))
#  pragma message("Bubble_relaxation_2: for the same bits on every machine compile with -ffp-contract=off, with g++ " \
                  "12.0 to 12.2 also with -fno-tree-slp-vectorize; -DCGAL_BUBBLE_RELAXATION_2_NO_CONTRACTION ends " \
                  "this note")
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_CORE_CHECK_ARITHMETIC_H
