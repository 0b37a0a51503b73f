// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What the headers declare for programs on several ranks that are linked with the compiled part of these.

#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine_impl.h>
