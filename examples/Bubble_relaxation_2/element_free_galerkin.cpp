// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Poisson's equation on nodes: -Laplace(u) = f on the unit square, with u given on its boundary. The solution is
// u = exp(xy), so the errors can be printed, as nodes get closer.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Element_free_Galerkin_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/node_set_2.h>
#include <CGAL/npbs_relax.h>

#include <cmath>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using Vector = K::Vector_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;

double u(const Point& p) { return std::exp(p.x() * p.y()); }
Vector gradient_of_u(const Point& p) { return u(p) * Vector(p.y(), p.x()); }

int main()
{
  CDT cdt;
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  cdt.insert_constraint(square.begin(), square.end(), true);

  CGAL::Poisson_problem_2<K> problem;
  problem.source = [](const Point& p) { return -(p.x() * p.x() + p.y() * p.y()) * u(p); };
  problem.dirichlet = u;

  for (double d : {0.1, 0.05, 0.025}) {
    CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d));
    const auto nodes = CGAL::node_set_2(cdt);
    const CGAL::Element_free_Galerkin_2<CDT> method(cdt, nodes); // integrates over the triangles
    const auto solution = method.solve(problem);

    const auto error = solution.error(u, gradient_of_u);
    std::cout << nodes.size() << " nodes: the error is " << error.l2 << " in L2 and " << error.h1
              << " in H1; u(0.3, 0.4) = " << solution.value(Point(0.3, 0.4)) << '\n';
  }
}
