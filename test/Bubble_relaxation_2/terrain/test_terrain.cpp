// Copyright (c) 2026 The Bubble_relaxation_2 authors.
//
// This file is part of Bubble_relaxation_2, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Bubble_relaxation_2 authors

// Terrains: triangulations of points in space that are seen along an axis. Their meshes are those of the projection,
// and new vertices get elevations.

#include "expect_throw.h"
#include "terrains.h"

#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Interpolated_elevation_2.h>
#include <CGAL/Interpolated_sizing_field_2.h>
#include <CGAL/Mesh_quality_2.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Projection_traits_xz_3.h>
#include <CGAL/Projection_traits_yz_3.h>
#include <CGAL/node_set_2.h>
#include <CGAL/npbs_adapt.h>
#include <CGAL/npbs_place_nodes.h>
#include <CGAL/npbs_relax.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_terrain {

namespace P = CGAL::parameters;
using namespace terrains;
using domains::Cdt_of;

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <class V>
class Terrains : public testing::Test
{};

using Plus = CGAL::Constrained_triangulation_plus_2<Terrain>;
using Xy = View<Terrain, 0, 1, 2>;
using Xy_plus = View<Plus, 0, 1, 2, CGAL::Constrained_triangulation_plus_2<domains::CDT>>;
using Xy_exact = View<Cdt_of<CGAL::Projection_traits_xy_3<Exact>>, 0, 1, 2, Cdt_of<Exact>>;

template <class V>
class Terrains_along_axes : public testing::Test
{};

// which coordinates count is seen by two tests; what else is done to terrains is seen along the z-axis
using Axes = testing::Types<View<Cdt_of<CGAL::Projection_traits_yz_3<K>>, 1, 2, 0>,
                            View<Cdt_of<CGAL::Projection_traits_xz_3<K>>, 0, 2, 1>>;

template <class V>
void expect_the_mesh_of_the_plane()
{
  using Flat = typename V::Flat;
  for (bool is_scattered : {false, true}) {
    auto terrain = make_terrain<V>(hill, is_scattered);
    auto flat = make<Flat>([](double x, double y) { return typename Flat::Point(x, y); }, is_scattered);
    ASSERT_EQ(mesh_of<V>(terrain), mesh_of_flat(flat));
    CGAL::npbs_relax(terrain, P::sizing_function(growing));
    CGAL::npbs_relax(flat, P::sizing_function(growing));
    EXPECT_EQ(mesh_of<V>(terrain), mesh_of_flat(flat));
    const auto finer = [](const auto& p) { return p.x() > 0 ? 0.05 : CGAL::to_double(growing(p)); };
    CGAL::npbs_adapt(terrain, P::sizing_function(finer));
    CGAL::npbs_adapt(flat, P::sizing_function(finer));
    EXPECT_EQ(mesh_of<V>(terrain), mesh_of_flat(flat));
    EXPECT_TRUE(terrain.is_valid());
    EXPECT_EQ(CGAL::mesh_quality_2(terrain).mean_quality(), CGAL::mesh_quality_2(flat).mean_quality());
  }
}

template <class V>
void expect_that_new_vertices_lie_on_the_old_surface()
{
  const auto before = make_terrain<V>(hill);
  auto terrain = before;
  CGAL::npbs_relax(terrain, P::sizing_function(growing));
  const CGAL::Interpolated_elevation_2<typename V::Cdt> surface(before);
  using Point_2 = typename CGAL::Interpolated_elevation_2<typename V::Cdt>::Point_2;
  const auto old = elevations<V>(before);
  std::size_t kept = 0;
  for (const auto& [p, z] : elevations<V>(terrain)) {
    EXPECT_NEAR(z, CGAL::to_double(surface(Point_2(p.first, p.second))), 1e-14);
    const auto found = old.find(p);
    if (found == old.end())
      continue;
    EXPECT_EQ(z, found->second); // corners, ends of constraints, and what lies outside
    ++kept;
  }
  EXPECT_GE(kept, 15u);
}

TYPED_TEST_SUITE(Terrains_along_axes, Axes);

TYPED_TEST(Terrains_along_axes, has_the_mesh_of_the_plane_to_the_bit) { expect_the_mesh_of_the_plane<TypeParam>(); }

TYPED_TEST(Terrains_along_axes, new_vertices_lie_on_the_old_surface)
{
  expect_that_new_vertices_lie_on_the_old_surface<TypeParam>();
}

using Views = testing::Types<Xy, Xy_plus, Xy_exact>;
TYPED_TEST_SUITE(Terrains, Views);

TYPED_TEST(Terrains, has_the_mesh_of_the_plane_to_the_bit) { expect_the_mesh_of_the_plane<TypeParam>(); }

TYPED_TEST(Terrains, plane_surface_stays_plane)
{
  auto terrain = make_terrain<TypeParam>(plane);
  CGAL::npbs_relax(terrain, P::sizing_function(growing));
  EXPECT_LE(largest_error<TypeParam>(terrain, plane), 4e-15);
  CGAL::npbs_adapt(terrain, P::sizing_function(0.05));
  EXPECT_LE(largest_error<TypeParam>(terrain, plane), 4e-15);
}

TYPED_TEST(Terrains, new_vertices_lie_on_the_old_surface)
{
  expect_that_new_vertices_lie_on_the_old_surface<TypeParam>();
}

TYPED_TEST(Terrains, elevation_function_is_used_for_new_vertices_only)
{
  const auto before = make_terrain<TypeParam>(plane, false);
  auto terrain = before;
  std::size_t calls = 0;
  const auto f = [&calls](const auto& p) {
    ++calls;
    return hill(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  };
  CGAL::npbs_relax(terrain, P::elevation_function(f).sizing_function(growing));
  const auto old = elevations<TypeParam>(before);
  std::size_t n = 0;
  for (const auto& [p, z] : elevations<TypeParam>(terrain)) {
    const auto found = old.find(p);
    EXPECT_NEAR(z, found == old.end() ? hill(p.first, p.second) : found->second, 1e-15);
    n += found == old.end();
  }
  EXPECT_EQ(calls, n);
  const auto between = elevations<TypeParam>(terrain);
  const double up = 10; // vertices that stay when a part is meshed anew keep their elevations
  CGAL::npbs_adapt(terrain, P::sizing_function(0.05).elevation_function([](const auto&) { return 10; }));
  std::size_t raised = 0;
  for (const auto& [p, z] : elevations<TypeParam>(terrain)) {
    const auto found = between.find(p);
    EXPECT_EQ(z, found == between.end() ? up : found->second);
    raised += found == between.end();
  }
  EXPECT_GT(raised, 100u);
}

TYPED_TEST(Terrains, exceptions_of_the_elevation_function_change_nothing)
{
  auto terrain = make_terrain<TypeParam>(plane);
  const auto expect_unchanged_by = [&](const auto& mesh) {
    const Mesh before = mesh_of<TypeParam>(terrain);
    const auto old = elevations<TypeParam>(terrain);
    std::vector<typename TypeParam::Cdt::Vertex_handle> handles;
    for (const auto v : terrain.finite_vertex_handles())
      handles.push_back(v);
    EXPECT_THROW(mesh(), std::domain_error);
    EXPECT_EQ(mesh_of<TypeParam>(terrain), before);
    EXPECT_EQ(elevations<TypeParam>(terrain), old);
    std::size_t k = 0;
    for (typename TypeParam::Cdt::Vertex_handle v : terrain.finite_vertex_handles())
      EXPECT_EQ(&*handles[k++], &*v);
    EXPECT_TRUE(terrain.is_valid());
  };
  int calls = 0;
  const auto late = [&calls](const auto&) {
    if (++calls == 40)
      throw std::domain_error("no elevation here");
    return 1.;
  };
  expect_unchanged_by([&] { CGAL::npbs_relax(terrain, P::sizing_function(0.1).elevation_function(late)); });
  CGAL::npbs_relax(terrain, P::sizing_function(0.1));
  const auto always_failing = [](const auto&) -> double { throw std::domain_error("none"); };
  expect_unchanged_by([&] { CGAL::npbs_adapt(terrain, P::sizing_function(0.05).elevation_function(always_failing)); });
}

TYPED_TEST(Terrains, nodes_have_elevations)
{
  const auto terrain = make_terrain<TypeParam>(plane);
  const auto check = [](const auto& nodes) {
    EXPECT_GT(nodes.size(), 200u);
    for (const auto& p : nodes.points)
      EXPECT_NEAR(TypeParam::elevation(p), plane(TypeParam::x(p), TypeParam::y(p)), 4e-15);
  };
  check(CGAL::npbs_place_nodes(terrain, P::sizing_function(0.1)));
  check(CGAL::node_set_2(terrain));
}

// what is straight in the plane need not be so in space: new vertices of a constraint follow its profile
TEST(Terrain, constraints_keep_their_profile)
{
  Terrain terrain;
  const auto profile = [](double x) { return x < 0.4 ? x : 0.4 - 3 * (x - 0.4); };
  const auto insert = [&](double ax, double ay, double az, double bx, double by, double bz) {
    terrain.insert_constraint(Terrain::Point(ax, ay, az), Terrain::Point(bx, by, bz));
  };
  insert(0, 0, profile(0), 0.4, 0, profile(0.4)); // it splits the side: it may go
  insert(0.4, 0, profile(0.4), 1, 0, profile(1));
  insert(1, 0, profile(1), 1, 1, 50);
  insert(1, 1, 50, 0, 1, -50);
  insert(0, 1, -50, 0, 0, 0);
  CGAL::npbs_relax(terrain, P::sizing_function(0.03));
  std::size_t n = 0;
  for (const auto& [p, z] : elevations<Xy>(terrain))
    if (p.second == 0) {
      EXPECT_NEAR(z, profile(p.first), 1e-14);
      ++n;
    }
  EXPECT_GE(n, 30u);
}

// by roundings bubbles of a slanted edge lie beside it, where the next face is as steep as a wall
TEST(Terrain, walls_do_not_matter_to_constraints)
{
  Terrain terrain;
  const double thickness = 1e-13;
  const Terrain::Point a(0, 0, 1), b(1, 0.3, 1), c(0.7, 1.3, 1), d(-0.3, 1, 1);
  for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
    terrain.insert_constraint(p, q);
  terrain.insert(Terrain::Point(0.5, 0.15 - thickness, 1e6));
  terrain.insert(Terrain::Point(0.5, -1, 1e6));
  CGAL::npbs_relax(terrain, P::sizing_function(0.05));
  for (const auto& [p, z] : elevations<Xy>(terrain))
    if (p.first != 0.5) {
      EXPECT_NEAR(z, 1, 1e-13) << p.first << ' ' << p.second;
    }
}

TEST(Terrain, surface_of_a_copy_outlives_many_calls)
{
  const auto before = make_terrain<Xy>(hill);
  auto terrain = before;
  const CGAL::Interpolated_elevation_2<Terrain> surface(before);
  CGAL::npbs_relax(terrain, P::sizing_function(0.15));
  for (double at : {-0.5, 0., 0.5}) {
    const auto d = [at](const K::Point_2& p) { return 0.05 + 0.1 * std::abs(p.x() - at); };
    CGAL::npbs_adapt(terrain, P::elevation_function(surface).sizing_function(d));
  }
  EXPECT_LE(largest_error<Xy>(terrain, [&](double x, double y) { return surface({x, y}); }), 1e-14);
}

// where all is domain, triangles are written as they are
TEST(Terrain, with_nothing_outside)
{
  auto flat = domains::make<domains::CDT>({domains::square(0, 0, 1)});
  Terrain cdt;
  for (const auto& e : flat.finite_edges())
    if (flat.is_constrained(e)) {
      const auto point = [&](int i) {
        const auto& p = e.first->vertex(i)->point();
        return Terrain::Point(p.x(), p.y(), plane(p.x(), p.y()));
      };
      cdt.insert_constraint(point(flat.cw(e.second)), point(flat.ccw(e.second)));
    }
  CGAL::npbs_relax(cdt, P::sizing_function(growing));
  CGAL::npbs_relax(flat, P::sizing_function(growing));
  EXPECT_EQ(mesh_of<Xy>(cdt), mesh_of_flat(flat));
  EXPECT_LE(largest_error<Xy>(cdt, plane), 2e-15);
  EXPECT_TRUE(cdt.is_valid());
}

TEST(Terrain, does_not_depend_on_the_order_of_insertion)
{
  const auto there = make_terrain<Xy>(hill);
  Terrain back;
  std::vector<Terrain::Point> points;
  for (const auto v : there.finite_vertex_handles())
    points.push_back(v->point());
  std::reverse(points.begin(), points.end());
  for (const auto& p : points)
    back.insert(p);
  for (const auto& e : there.finite_edges())
    if (there.is_constrained(e))
      back.insert_constraint(e.first->vertex(there.cw(e.second))->point(), e.first->vertex(there.ccw(e.second))->point());
  Terrain first = there;
  CGAL::npbs_relax(first, P::sizing_function(growing));
  CGAL::npbs_relax(back, P::sizing_function(growing));
  EXPECT_EQ(elevations<Xy>(first), elevations<Xy>(back));
}

TEST(Terrain, relaxed_without_a_size_keeps_its_surface)
{
  auto terrain = make_terrain<Xy>(plane);
  CGAL::npbs_relax(terrain);
  EXPECT_LE(largest_error<Xy>(terrain, plane), 4e-15);
}

TEST(Terrain, sizes_and_seeds)
{
  const auto sizes = [](Terrain::Vertex_handle v) { return 0.05 + 0.02 * v->point().z(); };
  const auto before = make_terrain<Xy>(hill);
  std::map<Terrain::Vertex_handle, double> map;
  for (const auto v : before.finite_vertex_handles())
    map[v] = sizes(v);
  const CGAL::Interpolated_sizing_field_2<Terrain> d(before, boost::make_assoc_property_map(map));
  auto by_place = make_terrain<Xy>(hill), by_point = by_place;
  const std::vector<K::Point_2> places{{0.4, 0.5}};
  const std::vector<Terrain::Point> points{{0.4, 0.5, 99}};
  CGAL::npbs_relax(by_place, P::sizing_function(d).seeds(places));
  CGAL::npbs_relax(by_point, P::sizing_function(d).seeds(points));
  EXPECT_EQ(mesh_of<Xy>(by_place), mesh_of<Xy>(by_point));
  EXPECT_GT(by_place.number_of_vertices(), 600u);
}

TEST(Terrain, elevations_that_are_not_finite)
{
  auto terrain = make_terrain<Xy>(plane);
  const auto before = elevations<Xy>(terrain);
  const auto nan = [](const K::Point_2&) { return std::numeric_limits<double>::quiet_NaN(); };
  expect_invalid([&] { CGAL::npbs_relax(terrain, P::sizing_function(0.1).elevation_function(nan)); },
                 {"elevation", "nan", "finite"});
  EXPECT_EQ(elevations<Xy>(terrain), before);
}

TEST(Terrain, interpolated_elevation)
{
  EXPECT_THROW(CGAL::Interpolated_elevation_2<Terrain>{Terrain()}, std::invalid_argument);
  Terrain terrain;
  for (const auto& p : {Terrain::Point(0, 0, 1), Terrain::Point(2, 0, 3), Terrain::Point(0, 2, 5)})
    terrain.insert(p);
  const CGAL::Interpolated_elevation_2<Terrain> z(terrain);
  EXPECT_EQ(z({0, 2}), 5);
  EXPECT_EQ(z({1, 0}), 2);
  EXPECT_EQ(z({0.5, 0.5}), 2.5);
  EXPECT_EQ(z({1, -1}), 2);  // the nearest point of the hull
  EXPECT_EQ(z({4, -1}), 3);
}

} // namespace test_terrain
