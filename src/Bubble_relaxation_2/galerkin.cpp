// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The element-free Galerkin method, for this project's own programs.

#include <CGAL/Bubble_relaxation_2/internal/meshless/galerkin/Galerkin_method_2_impl.h>
