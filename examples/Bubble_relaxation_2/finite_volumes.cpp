// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Diffusion by finite volumes on the Voronoi cells of a mesh: -div(k grad u) = f, with two-point fluxes. On the hole of the
// square u is given, on its sides the flux. The solution is known, so the errors can be printed, as cells get smaller.

#include "svg_picture.h"

#include <CGAL/Bubble_relaxation_2/IO/write_VTU_of_cells.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = K::Point_2;
using CDT = CGAL::Constrained_Delaunay_triangulation_2<K>;
enum Boundary { NONE, FLUX_GIVEN, VALUE_GIVEN };
using Markers = CGAL::Constraint_marker_map_2<CDT, Boundary>;
using Dual = CGAL::Voronoi_dual_2<CDT, Boundary>;

double u(const Point& p) { return std::sin(2 * p.x()) * std::exp(p.y()); }
K::Vector_2 gradient_of_u(const Point& p) { return {2 * std::cos(2 * p.x()) * std::exp(p.y()), u(p)}; }
double k(const Point& p) { return 1 + p.x() * p.x() + 0.5 * p.y(); }
double f(const Point& p) { return 3 * k(p) * u(p) - gradient_of_u(p) * K::Vector_2(2 * p.x(), 0.5); }

/// a square with a round hole
CDT domain(double d, const Markers& markers)
{
  std::vector<Point> hole;
  const int corners = static_cast<int>(std::lround(CGAL_PI / d));
  for (int i = 0; i < corners; ++i)
    hole.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / corners), 0.5 * std::sin(2 * CGAL_PI * i / corners)));
  CDT cdt;
  for (const auto& [outline, marker] :
       {std::make_pair(std::vector<Point>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, FLUX_GIVEN),
        std::make_pair(hole, VALUE_GIVEN)})
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto v = cdt.insert(outline[i]), w = cdt.insert(outline[(i + 1) % outline.size()]);
      cdt.insert_constraint(v, w);
      markers.set(v, w, marker);
    }
  return cdt;
}

std::vector<double> solve(const Dual& dual)
{
  const int n = static_cast<int>(dual.cells().size());
  Eigen::VectorXd right(n);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    const Dual::Cell& cell = dual.cells()[static_cast<std::size_t>(i)];
    right[i] = cell.area * f(cell.center);
  }
  std::vector<bool> is_given(dual.cells().size(), false);
  for (const Dual::Boundary_part& part : dual.boundary_parts())
    if (part.marker == VALUE_GIVEN)
      is_given[part.cell] = true;
    else
      right[static_cast<int>(part.cell)] +=
        part.length * k(part.midpoint) * (gradient_of_u(part.midpoint) * part.normal);
  for (const Dual::Face& face : dual.faces()) {
    const double t = k(face.midpoint) * face.length / face.distance;
    for (const auto& [i, j] : {std::make_pair(face.first, face.second), std::make_pair(face.second, face.first)}) {
      if (is_given[i])
        continue;
      const int row = static_cast<int>(i);
      entries.emplace_back(row, row, t);
      if (is_given[j])
        right[row] += t * u(dual.cells()[j].center);
      else
        entries.emplace_back(row, static_cast<int>(j), -t);
    }
  }
  for (int i = 0; i < n; ++i)
    if (is_given[static_cast<std::size_t>(i)]) {
      entries.emplace_back(i, i, 1);
      right[i] = u(dual.cells()[static_cast<std::size_t>(i)].center);
    }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky(matrix);
  const Eigen::VectorXd solution = cholesky.solve(right);
  return std::vector<double>(solution.data(), solution.data() + n);
}

/// the discrete L2 norm
double error(const Dual& dual, const std::vector<double>& values)
{
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += dual.cells()[i].area * std::pow(values[i] - u(dual.cells()[i].center), 2);
  return std::sqrt(sum);
}

int main()
{
  std::cout << "       d   cells      error   order\n";
  double last = 0;
  for (double d : {0.16, 0.08, 0.04, 0.02}) {
    const Markers markers;
    CDT cdt = domain(d, markers);
    CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d).edge_marker_map(markers));
    const Dual dual(cdt, CGAL::parameters::edge_marker_map(markers));
    const std::vector<double> values = solve(dual);
    const double e = error(dual, values);
    std::printf("%8.2f %7zu %10.3g", d, values.size(), e);
    std::printf(last > 0 ? "   %5.2f\n" : "\n", std::log2(last / e));
    last = e;
    if (d == 0.08) {
      std::ofstream out("finite_volumes.vtu", std::ios::binary);
      CGAL::IO::write_VTU_of_cells(out, dual, values);
      Svg_picture picture;
      picture.add_cells(cdt, dual.polygon_soup(), "Voronoi cells, clipped at the boundary");
      picture.write("finite_volumes.svg");
      std::cout << dual.quality();
    }
  }
}
