// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What ranks do together between reading and writing, for this project's own programs.

#include <CGAL/Bubble_relaxation_2/internal/distributed/engine/distributed_engine_impl.h>
