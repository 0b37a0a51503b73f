// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// No include guard: each public header begins with this one and ends with `enable_warnings.h`, as CGAL's do.
//
// Indices are signed, as those of MPI and of Eigen, and arrays of the standard library want unsigned ones. A cast
// wherever an array is indexed would hide more mistakes than it shows.

#if defined(__GNUC__) || defined(__clang__)
#  pragma GCC diagnostic push
#  pragma GCC diagnostic ignored "-Wsign-conversion"
#endif
