// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_EXACT_PREDICATES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_EXACT_PREDICATES_H

#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <type_traits>

namespace CGAL::Bubble_relaxation_2::internal {

/// the points of a user's triangulation for exact predicates: those of an inexact kernel become points of ours
template <class Point_2>
decltype(auto) for_predicates(const Point_2& p)
{
  if constexpr (std::is_floating_point<std::decay_t<decltype(p.x())>>::value)
    return Point(p.x(), p.y());
  else
    return p;
}

/// whether three finite vertices are counterclockwise
template <class Vertex_handle>
bool is_counterclockwise(Vertex_handle a, Vertex_handle b, Vertex_handle c)
{
  return CGAL::orientation(for_predicates(a->point()), for_predicates(b->point()), for_predicates(c->point())) ==
         LEFT_TURN;
}

/// whether a vertex is in the circle of three others, which are counterclockwise
template <class Vertex_handle>
bool is_in_circle(Vertex_handle a, Vertex_handle b, Vertex_handle c, Vertex_handle v)
{
  return CGAL::side_of_oriented_circle(for_predicates(a->point()), for_predicates(b->point()),
                                       for_predicates(c->point()), for_predicates(v->point())) == ON_POSITIVE_SIDE;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ADAPTATION_EXACT_PREDICATES_H
