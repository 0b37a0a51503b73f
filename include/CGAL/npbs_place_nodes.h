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

#include <CGAL/Bubble_relaxation_2/internal/core/disable_warnings.h>

#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/check_call.h>
#include <CGAL/Bubble_relaxation_2/internal/engine/engine.h>
#include <CGAL/Bubble_relaxation_2/internal/reading/read_input.h>
#include <CGAL/Bubble_relaxation_2/internal/writing/write_nodes.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/node_set_2.h>


namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief places nodes in the domain of a constrained Delaunay triangulation by bubble simulation, and returns
them with their neighbour sets. The triangulation is not changed, and no mesh is kept; one is made on the way
for the population control `DELAUNAY` and for `defect_treatment`, both of which are defaults. Nodes of a terrain are
points in space.

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
  using Nodes = Node_set_2<typename CDT::Geom_traits::Point_2>;
  return call_checked<CDT, Nodes>(np, [&cdt](const auto& pack) {
    Nodes nodes;
    Phase_timer reading_time(nodes.report.seconds.reading);
    const auto progress = read_progress(pack);
    const Progress_scope scope(*progress);
    do_unless_stopped(nodes.report, [&] {
      const Input_2<CDT> input(cdt, pack, progress);
      const Problem_2 problem = input.problem();
      reading_time.stop();
      const Bubbles_2 bubbles = make_nodes(problem, nodes.report);
      write_nodes<CDT>(bubbles, find_elevations(cdt, input.reading, bubbles, input.elevation),
                       input.options.neighbor_radius, input.options.threads, nodes);
      nodes.report.number_of_vertices = nodes.size();
      progress->finish();
    });
    return nodes;
  });
}

} // namespace CGAL

#include <CGAL/Bubble_relaxation_2/internal/core/enable_warnings.h>

#endif // CGAL_NPBS_PLACE_NODES_H
