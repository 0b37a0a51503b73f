// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef CGAL_NPBS_ADAPT_H
#define CGAL_NPBS_ADAPT_H

#include <CGAL/license/Bubble_relaxation_2.h>

#include <CGAL/Bubble_relaxation_2/internal/adaptation/Part_check_2.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/read_adaptation.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/remesh_part.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_2/internal/core/read_options.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Default_adaptation_visitor_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <vector>

namespace CGAL {

template <class CDT, class FaceRange, class NamedParameters = parameters::Default_named_parameters>
auto npbs_remesh_faces(CDT& cdt, const FaceRange& faces, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using FT = typename Quality_number<typename CDT::Geom_traits>::type;

  Report report;
  Phase_timer reading_time(report.seconds.reading);
  const Relaxation_options options = read_local_options(np);
  const Is_in_domain<CDT> is_in_domain{cdt};
  const std::vector<typename CDT::Face_handle> part = Part_check_2<CDT>(cdt)(faces, is_in_domain);
  const Part_input_2<CDT> input(cdt, part, is_in_domain, is_pinned<CDT>(np), options, given_sizes<CDT>(np));
  reading_time.stop();
  Progress progress(options.callback, options.number_of_rounds);
  auto visitor = visitor_of<CDT>(np);
  remesh_part(cdt, part, input, progress, unwrapped(visitor), report);
  return Bubble_relaxation_report_2<FT>(report);
}

} // namespace CGAL

#endif // CGAL_NPBS_ADAPT_H
