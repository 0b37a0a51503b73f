// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

#ifndef BUBBLE_RELAXATION_2_TEST_DUAL_CHECKS_H
#define BUBBLE_RELAXATION_2_TEST_DUAL_CHECKS_H

#include <CGAL/Voronoi_dual_2.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// What holds for each dual, whatever the mesh.
namespace dual_checks {

template <class Dual>
double total_area(const Dual& dual)
{
  double sum = 0;
  for (const auto& c : dual.cells())
    sum += c.area;
  return sum;
}

/// the coordinates in double, of points and vectors
template <class P>
std::array<double, 2> xy(const P& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
}

/// Calls `visit(cell, length, normal, midpoint)` for all that bounds cells; normals point out of the cell.
template <class Dual, class Visit>
void for_each_side(const Dual& dual, const Visit& visit)
{
  for (const auto& f : dual.faces()) {
    const auto n = xy(f.normal);
    visit(f.first, f.length, n, xy(f.midpoint));
    visit(f.second, f.length, std::array<double, 2>{-n[0], -n[1]}, xy(f.midpoint));
  }
  for (const auto& p : dual.boundary_parts())
    visit(p.cell, p.length, xy(p.normal), xy(p.midpoint));
}

/// Sides close each cell, and by the divergence theorem their midpoints tell its area.
template <class Dual>
void expect_closed(const Dual& dual)
{
  const std::size_t n = dual.cells().size();
  std::vector<double> x(n, 0), y(n, 0), perimeter(n, 0), twice_area(n, 0);
  for_each_side(dual, [&](std::size_t c, double length, const auto& normal, const auto& midpoint) {
    const auto center = xy(dual.cells()[c].center);
    x[c] += length * normal[0];
    y[c] += length * normal[1];
    perimeter[c] += std::abs(length);
    twice_area[c] += length * ((midpoint[0] - center[0]) * normal[0] + (midpoint[1] - center[1]) * normal[1]);
  });
  for (std::size_t c = 0; c < n; ++c) {
    EXPECT_LE(std::hypot(x[c], y[c]), 1e-12 * perimeter[c]) << "cell " << c;
    EXPECT_NEAR(twice_area[c] / 2, dual.cells()[c].area, 1e-13 * perimeter[c] * perimeter[c]) << "cell " << c;
  }
}

/// Faces lie on the bisectors of the centres, boundary parts beside their cells.
template <class Dual>
void expect_orthogonal(const Dual& dual)
{
  for (const auto& f : dual.faces()) {
    const auto a = xy(dual.cells()[f.first].center), b = xy(dual.cells()[f.second].center), m = xy(f.midpoint),
               n = xy(f.normal);
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    EXPECT_NEAR(f.distance, std::hypot(dx, dy), 1e-14 * f.distance);
    EXPECT_NEAR(n[0] * dx + n[1] * dy, f.distance, 1e-14 * f.distance);
    EXPECT_NEAR((m[0] - a[0]) * n[0] + (m[1] - a[1]) * n[1], f.distance / 2, 1e-13 * f.distance);
    EXPECT_NEAR(f.left_length + f.right_length, f.length, 1e-14 * f.distance);
    EXPECT_FALSE(f.is_on_boundary && f.right_length != 0);
  }
}

/// the area of a polygon of a soup, in cells' areas
template <class Soup>
double area_of(const Soup& soup, const std::vector<std::size_t>& polygon)
{
  const auto o = xy(soup.points[polygon[0]]);
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto p = xy(soup.points[polygon[k]]), q = xy(soup.points[polygon[(k + 1) % polygon.size()]]);
    twice += (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  }
  return twice / 2;
}

/// The polygons are those of the cells, signs of areas included, and segments those of boundary parts.
template <class Dual>
void expect_polygons(const Dual& dual)
{
  const auto soup = dual.polygon_soup();
  std::vector<double> areas(dual.cells().size(), 0);
  ASSERT_EQ(soup.polygons.size(), soup.cells.size());
  for (std::size_t k = 0; k < soup.polygons.size(); ++k) {
    EXPECT_GE(soup.polygons[k].size(), 3u);
    EXPECT_LE(soup.cells[k == 0 ? 0 : k - 1], soup.cells[k]);
    areas[soup.cells[k]] += area_of(soup, soup.polygons[k]);
  }
  const double mean = total_area(dual) / double(areas.size());
  for (std::size_t c = 0; c < areas.size(); ++c)
    EXPECT_NEAR(areas[c], dual.cells()[c].area, 1e-11 * mean) << "cell " << c;
  ASSERT_EQ(soup.segments.size(), dual.boundary_parts().size());
  for (std::size_t k = 0; k < soup.segments.size(); ++k) {
    const auto &part = dual.boundary_parts()[k], &other = dual.boundary_parts()[k ^ 1];
    const auto p = xy(soup.points[soup.segments[k][0]]), q = xy(soup.points[soup.segments[k][1]]),
               m = xy(part.midpoint);
    EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1]), part.length, 1e-13 * part.length);
    EXPECT_NEAR(std::hypot((p[0] + q[0]) / 2 - m[0], (p[1] + q[1]) / 2 - m[1]), 0, 1e-13 * part.length);
    EXPECT_EQ(part.edge, other.edge);
  }
}

/// Two-point fluxes of a linear function: they cancel in all cells within the domain, exactly.
template <class Dual>
void expect_exact_for_linear_functions(const Dual& dual)
{
  const auto u = [&](std::size_t c) {
    const auto p = xy(dual.cells()[c].center);
    return 3 * p[0] - 2 * p[1];
  };
  std::vector<double> sum(dual.cells().size(), 0);
  for (const auto& f : dual.faces()) {
    const double flux = f.length / f.distance * (u(f.second) - u(f.first));
    sum[f.first] += flux;
    sum[f.second] -= flux;
  }
  for (const auto& p : dual.boundary_parts()) // through the boundary
    sum[p.cell] += p.length * (3 * xy(p.normal)[0] - 2 * xy(p.normal)[1]);
  for (std::size_t c = 0; c < sum.size(); ++c)
    EXPECT_NEAR(sum[c], 0, 1e-12) << "cell " << c;
}

/// \param area of the domain
template <class Dual>
void expect_valid(const Dual& dual, double area)
{
  EXPECT_NEAR(total_area(dual), area, 1e-12 * area);
  expect_closed(dual);
  expect_orthogonal(dual);
  expect_polygons(dual);
  expect_exact_for_linear_functions(dual);
  for (std::size_t c = 0; c < dual.cells().size(); ++c)
    EXPECT_EQ(dual.cell_of(dual.cells()[c].vertex), c);
  EXPECT_EQ(dual.quality().number_of_cells, dual.cells().size());
  EXPECT_EQ(dual.quality().number_of_faces, dual.faces().size());
}

} // namespace dual_checks

#endif // BUBBLE_RELAXATION_2_TEST_DUAL_CHECKS_H
