// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NPBS_RELAX_H
#define CGAL_NPBS_RELAX_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/Write_back_2.h>
#include <CGAL/Bubble_relaxation_2/internal/simulate_bubbles.h>
#include <CGAL/Bubble_relaxation_enums.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Mesh_quality_2.h>

namespace CGAL {

/*!
\ingroup PkgBubbleRelaxation2Functions

\brief fills the domain of a constrained Delaunay triangulation with an almost equilateral mesh, or
relaxes, refines and coarsens the mesh that it holds, by the node placement method by bubble simulation
(NPBS).
*/
template <class CDT, class NamedParameters = parameters::Default_named_parameters>
auto npbs_relax(CDT& cdt, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Bubble_relaxation_2::internal;
  using FT = typename internal::Quality_number<typename CDT::Geom_traits>::type;
  using Concurrency_tag = internal::Concurrency<NamedParameters>;

  Bubble_relaxation_report_2<FT> report;
  const internal::Relaxation_options options = internal::read_options(np);
  internal::Progress progress(options.callback, options.number_of_rounds);

  internal::Phase_timer reading_time(report.seconds.reading);
  const internal::Domain_marks_2<CDT> marks(cdt, np);
  const auto reading = internal::read_domain(cdt, np, marks);
  internal::with_sizing_field(cdt, np, marks, [&](const auto& sizing) {
    reading_time.stop();
    const internal::Bubbles_2 bubbles =
      internal::simulate_bubbles<Concurrency_tag>(*reading, sizing, options, progress, report);
    internal::Restore_on_throw<CDT> guard(cdt);
    internal::write_back(cdt, *reading, bubbles, report);
    internal::evaluate(cdt, np, sizing, report);
    guard.all_went_well();
  });
  progress.report(1);
  return report;
}

} // namespace CGAL

#endif // CGAL_NPBS_RELAX_H
