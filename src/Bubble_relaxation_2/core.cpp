// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// What the headers declare for programs that are linked with the compiled core.

#include <CGAL/Bubble_relaxation_2/internal/domain/Domain_marks_2_impl.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine_impl.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/mark_triangulation_impl.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/print_mesh_quality_impl.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_domain_impl.h>
