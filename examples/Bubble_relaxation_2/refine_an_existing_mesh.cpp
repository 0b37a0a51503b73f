// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Figures 19 to 21 of the paper: a mesh, and the same mesh after d has been changed (eq. 12): refined near
// the hole, and what already fits is kept. Then it is coarsened.

#include "paper_domains.h"
#include "svg_picture.h"

#include <CGAL/npbs_relax.h>

#include <iostream>

int main()
{
  const paper::Domain domain = paper::square_with_hole(1);
  paper::CDT cdt = paper::triangulate(domain);
  Svg_picture picture;

  const auto show = [&](const char* what, const auto& report) {
    std::cout << what << ": " << report.number_of_initial_bubbles << " bubbles to start with, "
              << report.number_of_insertions << " inserted, " << report.number_of_deletions
              << " deleted\n"
              << report.quality << '\n';
    picture.add_mesh(cdt, what);
    picture.add_histogram(report.quality, what);
  };

  show("eq. 1", CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(domain.d)));
  show("refined, eq. 12",
       CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(paper::refined_size(1))));
  show("coarsened, d = 0.1 to 0.2", CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(
                         [](const paper::Point& p) { return 0.05 + paper::distance(p, 0) / 10; })));
  picture.write("refined.svg");
}
