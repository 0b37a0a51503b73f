// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Diffusion by finite volumes on the Voronoi cells of a mesh: -div(k grad u) = f, with two-point fluxes. On the hole of
// the square u is given, on its sides the flux. The solution is known, so the errors can be printed, as cells get
// smaller.

#include "svg_picture.h"

#include <CGAL/Bubble_relaxation_2/IO/write_VTU_of_cells.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
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
  const std::vector<Point> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<Point> hole;
  const int corners = static_cast<int>(std::lround(CGAL_PI / d));
  for (int i = 0; i < corners; ++i)
    hole.push_back(Point(0.5 * std::cos(2 * CGAL_PI * i / corners), 0.5 * std::sin(2 * CGAL_PI * i / corners)));
  CDT cdt;
  for (const auto& outline : {square, hole})
    cdt.insert_constraint(outline.begin(), outline.end(), true);
  for (const auto& [outline, marker] : {std::make_pair(square, FLUX_GIVEN), std::make_pair(hole, VALUE_GIVEN)})
    for (std::size_t i = 0; i < outline.size(); ++i) // when all constraints are in, which may cut each other
      markers.set(cdt, cdt.insert(outline[i]), cdt.insert(outline[(i + 1) % outline.size()]), marker);
  return cdt;
}

/// the values of all cells. A cell is given its value if it has a part of the boundary where values are given.
std::vector<double> solve(const Dual& dual)
{
  const std::size_t n = dual.cells().size();
  Eigen::SparseMatrix<double> matrix(static_cast<int>(n), static_cast<int>(n));
  Eigen::VectorXd right(matrix.rows());
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<bool> is_given(n, false);
  for (const Dual::Boundary_part& part : dual.boundary_parts())
    if (part.marker == VALUE_GIVEN)
      is_given[part.cell] = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Dual::Cell& cell = dual.cells()[i];
    const int row = static_cast<int>(i);
    right[row] = is_given[i] ? u(cell.center) : cell.area * f(cell.center);
    if (is_given[i])
      entries.emplace_back(row, row, 1);
  }
  for (const Dual::Boundary_part& part : dual.boundary_parts())
    if (!is_given[part.cell]) {
      const Point& p = part.midpoint;
      right[static_cast<int>(part.cell)] += part.length * k(p) * (gradient_of_u(p) * part.normal);
    }
  for (const Dual::Face& face : dual.faces()) {
    const double t = k(face.midpoint) * face.length / face.distance; // the flux for a difference of 1
    for (const auto& [i, j] : {std::make_pair(face.first, face.second), std::make_pair(face.second, face.first)}) {
      if (is_given[i])
        continue;
      const int row = static_cast<int>(i), column = static_cast<int>(j);
      entries.emplace_back(row, row, t);
      if (is_given[j])
        right[row] += t * u(dual.cells()[j].center);
      else
        entries.emplace_back(row, column, -t);
    }
  }
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky(matrix);
  const Eigen::VectorXd solution = cholesky.solve(right);
  return std::vector<double>(solution.data(), solution.data() + n);
}

/// in the discrete L2 norm
double error(const Dual& dual, const std::vector<double>& values)
{
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    sum += dual.cells()[i].area * std::pow(values[i] - u(dual.cells()[i].center), 2);
  return std::sqrt(sum);
}

int main()
{
  std::cout << std::fixed << "     d   cells     error  order\n";
  CGAL::Voronoi_quality_2 quality;
  double last_error = 0;
  for (double d : {0.16, 0.08, 0.04, 0.02}) {
    const Markers markers;
    CDT cdt = domain(d, markers);
    CGAL::npbs_relax(cdt, CGAL::parameters::sizing_function(d).edge_marker_map(markers));
    const Dual dual(cdt, CGAL::parameters::edge_marker_map(markers));
    const std::vector<double> values = solve(dual);
    const double e = error(dual, values);
    std::cout << std::setprecision(2) << std::setw(6) << d << std::setw(8) << values.size() << std::setprecision(6)
              << std::setw(10) << e;
    if (last_error > 0)
      std::cout << std::setprecision(2) << std::setw(7) << std::log2(last_error / e);
    std::cout << std::endl;
    last_error = e;
    quality = dual.quality();
    if (d == 0.08) {
      CGAL::IO::write_VTU_of_cells("finite_volumes.vtu", dual, values);
      Svg_picture picture;
      picture.add_cells(cdt, dual.polygon_soup(), "the cells of " + std::to_string(values.size()) + " vertices");
      picture.write("finite_volumes.svg");
    }
  }
  std::cout << "the last of these meshes\n" << quality;
}
