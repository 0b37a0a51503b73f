// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// No include guard: see `disable_warnings.h`.

#if defined(__GNUC__) || defined(__clang__)
#  pragma GCC diagnostic pop
#endif
