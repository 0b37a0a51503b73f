// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_RELAX_AND_VALIDATE_H
#define BUBBLE_RELAXATION_2_TEST_RELAX_AND_VALIDATE_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"
#include "validation.h"

#include <CGAL/npbs_relax.h>

/// meshes a domain and checks what every mesh must have; returns the report
template <class Cdt, class Parameters>
auto relax_and_validate(Cdt& cdt, const Parameters& parameters)
{
  const validation::Snapshot before = validation::snapshot(cdt);
  const auto report = CGAL::npbs_relax(cdt, parameters);
  validation::expect_mesh_of(before, cdt);
  return report;
}

template <class Parameters>
auto relax_and_validate(const paper::Domain& domain, paper::CDT& cdt, const Parameters& parameters)
{
  cdt = paper::triangulate(domain);
  const auto report = relax_and_validate(cdt, parameters.sizing_function(domain.d));
  EXPECT_EQ(report.number_of_vertices, cdt.number_of_vertices());
  return report;
}

#endif // BUBBLE_RELAXATION_2_TEST_RELAX_AND_VALIDATE_H
