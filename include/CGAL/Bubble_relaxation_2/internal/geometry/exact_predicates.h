// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EXACT_PREDICATES_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EXACT_PREDICATES_H

#include <CGAL/Bubble_relaxation_2/internal/core/Plane_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>

#include <CGAL/Kernel/global_functions_2.h>

#include <type_traits>

namespace CGAL::Bubble_relaxation_2::internal {

/// the places of a user's vertices for exact predicates: those of an inexact kernel become points of ours
template <class Cdt>
decltype(auto) for_predicates(typename Cdt::Vertex_handle v)
{
  using Plane = Plane_2<Cdt>;
  if constexpr (std::is_floating_point<typename Cdt::Geom_traits::FT>::value)
    return Point(Plane::x(v->point()), Plane::y(v->point()));
  else
    return Plane::place(v->point());
}

/// whether three finite vertices are counterclockwise
template <class Cdt, class Vertex_handle = typename Cdt::Vertex_handle>
bool is_counterclockwise(Vertex_handle a, Vertex_handle b, Vertex_handle c)
{
  return CGAL::orientation(for_predicates<Cdt>(a), for_predicates<Cdt>(b), for_predicates<Cdt>(c)) == LEFT_TURN;
}

/// whether a vertex is in the circle of three others, which are counterclockwise
template <class Cdt, class Vertex_handle = typename Cdt::Vertex_handle>
bool is_in_circle(Vertex_handle a, Vertex_handle b, Vertex_handle c, Vertex_handle v)
{
  return CGAL::side_of_oriented_circle(for_predicates<Cdt>(a), for_predicates<Cdt>(b), for_predicates<Cdt>(c),
                                       for_predicates<Cdt>(v)) == ON_POSITIVE_SIDE;
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_GEOMETRY_EXACT_PREDICATES_H
