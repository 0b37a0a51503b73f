// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NPBS_PLACE_NODES_H
#define CGAL_NPBS_PLACE_NODES_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/relaxation/relax_bubbles.h>
#include <CGAL/Bubble_relaxation_2/internal/treatment/treat_defects.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/write_nodes.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/node_set_2.h>

#include <cstddef>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief places nodes in the domain of a constrained Delaunay triangulation by bubble simulation, and returns
them with their neighbour sets. The triangulation is not changed, and no mesh is kept; one is made on the way
for the population control `DELAUNAY` and for `defect_treatment`, both of which are defaults.

\tparam CDT as in `npbs_relax()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param cdt the triangulation that bounds the domain
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those of `npbs_relax()`

\throws std::invalid_argument, std::length_error as `npbs_relax()`

\sa `npbs_relax()`
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto npbs_place_nodes(const CDT& cdt, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using Point_2 = typename CDT::Geom_traits::Point_2;

  Node_set_2<Point_2> nodes;
  const Relaxation_options options = read_options(np);
  Progress progress(options.callback, options.number_of_rounds);
  Phase_timer reading_time(nodes.report.seconds.reading);
  const Domain_marks_2<CDT> is_inside(cdt, np);
  const auto reading = read_domain(cdt, np, is_inside);
  with_limited_sizing_field(cdt, np, is_inside, *reading, options, [&](const auto& sizing,
                                                                       const auto&) {
    reading_time.stop();
    using Tag = Concurrency<NamedParameters>;
    Bubbles_2 bubbles =
      simulate_bubbles<Tag>(cdt, *reading, sizing, options, progress, nodes.report);
    if (is_treatment_due(options, nodes.report))
      bubbles =
        make_mesh<Tag>(*reading, sizing, options, std::move(bubbles), nodes.report).bubbles;
    // the simulation does not ask d again for every little displacement
    parallel_for<Tag>(bubbles.size(),
                      [&](std::size_t i) { bubbles.d[i] = sizing(bubbles.x[i], bubbles.y[i]); });
    copy_nodes<Tag>(bubbles, options.neighbor_radius, nodes);
  });
  nodes.report.number_of_vertices = nodes.size();
  progress.report(1);
  return nodes;
}

} // namespace CGAL

#endif // CGAL_NPBS_PLACE_NODES_H
