// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// The dual of a mesh for finite volumes: what holds for each, whatever it is made of, its markers and statistics.

#include "domains.h"
#include "dual_checks.h"
#include "expect_throw.h"

#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Voronoi_dual_2.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <locale>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_voronoi_dual {

using domains::CDT;
using domains::K;
using domains::Point;
using dual_checks::expect_valid;
using Dual = CGAL::Voronoi_dual_2<CDT>;
namespace P = CGAL::parameters;

TEST(Voronoi_dual, of_equilateral_triangles)
{
  CDT cdt;
  const double h = std::sqrt(0.75);
  const std::vector<Point> ring{{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}};
  cdt.insert_constraint(ring.begin(), ring.end(), true);
  const auto center = cdt.insert(Point(0, 0));
  const Dual dual(cdt);
  expect_valid(dual, 6 * h / 2);
  ASSERT_EQ(dual.cells().size(), 7u);
  EXPECT_EQ(dual.faces().size(), 12u);
  EXPECT_EQ(dual.boundary_parts().size(), 12u);
  const std::size_t c = dual.cell_of(center);
  EXPECT_FALSE(dual.cells()[c].is_on_boundary);
  EXPECT_NEAR(dual.cells()[c].area, h, 1e-15); // a hexagon: two triangles
  for (const auto& f : dual.faces())
    EXPECT_NEAR(f.length, f.is_on_boundary ? 0.5 / std::sqrt(3) : 1 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(dual.quality().smallest_face_ratio, 0.5 / std::sqrt(3), 1e-15);
  EXPECT_LT(dual.quality().largest_midpoint_offset, 1e-15);
}

TEST(Voronoi_dual, of_a_domain_that_touches_itself)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1), domains::square(1, 1, 1)}, 0.2);
  const Dual dual(cdt);
  expect_valid(dual, 2);
  const auto soup = dual.polygon_soup();
  EXPECT_EQ(soup.polygons.size(), dual.cells().size() + 1);
  for (const auto& c : dual.cells())
    if (c.center == Point(1, 1)) {
      const std::size_t number = dual.cell_of(c.vertex);
      EXPECT_EQ(std::count(soup.cells.begin(), soup.cells.end(), number), 2);
    }
}

TEST(Voronoi_dual, vertices_on_circles_have_faces_of_no_length)
{
  constexpr int n = 10;
  CDT cdt = domains::make({domains::square(0, 0, n)});
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      cdt.insert(Point(i, j));
  const Dual dual(cdt);
  expect_valid(dual, n * n);
  const auto& q = dual.quality();
  EXPECT_EQ(q.number_of_zero_faces, std::size_t(n * n)); // the diagonals
  EXPECT_EQ(q.number_of_negative_faces, 0u);
  EXPECT_EQ(q.number_of_obtuse_triangles, 0u);
  EXPECT_EQ(q.smallest_face_ratio, 0);
  EXPECT_EQ(q.smallest_area, 0.25); // in the corners
  for (const auto& f : dual.faces())
    EXPECT_EQ(f.length, f.distance > 1 ? 0. : f.is_on_boundary ? 0.5 : 1.);
}

TEST(Voronoi_dual, signs_are_exact_where_coordinates_round)
{
  // turned by an angle whose cosine is no binary fraction: squares that are none, by roundings
  constexpr int n = 20;
  CDT cdt;
  const auto point = [](int i, int j) { return Point(0.6 * i - 0.8 * j + 1000.1, 0.8 * i + 0.6 * j - 77.7); };
  const std::vector<Point> outline{point(0, 0), point(n, 0), point(n, n), point(0, n)};
  cdt.insert_constraint(outline.begin(), outline.end(), true);
  for (int i = 1; i < n; ++i)
    for (int j = 1; j < n; ++j)
      cdt.insert(point(i, j));
  const Dual dual(cdt);
  std::size_t negative = 0, zero = 0, inner_negative = 0;
  for (const auto& f : dual.faces()) {
    negative += f.length < 0;
    zero += f.length == 0;
    inner_negative += f.length < 0 && !f.is_on_boundary;
  }
  EXPECT_EQ(negative, dual.quality().number_of_negative_faces);
  EXPECT_GE(zero, dual.quality().number_of_zero_faces);
  EXPECT_EQ(inner_negative, 0u); // all edges are Delaunay
  EXPECT_NEAR(dual_checks::total_area(dual), n * n, 1e-10);
}

TEST(Voronoi_dual, an_obtuse_angle_at_the_boundary_is_told)
{
  CDT cdt = domains::make({{{0, 0}, {4, 0}, {2, 1}}});
  const Dual dual(cdt);
  expect_valid(dual, 2);
  const auto& q = dual.quality();
  EXPECT_EQ(q.number_of_obtuse_triangles, 1u);
  EXPECT_EQ(q.number_of_centers_beyond_constraints, 1u);
  EXPECT_EQ(q.number_of_negative_faces, 1u);
  // the circumcentre is (2, -1.5)
  EXPECT_NEAR(q.smallest_face_ratio, -1.5 / 4, 1e-15);
  EXPECT_EQ(q.smallest_face_x, 2);
  EXPECT_EQ(q.smallest_face_y, 0);
}

TEST(Voronoi_dual, an_obtuse_angle_within_the_domain_does_no_harm)
{
  // the circumcentre lies beyond the longest side, in the other triangle
  CDT cdt = domains::make({{{0, 0}, {2, -8}, {4, 0}, {2, 1}}});
  const Dual dual(cdt);
  expect_valid(dual, 18);
  const auto& q = dual.quality();
  EXPECT_EQ(q.number_of_obtuse_triangles, 1u);
  EXPECT_EQ(q.number_of_centers_beyond_constraints, 0u);
  EXPECT_EQ(q.number_of_negative_faces, 0u);
  for (const auto& f : dual.faces())
    if (!f.is_on_boundary) {
      EXPECT_LT((std::min)(f.left_length, f.right_length), 0.);
      EXPECT_GT(f.length, 0.);
    }
}

TEST(Voronoi_dual, areas_sum_up_with_needles)
{
  for (double height : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const auto at = [](double x, double y) { return std::make_pair(0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y); };
    CDT cdt = domains::make({{at(0, 0), at(1, 0), at(0.7, 1), at(0, 1)}});
    const auto [x, y] = at(0.3, height);
    cdt.insert(Point(x, y));
    EXPECT_NEAR(dual_checks::total_area(Dual(cdt)), 0.85, 1e-16 / height) << height;
  }
}

TEST(Voronoi_dual, a_constraint_that_is_not_delaunay_has_a_negative_face)
{
  CDT cdt = domains::make({{{0, 0}, {2, -1}, {4, 0}, {2, 1}}});
  domains::insert(cdt, {{0, 0}, {4, 0}}, false);
  const Dual dual(cdt);
  expect_valid(dual, 4);
  EXPECT_EQ(dual.quality().number_of_negative_faces, 1u);
  EXPECT_EQ(dual.quality().number_of_centers_beyond_constraints, 2u);
  EXPECT_NEAR(dual.quality().smallest_face_ratio, -3. / 4, 1e-15);
}

TEST(Voronoi_dual, an_edge_that_is_not_delaunay_is_told)
{
  using Constrained = CGAL::Constrained_triangulation_2<K>;
  Constrained ct = domains::make<Constrained>({{{0, 0}, {4, 0}, {4, 3}, {0, 3.5}}});
  const CGAL::Voronoi_dual_2<Constrained> before(ct);
  for (const auto& f : before.faces())
    if (!f.is_on_boundary)
      ct.flip(f.edge.first, f.edge.second);
  for (auto f : ct.finite_face_handles()) // a flip does not know of constraints
    for (int i = 0; i < 3; ++i)
      f->set_constraint(i, ct.is_infinite(f->neighbor(i)));
  const CGAL::Voronoi_dual_2<Constrained> after(ct);
  expect_valid(before, 13);
  expect_valid(after, 13);
  EXPECT_EQ(before.quality().number_of_negative_faces + after.quality().number_of_negative_faces, 1u);
}

TEST(Voronoi_dual, markers_are_those_of_constraints)
{
  enum Side { INSIDE, BOTTOM, OTHERS, BAR };
  CDT cdt;
  CGAL::Constraint_marker_map_2<CDT, Side> markers(OTHERS);
  domains::insert(cdt, domains::square(0, 0, 1));
  const auto at = [&](double x, double y) { return cdt.insert(Point(x, y)); };
  markers.set(cdt, at(0, 0), at(1, 0), BOTTOM);
  const auto u = at(0.3, 0.5), v = at(0.8, 0.6);
  cdt.insert_constraint(u, v);
  markers.set(u, v, BAR);
  CGAL::npbs_relax(cdt, P::sizing_function(0.1).edge_marker_map(markers));
  const CGAL::Voronoi_dual_2<CDT, Side> dual(cdt, P::edge_marker_map(markers));
  std::map<Side, double> length, distance;
  for (const auto& p : dual.boundary_parts())
    length[p.marker] += p.length;
  for (const auto& f : dual.faces())
    distance[f.marker] += f.distance;
  EXPECT_EQ(length.size(), 2u);
  EXPECT_NEAR(length[BOTTOM], 1, 1e-14);
  EXPECT_NEAR(length[OTHERS], 3, 1e-14);
  EXPECT_NEAR(distance[BOTTOM], 1, 1e-14);
  EXPECT_NEAR(distance[BAR], std::hypot(0.5, 0.1), 1e-14);
  EXPECT_GT(distance[INSIDE], 10.); // no constraints
}

/// one marker everywhere; how often it was copied
struct Counting_markers
{
  using key_type = std::pair<CDT::Vertex_handle, CDT::Vertex_handle>;
  using value_type = int;
  using reference = int;
  using category = boost::readable_property_map_tag;

  explicit Counting_markers(int& n) : number(&n) {}
  Counting_markers(const Counting_markers& other) : number(other.number) { ++*number; }
  Counting_markers& operator=(const Counting_markers&) = delete;

  int* number;

  friend int get(const Counting_markers&, const key_type&) { return 1; }
};

TEST(Voronoi_dual, a_map_of_markers_is_not_copied_for_each_face)
{
  const CDT cdt = domains::mesh({domains::square(0, 0, 1)}, 0.05);
  int number = 0;
  const Dual dual(cdt, P::edge_marker_map(Counting_markers(number)));
  EXPECT_GT(dual.faces().size(), 500u);
  EXPECT_LT(number, 20);
}

TEST(Voronoi_dual, areas_have_the_same_bits_wherever_triangles_lie)
{
  std::vector<Point> points;
  for (auto v : domains::mesh({domains::square(0, 0, 1)}, 0.07).finite_vertex_handles())
    points.push_back(Point(v->point().x() / 3, v->point().y() / 3));
  const auto areas = [&points] {
    CDT cdt = domains::make({domains::square(0, 0, 1 / 3.)});
    for (const Point& p : points) // no sorting in space before insertion
      cdt.insert(p);
    std::map<Point, double> result;
    for (const auto& c : Dual(cdt).cells())
      result[c.center] = c.area;
    return result;
  };
  const std::map<Point, double> expected = areas();
  std::reverse(points.begin(), points.end());
  EXPECT_TRUE(areas() == expected);
}

TEST(Voronoi_dual, edges_know_what_is_on_both_sides)
{
  CDT cdt = domains::make({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.4, 0}, {0.6, 1}}, false);
  CGAL::npbs_relax(cdt, P::sizing_function(0.1));
  const Dual dual(cdt);
  for (const auto& f : dual.faces()) {
    EXPECT_TRUE(f.edge.first->is_in_domain());
    EXPECT_EQ(f.is_on_boundary, cdt.is_infinite(f.edge.first->neighbor(f.edge.second)));
    const auto a = dual.cells()[f.first].center, b = dual.cells()[f.second].center,
               c = f.edge.first->vertex(f.edge.second)->point();
    EXPECT_EQ(CGAL::orientation(a, b, c), CGAL::LEFT_TURN);
  }
}

TEST(Voronoi_dual, seeds_tell_the_domain)
{
  const CDT cdt = domains::make({domains::square(0, 0, 1), domains::square(0.25, 0.25, 0.5)});
  EXPECT_NEAR(dual_checks::total_area(Dual(cdt)), 0.75, 1e-15);
  const std::vector<Point> in_the_middle{Point(0.5, 0.5)};
  const Dual middle(cdt, P::seeds(in_the_middle).seeds_are_in_domain(true));
  expect_valid(middle, 0.25);
  EXPECT_EQ(middle.cells().size(), 4u);
  for (auto v : cdt.finite_vertex_handles())
    EXPECT_EQ(middle.cell_of(v) == Dual::no_cell, v->point().x() < 0.2 || v->point().x() > 0.8);
}

TEST(Voronoi_dual, refuses_what_has_no_cells)
{
  const auto make = [](const CDT& cdt) { return [&cdt] { Dual dual(cdt); }; };
  CDT empty, open = domains::make({}), no_boundary = domains::make({domains::square(0, 0, 1)});
  expect_invalid(make(empty), {"0 vertices", "dimension -1"});
  domains::insert(open, {{0, 0}, {1, 0}, {1, 1}}, false);
  expect_invalid(make(open), {"no face lies in the domain", "only one constraint ends at (0, 0)"});
  no_boundary.insert(Point(2, 0.5));
  for (auto f : no_boundary.finite_face_handles())
    f->set_in_domain(true);
  expect_invalid(make(no_boundary), {"the edge from", "(2, 0.5)", "must be constrained"});
  CDT huge = domains::make({{{0, 0}, {1e100, 0}, {0, 1e100}}});
  expect_invalid(make(huge), {"1e+100", "at most 1e+90"});
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_cdt = CGAL::Constrained_Delaunay_triangulation_2<Exact>;
  Exact_cdt flat;
  const Exact::FT height = Exact::FT(1e-200) * Exact::FT(1e-200); // 0 in double
  const std::vector<Exact::Point_2> corners{{0, 0}, {1, 0}, {0.5, height}};
  flat.insert_constraint(corners.begin(), corners.end(), true);
  expect_invalid([&] { CGAL::Voronoi_dual_2<Exact_cdt> dual(flat); }, {"triangle at (", "too flat"});
}

struct Decimal_comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
};

// as the stream has it, whatever the program's locale is
TEST(Voronoi_dual, statistics_are_printed)
{
  const Dual dual(domains::make({{{0, 0}, {4, 0}, {2, 1}}}));
  std::ostringstream out;
  out.precision(3);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Decimal_comma));
  out << dual.quality() << 0.123456;
  std::locale::global(before);
  EXPECT_EQ(out.str(), "  cells, faces                        3, 3\n"
                       "  smallest area                       -0.25\n"
                       "  smallest face over distance         -0.375 at (2, 0)\n"
                       "  faces of length 0, negative         0, 1\n"
                       "  obtuse triangles, at constraints    1, 1\n"
                       "  largest error of orthogonality      0\n"
                       "  largest offset of midpoints         0\n"
                       "0.123");
}

} // namespace test_voronoi_dual
