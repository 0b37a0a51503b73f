// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_H

#include <CGAL/Bubble_relaxation_2/internal/core/Sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/core/vocabulary.h>
#include <CGAL/Bubble_relaxation_2/internal/domain/Problem_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Marked_triangulation_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/flatten_triangulation.h>

#include <CGAL/Bubble_relaxation_report_2.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bubble_relaxation_2::internal {

// What lies between reading and writing, without the user's types: it is compiled once.

/// The most that sizes of a mesh grow per unit of length. Those of refined Delaunay triangulations double from edge to
/// edge, and no packing follows; our own meshes grow by less than that.
constexpr double growth_in_mesh = 0.5;

/// the sizes of the edges of a mesh in its domain, which hardly grow faster than that
CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 sizes_of_mesh(const Triangulation_copy_2& mesh);

/// the sizes that the outline of a domain without mesh asks for
CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 sizes_of_domain(const Domain_2& domain, const Given_mesh_2& given, double growth);

/// The wanted sizes, and larger ones beside edges that take no bubbles and are far longer.
CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 no_finer_than_edges(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& wanted, double growth);

/// What the simulation follows and where it is made.
struct Limits_of_outline_2
{
  Sizes_2 sizes;                           ///< the wanted ones, and smaller ones where the outline asks for it
  std::shared_ptr<const Cut_domain_2> cut; ///< what is cut off, if any corner is sharp
  const Domain_2* domain;                  ///< what is left of the domain then
  Sizes_2 before_cut;                      ///< those by which it was cut, of the whole domain
};

/// Counts the bubbles that `wanted` sizes ask for, and makes sizes smaller and cuts corners off where the outline asks
/// for it, if it may; then `given` becomes what is given for the domain that is left.
/// \throws std::length_error if sizes ask for too many bubbles
CGAL_BUBBLE_RELAXATION_2_INLINE
Limits_of_outline_2 limit_by_outline(const Domain_2& domain, Given_mesh_2& given, Sizes_2& wanted,
                                     const Relaxation_options& options, bool may_limit);

/// the bubbles after placement, simulation and treatment
CGAL_BUBBLE_RELAXATION_2_INLINE
Bubbles_2 make_nodes(const Problem_2& problem, Report& report);

/// the same with their triangulation, whose statistics are in the report
CGAL_BUBBLE_RELAXATION_2_INLINE
Bubble_mesh_2 make_mesh(const Problem_2& problem, Report& report);

/// deletes bubbles of such a mesh, and makes it anew
CGAL_BUBBLE_RELAXATION_2_INLINE
void make_mesh_without(const std::vector<Index>& those, const Problem_2& problem, Bubble_mesh_2& mesh, Report& report);

/// The bubbles nearer to each other than `radius` times the mean of both sizes: those of bubble i are
/// `neighbors[offsets[i]]` up to, without, `neighbors[offsets[i + 1]]`.
CGAL_BUBBLE_RELAXATION_2_INLINE
void find_neighbors(const Bubbles_2& bubbles, double radius, const Threads& threads, std::vector<std::size_t>& offsets,
                    std::vector<std::int32_t>& neighbors);

} // namespace CGAL::Bubble_relaxation_2::internal

#ifndef CGAL_BUBBLE_RELAXATION_2_COMPILED
#include <CGAL/Bubble_relaxation_2/internal/engine/engine_impl.h>
#endif

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_H
