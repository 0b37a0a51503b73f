// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_IMPL_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_IMPL_H

#include <CGAL/Bubble_relaxation_2/internal/core/parallel_for.h>
#include <CGAL/Bubble_relaxation_2/internal/corners/Cut_domain_2.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/fields/Interpolated_field_2.h>
#include <CGAL/Bubble_relaxation_2/internal/geometry/Neighbor_sets_2.h>
#include <CGAL/Bubble_relaxation_2/internal/placement/place_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/quality/evaluate.h>
#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/sizes/Outline_sizes_2.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Bubble_relaxation_2::internal {

CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 sizes_of_mesh(const Triangulation_copy_2& mesh)
{
  return Sizes_2(mean_edge_length_field(mesh, growth_in_mesh));
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 sizes_of_domain(const Domain_2& domain, const Given_mesh_2& given, double growth)
{
  return Sizes_2(Outline_field_2(sizes_of_pieces(domain, &given.on_edge), domain.bbox(), growth));
}

/// A part is to go on beyond its rim. But what the user protects may be far too long, and he still wants his sizes, as
/// soon as a mesh can have them.
inline double growth_from_protected(double growth)
{
  constexpr double steep = Report::steep_size_gradient;
  return (std::max)(growth, steep);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Sizes_2 no_finer_than_edges(const Domain_2& domain, const Given_mesh_2& given, const Sizes_2& wanted, double growth)
{
  return raise_beside_edges(domain, given, raise_beside_edges(domain, given, wanted, Edge_kind::RIM, growth),
                            Edge_kind::PROTECTED, growth_from_protected(growth));
}

/// A given mesh is far finer than sizes ask for, and none of its vertices may go: then the ratios of sizes count, and all of
/// them get smaller. Else each bubble would push all others near by, thousands of them.
inline void make_room_for_all(const Domain_2& domain, const Given_mesh_2& given, const Relaxation_options& options,
                              Sizes_2& sizes)
{
  if (!keeps_given_bubbles(options) || options.population != Bubble_population::NONE || options.number_of_rounds == 0 ||
      given.free.size() > options.maximum_number_of_bubbles)
    return;
  const double number = static_cast<double>(given.free.size());
  const Sizes_2 wanted = sizes;
  double factor = 1;
  // several times, since what large sizes ask for is at least the ends of edges
  for (double many = 4; number > many * sizes.expected_number; many = 1.1) {
    factor *= std::sqrt(sizes.expected_number / number);
    sizes = scaled(wanted, factor);
    Expected_number_of_bubbles count(domain, sizes, 2 * number);
    sizes.expected_number = count();
    sizes.number_without_corners = count.without_corners();
  }
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Limits_of_outline_2 limit_by_outline(const Domain_2& domain, Given_mesh_2& given, Sizes_2& wanted,
                                     const Relaxation_options& options, bool may_limit)
{
  constexpr int turns = 1, turns_beyond_circles = 2;
  const std::size_t maximum = options.maximum_number_of_bubbles;
  const double growth = options.size_growth;
  const auto count = [&](const Domain_2& where, const char* asking, Sizes_2& sizes) {
    if (options.counts_bubbles)
      count_bubbles(where, maximum, asking, sizes);
  };
  count(domain, "the domain and the sizing function", wanted);
  if (options.counts_bubbles)
    make_room_for_all(domain, given, options, wanted);
  const bool has_protected = std::any_of(domain.edges().begin(), domain.edges().end(),
                                         [](const Domain_edge_2& e) { return e.kind == Edge_kind::PROTECTED; });
  const auto raised = [&](const Sizes_2& sizes) {
    return has_protected ? raise_along_protected(domain, sizes, growth_from_protected(growth)) : sizes;
  };
  if (!may_limit) {
    Sizes_2 sizes = raised(wanted);
    if (has_protected)
      count(domain, sizes_and_outline, sizes);
    return {sizes, nullptr, nullptr, sizes};
  }
  Limited_sizes_2 limited(wanted, domain.bbox(), growth);
  Outline_sizes_2(domain, given, maximum, limited)(turns);
  const Sizes_2 before_cut = raised(limited.sizes());
  const auto cut = cut_corners(domain, before_cut, growth, given.pinned);
  if (cut != nullptr)
    cut->cut(given);
  const Domain_2& rest = cut ? cut->domain() : domain;
  Outline_sizes_2 of_rest(rest, given, maximum, limited);
  if (cut != nullptr)
    of_rest.add_chords(cut->narrow_chords());
  of_rest(turns_beyond_circles);
  Sizes_2 sizes = raised(limited.sizes());
  if (limited.is_limited() || has_protected)
    count(rest, sizes_and_outline, sizes);
  return {sizes, cut, cut ? &rest : nullptr, before_cut};
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Bubbles_2 make_nodes(const Problem_2& problem, Report& report)
{
  tell_of_input(problem, report);
  Bubbles_2 bubbles = relax_bubbles(problem, report);
  if (is_treatment_due(problem.options, report))
    bubbles = triangulate_and_treat(problem, std::move(bubbles), report).bubbles;
  // the simulation does not ask d again for every little displacement
  parallel_for(problem.options.threads, bubbles.size(),
               [&](std::size_t i) { bubbles.d[i] = problem.sizes(bubbles.x[i], bubbles.y[i]); });
  if (problem.cut != nullptr)
    problem.cut->join(bubbles);
  return bubbles;
}

CGAL_BUBBLE_RELAXATION_2_INLINE
Bubble_mesh_2 make_mesh(const Problem_2& problem, Report& report)
{
  Bubble_mesh_2 mesh = triangulate_and_treat(problem, relax_bubbles(problem, report), report);
  problem.options.progress->start_phase(Bubble_phase::EVALUATION); // nothing is left undone from here on
  if (problem.cut != nullptr) {
    const Phase_timer timer(report.seconds.evaluation);
    problem.cut->join(mesh);
  }
  evaluate(mesh, problem, report);
  return mesh;
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void make_mesh_without(const std::vector<Index>& those, const Problem_2& problem, Bubble_mesh_2& mesh, Report& report)
{
  for (Index i : those)
    mesh.bubbles.remove(static_cast<std::size_t>(i));
  mesh.bubbles.forget_gone();
  report.number_of_deletions += those.size();
  triangulate(problem.whole_domain(), mesh);
  evaluate(mesh, problem, report);
}

CGAL_BUBBLE_RELAXATION_2_INLINE
void find_neighbors(const Bubbles_2& bubbles, double radius, const Threads& threads, std::vector<std::size_t>& offsets,
                    std::vector<std::int32_t>& neighbors)
{
  Neighbor_sets_2 sets(radius);
  sets.build(bubbles, threads);
  std::size_t all = 0;
  for (std::size_t i = 0; i < bubbles.size(); ++i)
    all += static_cast<std::size_t>(sets.end(i) - sets.begin(i));
  neighbors.reserve(all); // to copy what there is takes longer than the callback may wait
  offsets.assign(1, 0);
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    tick(i);
    neighbors.insert(neighbors.end(), sets.begin(i), sets.end(i));
    offsets.push_back(neighbors.size());
  }
}

} // namespace CGAL::Bubble_relaxation_2::internal

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_ENGINE_ENGINE_IMPL_H
