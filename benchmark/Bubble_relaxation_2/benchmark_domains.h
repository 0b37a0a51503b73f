// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_BENCHMARK_BENCHMARK_DOMAINS_H
#define BUBBLE_RELAXATION_2_BENCHMARK_BENCHMARK_DOMAINS_H

#include "../../demo/Bubble_relaxation_2/paper_domains.h"

#include <CGAL/npbs_relax.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

/// Makes a domain with its sizes scaled by the argument.
using Domain_maker = std::function<paper::Domain(double)>;

/// A disc with the same d everywhere, which lattices and fronts like best.
inline paper::Domain disc(double f)
{
  return {0, "disc", {paper::circle(1, 0.05 * f)}, [f](const paper::Point&) { return 0.05 * f; }, 250, 1};
}

/// The unit square with the same d everywhere.
inline paper::Domain square(double f)
{
  return {0, "square", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, [f](const paper::Point&) { return 0.03 * f; }, 250, 1};
}

/// five graded domains, those of eqs. 1, 4, 5, 6 and 7, then three uniform ones
inline std::vector<Domain_maker> compared_domains()
{
  return {paper::square_with_hole, paper::graded_circle, paper::graded_square, paper::l_shape,
          paper::comb,             paper::octagram,      paper::trunk,         disc};
}

/// By how much the sizes of a domain are to be scaled for `npbs_relax()` to give it about `n` vertices, which is found
/// by trials: an outline has its vertices whatever the size. If they are more than `n`, it is where that is seen.
inline double scale_for_vertices(const Domain_maker& make, double n)
{
  double f = 1, last = std::numeric_limits<double>::infinity();
  for (int trial = 1;; ++trial) {
    const paper::Domain domain = make(f);
    paper::CDT cdt = paper::triangulate(domain);
    const auto report = CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d));
    const double ratio = double(report.number_of_vertices) / n;
    const bool falls_no_more = ratio > 1 && last > 1 && ratio > 0.95 * last;
    if (std::abs(ratio - 1) < 0.01 || falls_no_more || trial == 10)
      return f;
    f *= std::sqrt(ratio); // as many times as many vertices
    last = ratio;
  }
}

inline paper::Domain domain_with_vertices(const Domain_maker& make, double n)
{
  return make(scale_for_vertices(make, n));
}

#endif // BUBBLE_RELAXATION_2_BENCHMARK_BENCHMARK_DOMAINS_H
