// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// More of it, in a file of its own: both are compiled at the same time.

#include <CGAL/Bubble_relaxation_2/internal/outline_simplification/simplify_outline_impl.h>
