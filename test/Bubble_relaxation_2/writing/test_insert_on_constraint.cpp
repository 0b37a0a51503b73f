// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Points that are meant to lie on constraints, and lie beside them by roundings or by more, get into them.

#include "domains.h"
#include "expect_throw.h"
#include "validation.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Constraint_marker_map_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/insert_on_constraint_2.h>
#include <CGAL/npbs_relax.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_insert_on_constraint {

using domains::K;
using domains::Outline;
using domains::slanted;

using Plus = CGAL::Constrained_triangulation_plus_2<domains::CDT>;
using Unsplit_cdt = domains::Cdt_of<K, CGAL::No_constraint_intersection_tag>;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_cdt = domains::Cdt_of<Exact>;

template <class Cdt>
typename Cdt::Point point(double x, double y)
{
  return typename Cdt::Point(x, y);
}

/// places between the corners of an outline, as they are rounded
std::vector<std::pair<double, double>> places_on(const Outline& outline, int number, std::mt19937& random)
{
  std::uniform_real_distribution<double> share(0.01, 0.99);
  std::vector<std::pair<double, double>> places;
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (int k = 0; k < number; ++k) {
      const auto& [ax, ay] = outline[i];
      const auto& [bx, by] = outline[(i + 1) % outline.size()];
      const double s = share(random);
      places.emplace_back(ax + s * (bx - ax), ay + s * (by - ay));
    }
  return places;
}

template <class Cdt>
std::size_t number_of_constraints_at(const Cdt& cdt, typename Cdt::Vertex_handle v)
{
  std::size_t number = 0;
  auto e = cdt.incident_edges(v), first = e;
  do
    number += cdt.is_constrained(*e) ? 1 : 0;
  while (++e != first);
  return number;
}

template <class Cdt>
std::size_t number_of_constraints(const Cdt& cdt)
{
  return validation::snapshot(cdt).constraints.size();
}

template <class Cdt>
class Insert_on_constraint : public testing::Test
{};

using Triangulations = testing::Types<domains::CDT, Plus, Unsplit_cdt, Exact_cdt>;

TYPED_TEST_SUITE(Insert_on_constraint, Triangulations);

TYPED_TEST(Insert_on_constraint, pins_on_slanted_edges_leave_no_needles)
{
  std::mt19937 random(7);
  TypeParam cdt = domains::make<TypeParam>({slanted, domains::hole});
  std::set<typename TypeParam::Vertex_handle> pins;
  std::size_t n = slanted.size() + domains::hole.size();
  for (const Outline& outline : {slanted, domains::hole})
    for (const auto& [x, y] : places_on(outline, 20, random)) {
      const auto v = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(x, y));
      EXPECT_EQ(v->point(), point<TypeParam>(x, y));
      EXPECT_EQ(number_of_constraints_at(cdt, v), 2u);
      pins.insert(v);
      ++n;
    }
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(number_of_constraints(cdt), n);
  const auto report = CGAL::npbs_relax(
    cdt, CGAL::parameters::sizing_function(0.1).vertex_is_constrained_map(
           CGAL::Boolean_property_map<std::set<typename TypeParam::Vertex_handle>>(pins)));
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(report.number_of_small_angles + report.number_of_forced_triangles, 0u);
  for (const auto v : pins)
    EXPECT_EQ(number_of_constraints_at(cdt, v), 2u);
}

TYPED_TEST(Insert_on_constraint, tolerance_is_how_far_a_constraint_is_bent)
{
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  for (double off : {0.01, -0.01}) { // within the hull, and beyond
    const auto inside = point<TypeParam>(0.5, off), near_corner = point<TypeParam>(1 - off / 3, 1);
    EXPECT_EQ(CGAL::insert_on_constraint_2(cdt, near_corner, 0.005)->point(), point<TypeParam>(1, 1));
    TypeParam free = cdt, split = cdt;
    EXPECT_EQ(number_of_constraints_at(free, CGAL::insert_on_constraint_2(free, inside, 0.009)), 0u);
    EXPECT_EQ(number_of_constraints_at(split, CGAL::insert_on_constraint_2(split, inside, 0.011)), 2u);
    for (const TypeParam* tr : {&free, &split}) {
      EXPECT_TRUE(tr->is_valid());
      EXPECT_EQ(tr->number_of_vertices(), 5u);
    }
  }
}

TYPED_TEST(Insert_on_constraint, vertices_around_are_not_in_the_way)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  for (int k = 0; k < 60; ++k) {
    const double x = uniform(random), y = uniform(random);
    cdt.insert(point<TypeParam>(x, y));
  }
  const auto a = cdt.insert(point<TypeParam>(0.1, 0.2)), b = cdt.insert(point<TypeParam>(0.9, 0.7));
  cdt.insert_constraint(a, b);
  for (int k = 1; k < 20; ++k) {
    const auto v = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(0.1 + 0.04 * k, 0.2 + 0.025 * k), 1e-3);
    EXPECT_GE(number_of_constraints_at(cdt, v), 2u);
  }
  EXPECT_TRUE(cdt.is_valid());
}

TYPED_TEST(Insert_on_constraint, a_vertex_that_is_there_is_taken)
{
  TypeParam cdt = domains::make<TypeParam>({slanted});
  const auto v = cdt.insert(point<TypeParam>(0.97 / 3, 0.1 * 2 / 3 + 1e-17));
  const auto corner = cdt.insert(point<TypeParam>(0.97, 0));
  EXPECT_EQ(CGAL::insert_on_constraint_2(cdt, v->point()), v);
  EXPECT_EQ(number_of_constraints_at(cdt, v), 2u);
  EXPECT_EQ(CGAL::insert_on_constraint_2(cdt, point<TypeParam>(0.97, 1e-17)), corner);
  EXPECT_EQ(cdt.number_of_vertices(), 5u);
  EXPECT_TRUE(cdt.is_valid());
}

TYPED_TEST(Insert_on_constraint, a_vertex_beyond_the_end_is_taken_without_the_constraint)
{
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  const auto v = cdt.insert(point<TypeParam>(-0.05, -0.2));
  EXPECT_EQ(CGAL::insert_on_constraint_2(cdt, point<TypeParam>(0.02, -0.15), 0.15), v);
  EXPECT_EQ(number_of_constraints_at(cdt, v), 0u);
}

TYPED_TEST(Insert_on_constraint, which_of_two_is_the_nearest_does_not_depend_on_their_order)
{
  for (bool is_first : {false, true}) {
    TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
    for (double y : {0.25, 0.75})
      cdt.insert(point<TypeParam>(0.5, is_first ? y : 1 - y));
    const auto v = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(0.5, 0.5), 0.26);
    EXPECT_EQ(v->point(), point<TypeParam>(0.5, 0.25));
  }
}

TYPED_TEST(Insert_on_constraint, a_line_ends_on_another)
{
  std::mt19937 random(11);
  TypeParam cdt = domains::make<TypeParam>({slanted});
  for (const auto& [x, y] : places_on(slanted, 3, random)) {
    const auto end = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(x, y));
    cdt.insert_constraint(end, cdt.insert(point<TypeParam>(0.5 + 0.6 * (x - 0.5), 0.5 + 0.6 * (y - 0.5))));
    EXPECT_EQ(number_of_constraints_at(cdt, end), 3u);
  }
  const auto report = CGAL::npbs_relax(cdt, 0.05);
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(report.number_of_small_angles, 0u);
}

TYPED_TEST(Insert_on_constraint, nearest_of_many_edges_of_a_straight_hull)
{
  Outline o{{0, 0}};
  for (int i = 1; i <= 100; ++i)
    o.push_back({0.01 * i, 0.0});
  o.push_back({0.5, 1});
  TypeParam cdt = domains::make<TypeParam>({o});
  for (int i = 0; i < 100; ++i) {
    const double x = 0.01 * i + 0.005;
    const auto v = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(x, -1e-17));
    EXPECT_EQ(number_of_constraints_at(cdt, v), 2u);
  }
  EXPECT_TRUE(cdt.is_valid());
  EXPECT_EQ(number_of_constraints(cdt), 202u);
}

TYPED_TEST(Insert_on_constraint, what_cannot_be_is_refused_and_changes_nothing)
{
  TypeParam cdt = domains::make<TypeParam>({domains::square(0, 0, 1)});
  domains::insert(cdt, {{0.4, 0.01}, {0.6, 0.011}}, false);
  const validation::Snapshot before = validation::snapshot(cdt);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto insert = [&cdt](double x, double y, double tolerance) {
    return [&cdt, x, y, tolerance] { CGAL::insert_on_constraint_2(cdt, point<TypeParam>(x, y), tolerance); };
  };
  expect_invalid(insert(0.3, 0, -1), {"tolerance", "-1"});
  expect_invalid(insert(0.3, 0, nan), {"tolerance", "nan"});
  expect_invalid(insert(0.3, 0.06, 0.07), {"(0.3, 0.06)", "in the way"});
  EXPECT_TRUE(validation::snapshot(cdt) == before); // a constraint would have come out of the square
  domains::insert(cdt, {{0.7, 0.01}, {0.7, 0.5}}, false);
  const validation::Snapshot crossed = validation::snapshot(cdt);
  expect_invalid(insert(0.3, 0.06, 0.07), {"(0.3, 0.06)", "in the way"});
  EXPECT_TRUE(validation::snapshot(cdt) == crossed);
  EXPECT_TRUE(cdt.is_valid());
  TypeParam line;
  line.insert_constraint(point<TypeParam>(0, 0), point<TypeParam>(1, 1));
  expect_invalid([&line] { CGAL::insert_on_constraint_2(line, point<TypeParam>(0.3, 0.3)); }, {"faces"});
}

TYPED_TEST(Insert_on_constraint, both_parts_have_the_marker)
{
  using Vertex_handle = typename TypeParam::Vertex_handle;
  TypeParam cdt = domains::make<TypeParam>({slanted});
  CGAL::Constraint_marker_map_2<TypeParam> markers;
  const Vertex_handle a = cdt.insert(point<TypeParam>(0, 0.1)), b = cdt.insert(point<TypeParam>(0.97, 0));
  markers.set(cdt, a, b, 5);
  const Vertex_handle v = CGAL::insert_on_constraint_2(cdt, point<TypeParam>(0.97 / 3, 0.1 * 2 / 3), 0,
                                                       CGAL::parameters::edge_marker_map(markers));
  EXPECT_EQ(get(markers, CGAL::make_sorted_pair(a, v)), 5);
  EXPECT_EQ(get(markers, CGAL::make_sorted_pair(v, b)), 5);
  EXPECT_EQ(get(markers, CGAL::make_sorted_pair(a, b)), 0);
}

TEST(Insert_on_constraint, not_finite_is_refused)
{
  domains::CDT cdt = domains::make({slanted});
  expect_invalid([&] { CGAL::insert_on_constraint_2(cdt, K::Point_2(std::numeric_limits<double>::infinity(), 0)); },
                 {"inf"});
  expect_invalid([&] { CGAL::insert_on_constraint_2(cdt, K::Point_2(1e91, 0)); }, {"1e+91"});
  domains::CDT tiny = domains::make({{{0, 0.1e-170}, {1e-170, 0}, {0.1e-170, 1e-170}}});
  expect_invalid([&] { CGAL::insert_on_constraint_2(tiny, K::Point_2(0.5e-170, 0.05e-170)); }, {"length", "5e-171"});
}

TEST(Insert_on_constraint, a_constraint_with_an_identifier_stays_one)
{
  Plus cdt = domains::make<Plus>({slanted});
  const auto id = cdt.insert_constraint(K::Point_2(0.2, 0.3), K::Point_2(0.8, 0.7));
  const auto v = CGAL::insert_on_constraint_2(cdt, K::Point_2(0.2 + 0.6 / 3, 0.3 + 0.4 / 3));
  ASSERT_EQ(std::distance(cdt.vertices_in_constraint_begin(id), cdt.vertices_in_constraint_end(id)), 3);
  EXPECT_EQ(*std::next(cdt.vertices_in_constraint_begin(id)), v);
}

TEST(Insert_on_constraint, elevations_do_not_count)
{
  using Terrain = domains::Cdt_of<CGAL::Projection_traits_xy_3<K>>;
  Terrain cdt;
  std::vector<Terrain::Vertex_handle> corners;
  for (const auto& [x, y] : slanted)
    corners.push_back(cdt.insert(K::Point_3(x, y, 100 * x)));
  for (std::size_t i = 0; i < corners.size(); ++i)
    cdt.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  std::mt19937 random(3);
  for (const auto& [x, y] : places_on(slanted, 10, random)) {
    const auto v = CGAL::insert_on_constraint_2(cdt, K::Point_3(x, y, -7));
    EXPECT_EQ(number_of_constraints_at(cdt, v), 2u);
    EXPECT_EQ(v->point().z(), -7);
  }
  EXPECT_TRUE(cdt.is_valid());
}

} // namespace test_insert_on_constraint
