// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREAT_DEFECTS_H
#define CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREAT_DEFECTS_H

#include <CGAL/Bubble_relaxation_2/internal/Bubble_mesh_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Defect_surgery_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Defect_treatment_2.h>
#include <CGAL/Bubble_relaxation_2/internal/Phase_timer.h>
#include <CGAL/Bubble_relaxation_2/internal/Relaxation_options.h>
#include <CGAL/Bubble_relaxation_2/internal/place_bubbles.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Bubble_relaxation_2 {
namespace internal {

/// Moves vertices for the quality of their triangles. The smallest q never gets smaller.
template <class Concurrency_tag, class Report>
void smooth_defects(const Domain_2& domain, Bubble_mesh_2& mesh, Report& report)
{
  const Bubbles_2 untreated = mesh.bubbles;
  const double smallest = smallest_quality<Concurrency_tag>(mesh.triangulation);
  const std::vector<Index> moved =
    Defect_treatment_2<Concurrency_tag>(domain, mesh.triangulation, mesh.bubbles)();
  // the moves made none worse, but flips can
  if (smallest_quality<Concurrency_tag>(mesh.triangulation) < smallest) {
    mesh.bubbles = untreated;
    mesh.triangulation = triangulate(domain, mesh.bubbles);
  } else
    report.number_of_treated_vertices += moved.size();
}

/// Inserts and removes single bubbles where moving is not enough, as long as the smallest q gets larger.
template <class Concurrency_tag, class Report>
void operate_on_defects(const Domain_2& domain, Bubble_mesh_2& mesh, Report& report)
{
  constexpr int passes = 4;
  const std::size_t most = 32 + mesh.bubbles.size() / 1000; // operations are dear
  for (int pass = 0; pass < passes; ++pass) {
    Defect_surgery_2 surgery(domain, mesh);
    Bubbles_2 bubbles = surgery(most);
    if (bubbles.size() == 0)
      break;
    Bubble_mesh_2 changed{std::move(bubbles), {}};
    if (!try_to_triangulate(domain, changed.bubbles, changed.triangulation))
      break; // rounding made a mess of a change; what was there is good
    smooth_defects<Concurrency_tag>(domain, changed, report);
    if (smallest_quality(changed.triangulation) < smallest_quality(mesh.triangulation))
      break;
    mesh = std::move(changed);
    report.number_of_insertions += surgery.number_of_insertions;
    report.number_of_deletions += surgery.number_of_deletions;
  }
}

/// Treats the last defects of a mesh. The smallest q never gets smaller.
template <class Concurrency_tag, class Sizing, class Report>
void treat_defects(const Domain_2& domain, const Sizing& sizing, const Relaxation_options& options,
                   Bubble_mesh_2& mesh, Report& report)
{
  smooth_defects<Concurrency_tag>(domain, mesh, report);
  if (options.population != Bubble_population::NONE)
    operate_on_defects<Concurrency_tag>(domain, mesh, report);
  Bubbles_2& b = mesh.bubbles;
  for (std::size_t i = 0; i < b.size(); ++i)
    if (b.can_move(i))
      b.d[i] = sizing(b.x[i], b.y[i]);
}

/// All bubbles were given by the user: then the mesh that they made is the result if its smallest q is
/// larger, treated too, unless d asked for more or fewer bubbles.
template <class Concurrency_tag, class Cdt, class Sizing, class Report>
void keep_the_better(const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                     const Relaxation_options& options, Bubble_mesh_2& mesh, Report& report)
{
  constexpr double same_number = 0.05;
  Bubble_mesh_2 given;
  given.bubbles = given_bubbles<Concurrency_tag>(reading, sizing);
  const double before = double(given.bubbles.size()), after = double(mesh.bubbles.size());
  if (std::abs(after - before) > same_number * before)
    return;
  given.triangulation = triangulate(reading.domain, given.bubbles);
  if (smallest_quality(given.triangulation) <= smallest_quality(mesh.triangulation))
    return;
  treat_defects<Concurrency_tag>(reading.domain, sizing, options, given, report);
  mesh = std::move(given);
}

/// whether there is a result of a simulation to be treated
template <class Report>
bool is_treatment_due(const Relaxation_options& options, const Report& report)
{
  return options.defect_treatment && report.number_of_steps != 0 &&
         report.stop_reason != Bubble_stop_reason::STOPPED_BY_CALLBACK;
}

/// The triangulation of the simulated bubbles, and what is done to it before it is written.
template <class Concurrency_tag, class Cdt, class Sizing, class Report>
Bubble_mesh_2 make_mesh(const Domain_reading_2<Cdt>& reading, const Sizing& sizing,
                        const Relaxation_options& options, Bubbles_2 bubbles, Report& report)
{
  const Phase_timer timer(report.seconds.treatment);
  Bubble_mesh_2 mesh{std::move(bubbles), {}};
  mesh.triangulation = triangulate(reading.domain, mesh.bubbles);
  if (!is_treatment_due(options, report))
    return mesh;
  treat_defects<Concurrency_tag>(reading.domain, sizing, options, mesh, report);
  if (keeps_given_bubbles(options))
    keep_the_better<Concurrency_tag>(reading, sizing, options, mesh, report);
  return mesh;
}

} // namespace internal
} // namespace Bubble_relaxation_2
} // namespace CGAL

#endif // CGAL_BUBBLE_RELAXATION_2_INTERNAL_TREAT_DEFECTS_H
