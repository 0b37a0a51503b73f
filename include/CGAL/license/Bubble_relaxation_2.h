// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_LICENSE_BUBBLE_RELAXATION_2_H
#define CGAL_LICENSE_BUBBLE_RELAXATION_2_H

// As in CGAL: users without a commercial licence can be warned, or stopped, where they use packages
// under the GPL. This package is under the GPL only.

#ifdef CGAL_LICENSE_WARNING
#  if defined(__GNUC__) || defined(__clang__)
#    pragma GCC warning "Bubble_relaxation_2 is used under the terms of the GPL, version 3 or later."
#  endif
#endif

#ifdef CGAL_LICENSE_ERROR
#  error "Bubble_relaxation_2 can be used under the terms of the GPL, version 3 or later, only."
#endif

#endif // CGAL_LICENSE_BUBBLE_RELAXATION_2_H
