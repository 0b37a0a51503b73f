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
#include <CGAL/Bubble_relaxation_2/internal/adaptation/find_misfits.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/read_adaptation.h>
#include <CGAL/Bubble_relaxation_2/internal/adaptation/remesh_part.h>
#include <CGAL/Bubble_relaxation_2/internal/core/Progress.h>
#include <CGAL/Bubble_relaxation_parameters.h>
#include <CGAL/Bubble_relaxation_report_2.h>
#include <CGAL/Default_adaptation_visitor_2.h>
#include <CGAL/Mesh_quality_2.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {

template <class CDT, class FaceRange, class NamedParameters = parameters::Default_named_parameters>
auto npbs_remesh_faces(CDT& cdt, const FaceRange& faces, const NamedParameters& np = parameters::default_values())
{
  using namespace Bubble_relaxation_2::internal;
  using FT = typename Quality_number<typename CDT::Geom_traits>::type;

  const Relaxation_options options = read_local_options(np);
  const Is_in_domain<CDT> is_in_domain{cdt};
  const auto pins = is_pinned<CDT>(np);
  const std::optional<Sizes_2> sizes = given_sizes<CDT>(np);
  const std::vector<typename CDT::Face_handle> part = Part_check_2<CDT>(cdt)(faces, is_in_domain);
  auto visitor = visitor_of<CDT>(np);
  Report report;
  Part_task_2<CDT, Is_in_domain<CDT>, decltype(pins)>{cdt, is_in_domain, pins, options, sizes}.remesh(
    part, unwrapped(visitor), report);
  return Bubble_relaxation_report_2<FT>(report);
}

template <class CDT, class NamedParameters>
std::vector<typename CDT::Face_handle> npbs_misfit_faces(const CDT& cdt, const NamedParameters& np)
{
  using namespace Bubble_relaxation_2::internal;
  const Relaxation_options options = read_local_options(np);
  return find_misfits(cdt, domain_of(cdt, np), options, np).faces;
}

template <class CDT, class NamedParameters>
auto npbs_adapt(CDT& cdt, const NamedParameters& np)
{
  using namespace Bubble_relaxation_2::internal;
  using FT = typename Quality_number<typename CDT::Geom_traits>::type;

  const Relaxation_options options = read_local_options(np);
  const auto is_in_domain = domain_of(cdt, np);
  const auto pins = is_pinned<CDT>(np);
  auto visitor = visitor_of<CDT>(np);
  Report report;
  Phase_timer reading_time(report.seconds.reading);
  Misfits_2<CDT> misfits = find_misfits(cdt, is_in_domain, options, np);
  reading_time.stop();
  if (misfits.faces.empty()) {
    tell_that_all_fits(report);
    return Bubble_relaxation_report_2<FT>(report);
  }
  Part_task_2<CDT, decltype(is_in_domain), decltype(pins)>{cdt, is_in_domain, pins, options, misfits.sizes}.adapt(
    std::move(misfits.faces), unwrapped(visitor), report);
  return Bubble_relaxation_report_2<FT>(report);
}

} // namespace CGAL

#endif // CGAL_NPBS_ADAPT_H
